using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Ext { public static double Sq(this double x) { return x * x; } public static string Rep(this string s, int n) { return string.Join("", Enumerable.Repeat(s, n)); } public static T Second<T>(this IEnumerable<T> s) { return s.Skip(1).First(); } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(1.5.Sq() + " " + "ab".Rep(3) + " " + new[] { 1, 2, 3 }.Second() + " " + new List<string> { "a", "b" }.Second());
    }
}
