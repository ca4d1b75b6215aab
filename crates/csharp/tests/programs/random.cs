using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        foreach (int seed in new[] { 0, 1, 42, -7, 123456 }) { var r = new Random(seed); Console.WriteLine(r.Next() + " " + r.Next(10) + " " + r.Next(-5, 5) + " " + r.NextDouble() + " " + r.Next(int.MinValue, int.MaxValue)); var b = new byte[4]; r.NextBytes(b); Console.WriteLine(string.Join(",", b)); }
    }
}
