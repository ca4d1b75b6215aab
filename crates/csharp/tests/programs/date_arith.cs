using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        var c = System.Globalization.CultureInfo.InvariantCulture; var d = new DateTime(2024, 2, 28, 23, 30, 15, 250); string[] f = { "d", "D", "t", "T", "f", "F", "g", "G", "M", "s", "u", "o", "R", "Y", "yyyy-MM-dd", "dd/MM/yy", "ddd d MMM", "dddd, MMMM d", "h:mm tt", "HH:mm:ss.fff", "yyyyMMddHHmmss", "%d", "'on' dd", "y M d H m s" }; foreach (string s in f) Console.WriteLine(s + " " + d.ToString(s, c)); foreach (double x in new[] { 1, 0.5, -1.25, 400 }) Console.WriteLine(d.AddDays(x).ToString("s", c) + " " + d.AddHours(x).ToString("s", c) + " " + d.AddMinutes(x).ToString("o", c) + " " + d.AddSeconds(x).ToString("o", c)); for (int i = -13; i < 14; i += 5) Console.WriteLine(d.AddMonths(i).ToString("s", c) + " " + d.AddYears(i).ToString("s", c)); Console.WriteLine(d.DayOfWeek + " " + d.DayOfYear + " " + d.Ticks + " " + d.Date.ToString("s", c) + " " + d.TimeOfDay + " " + DateTime.DaysInMonth(2023, 2) + DateTime.IsLeapYear(2000) + DateTime.IsLeapYear(1900)); var e = new DateTime(2020, 1, 1); Console.WriteLine((d - e) + " " + (d > e) + " " + d.CompareTo(e) + " " + (d - e).TotalDays.ToString("F4", c) + " " + e.Equals(new DateTime(2020, 1, 1)) + " " + DateTime.Compare(e, d) + " " + DateTime.MinValue.ToString("s", c) + " " + DateTime.MaxValue.ToString("o", c)); try { new DateTime(2023, 2, 29); } catch (ArgumentOutOfRangeException) { Console.WriteLine("range"); } Console.WriteLine(new DateTime(2024, 12, 31).AddDays(1).ToString("d", c) + (int)d.DayOfWeek); for (int y = 1999; y < 2003; y++) for (int m = 1; m < 13; m += 4) Console.Write(new DateTime(y, m, 13).DayOfWeek.ToString().Substring(0, 2)); Console.WriteLine();
    }
}
