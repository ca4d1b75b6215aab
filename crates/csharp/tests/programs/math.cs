using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        Console.WriteLine(Math.Round(2.6) + " " + Math.Round(3.5) + " " + Math.Round(-2.4) + " " + Math.Round(2.345, 2) + " " + Math.Round(2.5, MidpointRounding.AwayFromZero) + " " + Math.Round(1.005, 2));
        Console.WriteLine(Math.Floor(-1.5) + " " + Math.Ceiling(-1.5) + " " + Math.Truncate(-1.5) + " " + Math.Abs(-3) + " " + Math.Abs(-3.5) + " " + Math.Sign(-2.0) + " " + Math.Max(1, 2.5) + " " + Math.Min(3, 4));
        Console.WriteLine(Math.Sqrt(2) + " " + Math.Pow(2, 10) + " " + Math.Sin(1) + " " + Math.Atan2(1, -1) + " " + Math.Log(10) + " " + Math.Log(8, 2) + " " + Math.Log10(1000) + " " + Math.Exp(1) + " " + Math.Tan(0.5) + " " + Math.Acos(0.3));
        Console.WriteLine(double.IsNaN(Math.Sqrt(-1)) + " " + 1 / 0.0 + " " + (0.0 / 0.0 == 0.0 / 0.0));
        try { int z = 0; Console.WriteLine(1 / z); } catch (DivideByZeroException e) { Console.WriteLine(e.Message); }
        Console.WriteLine((int)3.99 + " " + (int)-3.99 + " " + (long)1e18 + " " + 5.5 % 2 + " " + -5.5 % 2);
    }
}
