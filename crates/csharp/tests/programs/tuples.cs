using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class T { public static (int min, int max) MinMax(int[] a) { int lo = a[0], hi = a[0]; foreach (int x in a) { if (x < lo) lo = x; if (x > hi) hi = x; } return (lo, hi); } }

static class Program
{
    static void Main()
    {
        var r = T.MinMax(new[] { 3, 1, 4 }); Console.WriteLine(r.min + " " + r.max + " " + r); var (a, b) = T.MinMax(new[] { 9, 7 }); Console.WriteLine(a + b); (a, b) = (b, a); Console.WriteLine(a + " " + b); var t = (1, "x", 2.5); Console.WriteLine(t.Item2 + t.Item3); (string n, int v) u = ("q", 4); u.v++; Console.WriteLine(u); var old = Tuple.Create(1, "z"); Console.WriteLine(old.Item1 + old.Item2 + " " + old); var l = new List<(int, string)> { (2, "b"), (1, "a") }; l.Sort(); Console.WriteLine(l[0].Item2); foreach (var ks in l) Console.Write(ks.Item1 + ks.Item2 + " "); Console.WriteLine((1, 2).Equals((1, 2)));
    }
}
