using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        double[] v = { 0.5, 1.5, 2.5, -0.5, -1.5, 2.675, 1.005, 1234.5678, -1234.5678, 0.125, 0.375, 1e15 + 0.5, double.NaN, double.PositiveInfinity };
        foreach (double d in v) Console.WriteLine(Math.Round(d) + " " + Math.Round(d, 2) + " " + Math.Round(d, MidpointRounding.AwayFromZero) + " " + Math.Round(d, 1, MidpointRounding.AwayFromZero) + " " + Math.Floor(d) + " " + Math.Ceiling(d) + " " + Math.Truncate(d));
        Console.WriteLine(Math.Abs(-5) + " " + Math.Sign(-2.5) + " " + Math.Max(1, 2.5) + " " + Math.Min(-1L, 2) + " " + Math.Pow(2, 10) + " " + Math.Sqrt(-1) + " " + Math.Log(Math.E) + " " + Math.Log10(1000) + " " + Math.Log(8, 2) + " " + Math.Exp(0) + " " + Math.Atan2(1, 1) + " " + Math.Sin(Math.PI / 6) + " " + Math.Cosh(1) + " " + Math.IEEERemainder(7, 4) + " " + Math.BigMul(100000, 100000)); int rem; Console.WriteLine(Math.DivRem(17, 5, out rem) + " " + rem); try { Math.Abs(int.MinValue); } catch (OverflowException) { Console.WriteLine("of"); } Console.WriteLine(5 / 2 + " " + -5 / 2 + " " + 5 % -3 + " " + -5 % 3 + " " + 5.5 % 2 + " " + -5.5 % 2 + " " + 1.0 / 0 + " " + -1.0 / 0 + " " + 0.0 / 0 + " " + (0.1 + 0.2 == 0.3) + " " + (float)0.1 + " " + (double)0.1f + " " + 1e300 * 1e10 + " " + double.Epsilon + " " + float.MaxValue + " " + 1f / 3 + " " + 2.0 / 3 + " " + 100.0 + " " + 1e5 + " " + 1e-5 + " " + 123456789012345678.0 + " " + 0.1f * 3); Console.WriteLine(double.IsNaN(0.0 / 0) + " " + (double.NaN == double.NaN) + " " + double.NaN.Equals(double.NaN) + " " + (0.0 == -0.0) + " " + double.IsInfinity(1 / 0.0) + " " + double.NaN.CompareTo(1) + " " + double.MaxValue + " " + int.MaxValue + " " + long.MinValue + " " + Convert.ToInt32(2.5) + Convert.ToInt32(3.5) + Convert.ToInt32("12") + Convert.ToDouble("1.5") + Convert.ToBoolean(1) + Convert.ToString(255, 16) + Convert.ToInt32("ff", 16) + Convert.ToChar(65) + Convert.ToByte(3.7));
    }
}
