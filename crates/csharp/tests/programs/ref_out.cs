using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class R { public static void Swap<T>(ref T a, ref T b) { T t = a; a = b; b = t; } public static bool Div(int a, int b, out int q, out int r) { if (b == 0) { q = r = 0; return false; } q = a / b; r = a % b; return true; } public static void Inc(ref int x) { x++; } public static int Sum(params int[] xs) { int s = 0; foreach (int x in xs) s += x; return s; } public static string Opt(int a, int b = 2, string c = "c") { return a + "," + b + "," + c; } }
class F { public int N = 1; }

static class Program
{
    static void Main()
    {
        int x = 1, y = 2; R.Swap(ref x, ref y); Console.WriteLine(x + " " + y); int q, r; Console.WriteLine(R.Div(17, 5, out q, out r) + " " + q + " " + r); if (R.Div(9, 2, out int q2, out var r2)) Console.WriteLine(q2 + " " + r2); int[] arr = { 1, 2 }; R.Inc(ref arr[1]); Console.WriteLine(arr[1]); var f = new F(); R.Inc(ref f.N); Console.WriteLine(f.N); Console.WriteLine(R.Sum() + " " + R.Sum(1) + " " + R.Sum(1, 2, 3) + " " + R.Sum(new[] { 4, 5 })); Console.WriteLine(R.Opt(1) + " " + R.Opt(1, 5) + " " + R.Opt(1, c: "z") + " " + R.Opt(b: 9, a: 8)); string s1 = "a", s2 = "b"; R.Swap(ref s1, ref s2); Console.WriteLine(s1 + s2);
    }
}
