using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        var a = new { X = 1, Y = "s" }; Console.WriteLine(a); Console.WriteLine(a.X + a.Y); var b = new { X = 1, Y = "s" }; Console.WriteLine(a.Equals(b) + " " + (a.GetHashCode() == b.GetHashCode()) + " " + (a == b)); int Z = 5; var c = new { Z, Len = "abc".Length, N = new { Q = 1.5 } }; Console.WriteLine(c); var arr = new[] { new { K = 1, V = "a" }, new { K = 2, V = "b" } }; Console.WriteLine(arr.Sum(t => t.K) + string.Concat(arr.Select(t => t.V))); var g = new[] { "aa", "b", "cc" }.GroupBy(s => new { s.Length, F = s[0] == 'a' }).Select(q => q.Key + ":" + q.Count()); foreach (var s in g) Console.WriteLine(s); var d = arr.ToDictionary(t => new { t.K }, t => t.V); Console.WriteLine(d[new { K = 2 }]); object o = new { E = (string)null, D = new int[0].Length }; Console.WriteLine(o);
    }
}
