// Conversions between decimals and other numbers.
using System;
class P
{
    static string Try(Func<object> f)
    {
        try { return f().ToString(); }
        catch (OverflowException e) { return e.Message; }
    }
    static void Main()
    {
        var r = new Random(7);
        for (int i = 0; i < 200; i++)
        {
            double x = (r.NextDouble() - 0.5) * double.Parse("1E" + r.Next(-30, 31));
            float f = (float)x;
            Console.WriteLine(Try(() => (decimal)x) + " " + Try(() => (decimal)f));
        }
        foreach (double x in new double[] { 0, 0.5, 1e-28, 1e-29, 4.5e-29, 7.9e28, 8e28, 1e29, double.NaN, double.PositiveInfinity, 123456789012345.678, 99999999999999.95, 1e14, 1e15, -2.5 })
            Console.WriteLine(Try(() => (decimal)x));
        var d = new Random(8);
        for (int i = 0; i < 200; i++)
        {
            decimal x = new decimal(d.Next(), i % 3 == 0 ? d.Next() : 0, i % 5 == 0 ? d.Next() : 0, d.Next(2) == 0, (byte)d.Next(29));
            Console.WriteLine((double)x + " " + (float)x + " " + Try(() => (int)x) + " " + Try(() => (long)x) + " " + Try(() => (byte)x) + " " + Try(() => (ulong)x) + " " + Convert.ToDouble(x));
        }
        int n = 7; long big = long.MaxValue; ulong most = ulong.MaxValue; char c = 'A'; sbyte small = -3;
        decimal sum = n; sum += big; sum += most; sum += c; sum += small;
        Console.WriteLine(sum);
        Console.WriteLine((decimal)DayOfWeek.Friday + " " + (DayOfWeek)2m);
        decimal? maybe = 3; maybe += 1.5m; Console.WriteLine(maybe + " " + (maybe > 4) + " " + maybe.HasValue); maybe = null; Console.WriteLine((maybe + 1) == null);
        object o = 2.50m; Console.WriteLine((decimal)o + 1 + " " + o.GetType() + " " + (o is decimal) + " " + (o is double) + " " + o.Equals(2.5m) + " " + o.Equals(2.5));
        try { Console.WriteLine((double)o); } catch (InvalidCastException e) { Console.WriteLine(e.Message); }
        Console.WriteLine(Convert.ToDecimal("1.50") + " " + Convert.ToDecimal(2.25) + " " + Convert.ToDecimal(true) + " " + Convert.ToInt32(2.5m) + " " + Convert.ToInt32(3.5m) + " " + Convert.ToString(1.20m));
        Console.WriteLine(string.Join(",", decimal.GetBits(-1.50m)) + " " + new decimal(5) + " " + new decimal(2.5) + " " + new decimal(1, 2, 3, true, 4));
        Console.WriteLine(sizeof(decimal) + " " + default(decimal) + " " + typeof(decimal) + " " + decimal.MaxValue + " " + decimal.MinValue + " " + decimal.One);
    }
}
