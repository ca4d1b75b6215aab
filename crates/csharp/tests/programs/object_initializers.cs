using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P { public int X, Y; public List<int> L = new List<int>(); public Dictionary<string, int> D = new Dictionary<string, int>(); public P Q { get; set; } public int[] A; }

static class Program
{
    static void Main()
    {
        var p = new P { X = 1, Y = 2, L = { 1, 2 }, D = { { "a", 1 } }, Q = new P { X = 9, L = { 7 } }, A = new[] { 4 } }; Console.WriteLine(p.X + p.Y + p.L.Count + p.D["a"] + p.Q.X + p.Q.L[0] + p.A[0]); var d = new Dictionary<string, P> { ["k"] = new P { X = 3 } }; Console.WriteLine(d["k"].X); var ll = new List<int[]> { new[] { 1, 2 }, new int[3] }; Console.WriteLine(ll[1].Length); var anon = new { p.X, Name = "n", In = new { Z = 1.5 } }; Console.WriteLine(anon.X + anon.Name + anon.In.Z); var arr = new[] { new { A = 1 }, new { A = 2 } }; Console.WriteLine(arr.Sum(q => q.A));
    }
}
