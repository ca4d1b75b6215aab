using System;
class P {
    static void Main() {
        long sum = 0;
        for (var d = new DateTime(1896, 1, 1); d.Year < 1906; d = d.AddDays(1)) sum = sum * 31 + d.Year + d.Month * 3 + d.Day * 5 + d.DayOfYear * 7 + (int)d.DayOfWeek;
        for (long t = 0; t < DateTime.MaxValue.Ticks - 864000000000 * 97; t += 864000000000 * 97) { var d = new DateTime(t); sum = sum * 31 + d.Year + d.Month * 3 + d.Day * 5; if (new DateTime(d.Year, d.Month, d.Day).Ticks != t) Console.WriteLine(t); }
        Console.WriteLine(sum);
        Console.WriteLine(DateTime.MinValue + " " + DateTime.MaxValue + " " + DateTime.MaxValue.Ticks + " " + DateTime.MaxValue.Year + " " + DateTime.MaxValue.Day);
        var a = new DateTime(2024, 2, 29, 13, 5, 9, 70);
        foreach (var f in new[] { "d", "D", "t", "T", "f", "F", "g", "G", "M", "Y", "R", "s", "u", "o", "yyyy-MM-dd HH:mm:ss.fff", "yy M d h m s", "ddd dddd MMM MMMM", "hh:mm tt", "%h", "h t", "H\\h 'quoted d' \"m\"", "fffffff", "ss.FFF", "ss.FFFFF", "yyyyMMdd_HHmmss", "gg", "%K", "yyyyy" })
            Console.WriteLine(f + " = " + a.ToString(f));
        Console.WriteLine(new DateTime(2024, 1, 1, 0, 0, 0).ToString("hh.FFF ss.FFF") + " " + new DateTime(2024, 1, 1, 0, 0, 1, DateTimeKind.Utc).ToString("o"));
        Console.WriteLine(a.AddYears(1) + " " + a.AddMonths(-13) + " " + a.AddMonths(10) + " " + a.AddDays(1.5) + " " + a.AddHours(-14) + " " + a.AddSeconds(0.0006).Ticks + " " + a.AddMilliseconds(-1).Ticks);
        Console.WriteLine((a - new DateTime(2000, 1, 1)) + " " + (a - TimeSpan.FromDays(60)) + " " + (a + new TimeSpan(1, 2, 3)) + " " + a.Date + " " + a.TimeOfDay + " " + a.Kind);
        Console.WriteLine((a < a.AddTicks(1)) + " " + (a == a.AddTicks(0)) + " " + a.CompareTo(DateTime.MinValue) + " " + DateTime.DaysInMonth(1900, 2) + DateTime.DaysInMonth(2000, 2) + DateTime.DaysInMonth(2023, 12) + " " + DateTime.IsLeapYear(2100));
        Console.WriteLine(string.Format("{0:yyyy}|{0,12:MM-dd}|", a) + $"{a:HH:mm}" + " " + a.ToShortDateString() + " " + a.ToLongTimeString() + " " + a.DayOfWeek);
        try { new DateTime(2023, 2, 29); } catch (ArgumentOutOfRangeException e) { Console.WriteLine(e.Message); }
        try { new DateTime(2023, 2, 2, 24, 0, 0); } catch (ArgumentOutOfRangeException e) { Console.WriteLine(e.Message); }
        try { DateTime.MaxValue.AddDays(1); } catch (ArgumentOutOfRangeException) { Console.WriteLine("too late"); }
        try { DateTime.MinValue.AddMonths(-1); } catch (ArgumentOutOfRangeException) { Console.WriteLine("too early"); }
        try { a.ToString("q"); } catch (FormatException) { Console.WriteLine("no format"); }
        try { a.ToString("'x"); } catch (FormatException) { Console.WriteLine("no quote"); }
    }
}
