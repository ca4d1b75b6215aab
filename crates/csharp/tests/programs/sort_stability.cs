using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class It { public int K; public string N; }

static class Program
{
    static void Main()
    {
        var l = new List<It>(); var r = new Random(3); for (int i = 0; i < 60; i++) l.Add(new It { K = r.Next(8), N = "n" + i }); Console.WriteLine(string.Join(" ", l.OrderBy(x => x.K).Select(x => x.N))); l.Sort((a, b) => a.K.CompareTo(b.K)); Console.WriteLine(string.Join(" ", l.Select(x => x.N))); var w = new List<string> { "banana", "Apple", "cherry", "apple", "_x", "10", "9", "Zed", "zed", "a-b", "ab" }; w.Sort(); Console.WriteLine(string.Join(" ", w)); w.Sort(string.CompareOrdinal); Console.WriteLine(string.Join(" ", w)); var d = new[] { 3.5, double.NaN, -1, 2 }; Array.Sort(d); Console.WriteLine(string.Join(" ", d));
    }
}
