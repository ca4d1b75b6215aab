using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        int[] a = { 5, 2, 8, 1, 9, 2 }; Console.WriteLine(a.Sum() + " " + a.Max() + " " + a.Min() + " " + a.Average() + " " + a.Count() + " " + a.Count(x => x > 2) + " " + a.First() + " " + a.Last() + " " + a.Any(x => x == 8) + " " + a.All(x => x > 0)); Console.WriteLine(string.Join(",", a.Where(x => x > 2).Select(x => x * x))); Console.WriteLine(string.Join(",", a.OrderBy(x => x)) + " " + string.Join(",", a.OrderByDescending(x => x)) + " " + string.Join(",", a.Distinct()) + " " + string.Join(",", a.Skip(1).Take(3)) + " " + string.Join(",", a.Reverse())); Console.WriteLine(string.Join(",", a.Select((x, i) => x * i))); Console.WriteLine(a.Aggregate((x, y) => x * 10 + y) + " " + a.Aggregate(1.5, (x, y) => x + y)); Console.WriteLine(string.Join(" ", Enumerable.Range(1, 5).Zip(a, (x, y) => x + ":" + y))); Console.WriteLine(string.Join(",", a.TakeWhile(x => x != 1)) + "|" + string.Join(",", a.SkipWhile(x => x != 1)) + "|" + string.Join(",", a.Concat(new[] { 0 }).Union(new[] { 77 }).Except(new[] { 2 }))); Console.WriteLine(a.FirstOrDefault(x => x > 100) + " " + a.ElementAt(2) + " " + a.Contains(9) + " " + a.SequenceEqual(a.ToList())); try { new int[0].Max(); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); } var d = a.Distinct().ToDictionary(x => x, x => "v" + x); Console.WriteLine(d[8]); Console.WriteLine(string.Join(";", new[] { "bb", "a", "ccc", "dd" }.GroupBy(x => x.Length).Select(g => g.Key + "=" + string.Join("+", g)))); Console.WriteLine(string.Join(",", new[] { "b", "a" }.SelectMany(x => x + "1")) + Enumerable.Repeat("x", 3).Count() + new[] { 1.5, 2.5 }.Sum() + new[] { "x", "yy" }.Max(s => s.Length) + new[] { "x", "yy" }.Sum(s => s.Length)); Console.WriteLine(string.Join(",", new object[] { 1, "a", 2.5, "b" }.OfType<string>())); Console.WriteLine(string.Join(",", new[] { "b2", "a1", "a2" }.OrderBy(x => x[0]).ThenByDescending(x => x[1])));
    }
}
