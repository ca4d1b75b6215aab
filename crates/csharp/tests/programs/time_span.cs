using System;
class P {
    static void Main() {
        foreach (var t in new[] { TimeSpan.Zero, new TimeSpan(1), new TimeSpan(-1), new TimeSpan(1, 2, 3), new TimeSpan(4, 5, 6, 7), new TimeSpan(4, 25, 66, 77, 888), new TimeSpan(-1, -2, -3, -4, -5), TimeSpan.FromDays(1.5), TimeSpan.FromHours(-0.75), TimeSpan.FromMinutes(90.123), TimeSpan.FromSeconds(0.0014), TimeSpan.FromSeconds(1.0015), TimeSpan.FromMilliseconds(2.5), TimeSpan.MaxValue, TimeSpan.MinValue })
            Console.WriteLine(t + " " + t.Ticks + " " + t.Days + " " + t.Hours + " " + t.Minutes + " " + t.Seconds + " " + t.Milliseconds + " " + t.TotalDays + " " + t.TotalHours + " " + t.TotalMinutes + " " + t.TotalSeconds + " " + t.TotalMilliseconds);
        var a = TimeSpan.FromMinutes(3); var b = TimeSpan.FromSeconds(200);
        Console.WriteLine((a + b) + " " + (a - b) + " " + (-a) + " " + (a < b) + (a >= b) + (a == b) + (a != b) + " " + a.CompareTo(b) + " " + (a - b).Duration());
        try { var x = TimeSpan.MaxValue + new TimeSpan(1); } catch (OverflowException e) { Console.WriteLine(e.Message); }
        try { TimeSpan.FromDays(1e10); } catch (OverflowException e) { Console.WriteLine(e.Message); }
        try { TimeSpan.FromDays(double.NaN); } catch (ArgumentException e) { Console.WriteLine(e.Message); }
        try { new TimeSpan(int.MaxValue, 0, 0, 0); } catch (ArgumentOutOfRangeException) { Console.WriteLine("too long"); }
        object boxed = a; Console.WriteLine(boxed.Equals(new TimeSpan(0, 3, 0)) + " " + boxed);
    }
}
