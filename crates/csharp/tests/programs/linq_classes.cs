using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class Emp { public string N; public string D; public double S; public int A { get; set; } }

static class Program
{
    static void Main()
    {
        var es = new List<Emp> { new Emp { N = "a", D = "x", S = 10, A = 30 }, new Emp { N = "b", D = "y", S = 20, A = 40 }, new Emp { N = "c", D = "x", S = 30, A = 25 }, new Emp { N = "d", D = "y", S = 5, A = 50 } }; foreach (var g in es.GroupBy(e => e.D)) Console.WriteLine(g.Key + " " + g.Average(e => e.S) + " " + g.Max(e => e.A) + " " + string.Join("", g.Select(e => e.N))); Console.WriteLine(es.OrderBy(e => e.A).First().N + es.Where(e => e.S > 8).Sum(e => e.S) + es.Any(e => e.A > 45) + es.Min(e => e.S)); var look = es.ToLookup(e => e.D); Console.WriteLine(look["x"].Count()); var dict = es.ToDictionary(e => e.N, e => e.S); Console.WriteLine(dict.Values.Sum() + " " + dict.Keys.Aggregate((p, q) => p + q)); Console.WriteLine(string.Join(" ", es.OrderBy(e => e.D).ThenByDescending(e => e.S).Select(e => e.N + e.S))); Console.WriteLine(es.Select((e, i) => new { e.N, I = i }).Last().I); Console.WriteLine(string.Join(",", es.Select(e => e.D).Distinct()) + es.FirstOrDefault(e => e.A > 100) + es.Single(e => e.N == "c").A + es.FindIndex(e => e.N == "d"));
    }
}
