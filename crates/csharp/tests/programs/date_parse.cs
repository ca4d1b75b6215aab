using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        var c = System.Globalization.CultureInfo.InvariantCulture;
        string[] t = { "2020-01-02", "01/02/2020", "1/2/2020 3:04 PM", "2020-01-02T03:04:05", "2 Jan 2020", "Jan 2, 2020", "January 2, 2020 13:14:15", "2020/1/2 1:2:3", "Thursday, 02 January 2020", "02-Jan-2020", "2020-01-02 03:04:05.678", "1/2/20" };
        foreach (string s in t) Console.WriteLine(DateTime.Parse(s, c).ToString("yyyy-MM-dd HH:mm:ss.fff", c));
        foreach (string s in new[] { "x", "13/13/2020", "2020-02-30", "", "25:00" }) { DateTime d; Console.WriteLine(DateTime.TryParse(s, c, System.Globalization.DateTimeStyles.None, out d) + " " + d.Ticks); }
        try { DateTime.Parse("nope", c); } catch (FormatException) { Console.WriteLine("format"); }
        Console.WriteLine(DateTime.ParseExact("20200102", "yyyyMMdd", c).DayOfYear + " " + DateTime.ParseExact("02.01.2020 14-05", "dd.MM.yyyy HH-mm", c).Hour + " " + DateTime.ParseExact("5:07 PM", "h:mm tt", c).Hour + " " + DateTime.ParseExact("Mar 2021", "MMM yyyy", c).Month + " " + DateTime.ParseExact("1-2-99", "d-M-yy", c).Year);
        try { DateTime.ParseExact("2020-1-2", "yyyy-MM-dd", c); } catch (FormatException) { Console.WriteLine("exact"); } DateTime e; Console.WriteLine(DateTime.TryParseExact("12:30", "HH:mm", c, System.Globalization.DateTimeStyles.None, out e) + " " + e.TimeOfDay);
    }
}
