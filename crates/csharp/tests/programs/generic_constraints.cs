using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

interface IHas { int V { get; } } class H : IHas, IComparable<H> { public int V { get; set; } public int CompareTo(H o) { return V - o.V; } } static class G { public static T Best<T>(IEnumerable<T> s) where T : class, IHas { T b = null; foreach (var x in s) if (b == null || x.V > b.V) b = x; return b; } public static bool In<T>(T v, params T[] s) { return s.Contains(v); } public static T[] Fill<T>(int n, Func<int, T> f) { var a = new T[n]; for (int i = 0; i < n; i++) a[i] = f(i); return a; } public static void Sort<T>(List<T> l) where T : IComparable<T> { for (int i = 0; i < l.Count; i++) for (int j = i + 1; j < l.Count; j++) if (l[j].CompareTo(l[i]) < 0) { T t = l[i]; l[i] = l[j]; l[j] = t; } } } class Cache<K, V> where V : new() { Dictionary<K, V> d = new Dictionary<K, V>(); public V Get(K k) { V v; if (!d.TryGetValue(k, out v)) { v = new V(); d[k] = v; } return v; } public int N { get { return d.Count; } } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(G.Best(new[] { new H { V = 3 }, new H { V = 8 } }).V); Console.WriteLine(G.In(3, 1, 2, 3) + " " + G.In("x", "y")); Console.WriteLine(string.Join(",", G.Fill(4, i => i * i))); var l = new List<H> { new H { V = 5 }, new H { V = 1 } }; G.Sort(l); Console.WriteLine(l[0].V); var c = new Cache<string, List<int>>(); c.Get("a").Add(1); c.Get("a").Add(2); c.Get("b"); Console.WriteLine(c.Get("a").Count + " " + c.N);
    }
}
