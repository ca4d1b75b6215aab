using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        double[] xs = { 0, -0.0, 1, -1.5, 0.1, 1.0/3, 2.0/3, 1e15, 1e16, 123456789012345678, 1e-4, 1e-5, 1e-6, 1.5e300, double.MaxValue, double.Epsilon, double.NaN, double.PositiveInfinity, double.NegativeInfinity, 100, 1e5, 0.1+0.2, 4.35, Math.PI };
        foreach (double x in xs) Console.WriteLine(x);
        foreach (double x in xs) Console.WriteLine(x.ToString("R"));
        float[] fs = { 0.1f, 1f/3, 16777217f, 3.4e38f, 1e-10f, 100f };
        foreach (float x in fs) Console.WriteLine(x);
    }
}
