using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class Tree { public int K; public Tree L, R; public void Add(int k) { if (k < K) { if (L == null) L = new Tree { K = k }; else L.Add(k); } else if (R == null) R = new Tree { K = k }; else R.Add(k); } public void Walk(Action<int> f) { if (L != null) L.Walk(f); f(K); R?.Walk(f); } public int Depth() { return 1 + Math.Max(L == null ? 0 : L.Depth(), R == null ? 0 : R.Depth()); } }

static class Program
{
    static void Main()
    {
        var t = new Tree { K = 50 }; var r = new Random(1); for (int i = 0; i < 20; i++) t.Add(r.Next(100)); var l = new List<int>(); t.Walk(l.Add); t.Walk(x => l[0] += 0); Console.WriteLine(string.Join(" ", l)); Console.WriteLine(t.Depth());
    }
}
