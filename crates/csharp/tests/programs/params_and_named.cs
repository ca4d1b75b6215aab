using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { public static string F(string f, params object[] a) { return f + a.Length; } public static string G(int a, int b = 10, params int[] r) { return a + ":" + b + ":" + r.Length; } public static string H(double x = 1, bool y = false, string z = null) { return x + "," + y + "," + (z ?? "null"); } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(A.F("a") + A.F("a", 1) + A.F("a", 1, "b", null) + A.F("a", new object[] { 1, 2 })); Console.WriteLine(A.G(1) + " " + A.G(1, 2) + " " + A.G(1, 2, 3, 4)); Console.WriteLine(A.H() + " " + A.H(y: true) + " " + A.H(2, z: "q"));
    }
}
