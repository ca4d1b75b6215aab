using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class E { public int V; public override bool Equals(object o) { var e = o as E; return e != null && e.V == V; } public override int GetHashCode() { return V; } }
struct Plain { public int A; public string B; }

static class Program
{
    static void Main()
    {
        object o = 5; Console.WriteLine(o.Equals(5) + " " + o.ToString() + " " + o.GetType() + " " + new object().Equals(null)); var h = new HashSet<E> { new E { V = 1 }, new E { V = 1 }, new E { V = 2 } }; Console.WriteLine(h.Count + " " + h.Contains(new E { V = 2 })); var p = new Plain { A = 1, B = "x" }; var q = p; Console.WriteLine(p.Equals(q)); q.A = 2; Console.WriteLine(p.Equals(q)); Console.WriteLine(new { X = 1, Y = "a" } + " " + new { X = 1 }.Equals(new { X = 1 })); Console.WriteLine(new List<int>().GetType() + " " + typeof(Dictionary<string, int[]>) + " " + typeof(int).Name + " " + typeof(int[]).Name); Console.WriteLine(object.ReferenceEquals(p, p) + " " + Equals(1, 1)); string a = "ab", b = "a" + "b"; Console.WriteLine((object)a == (object)b); Console.WriteLine(p);
    }
}
