using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        int[] a = { 5, 3, 8, 1, 9, 2 }; string[] w = { "apple", "bob", "cat", "apple", "dog", "Bob" };
        Console.WriteLine(string.Join(",", a.OrderBy(x => x).Select(x => x * x)) + " " + string.Join(",", a.OrderByDescending(x => x).Take(3)) + " " + string.Join(",", a.Skip(2).TakeWhile(x => x > 0).SkipWhile(x => x > 5)));
        Console.WriteLine(a.Sum() + " " + a.Average() + " " + a.Min() + " " + a.Max() + " " + a.Count(x => x > 3) + " " + a.Any(x => x > 8) + " " + a.All(x => x > 0) + " " + a.Contains(8) + " " + a.First(x => x > 5) + " " + a.Last() + " " + a.ElementAt(2) + " " + a.SingleOrDefault(x => x == 100) + " " + a.Aggregate((x, y) => x * 10 + y % 10) + " " + a.Aggregate("", (s, x) => s + x) + " " + a.Aggregate(1, (x, y) => x + y, r => r * 2));
        Console.WriteLine(string.Join(",", w.Distinct()) + " " + string.Join(",", w.GroupBy(x => x.Length).Select(g => g.Key + ":" + g.Count())) + " " + string.Join(",", w.OrderBy(x => x.Length).ThenBy(x => x).ThenByDescending(x => x[0])) + " " + string.Join(",", w.ToLookup(x => x[0])['a']));
        Console.WriteLine(string.Join(",", a.Zip(w, (x, y) => x + y)) + " " + string.Join(",", a.Concat(new[] { 1 }).Union(new[] { 77 })) + " " + string.Join(",", a.Intersect(new[] { 1, 2, 4 })) + " " + string.Join(",", a.Except(new[] { 1, 2 })) + " " + string.Join(",", a.Reverse()) + " " + a.SequenceEqual(new[] { 5 }));
        Console.WriteLine(string.Join(",", Enumerable.Range(3, 4)) + string.Join(",", Enumerable.Repeat("z", 2)) + string.Join(",", new[] { new[] { 1, 2 }, new[] { 3 } }.SelectMany(x => x)) + string.Join(",", a.Select((x, i) => x * i)) + string.Join(",", a.Where((x, i) => i % 2 == 0)) + string.Join(",", new object[] { 1, "a", 2 }.OfType<int>()) + string.Join(",", new object[] { 1, 2 }.Cast<int>().DefaultIfEmpty()) + string.Join(",", new int[0].DefaultIfEmpty(5)));
        var d = w.Distinct().ToDictionary(x => x, x => x.Length); Console.WriteLine(string.Join(",", d.Select(p => p.Key + p.Value)) + d.Values.Sum() + string.Join("", d.Keys)); var q = from x in a where x > 2 let y = x * 2 orderby y descending select new { x, y }; foreach (var z in q) Console.Write(z + ";"); Console.WriteLine(); var j = from x in a join y in new[] { 1, 5, 9 } on x equals y select x + y; Console.WriteLine(string.Join(",", j)); var g2 = from s in w group s by s.Length into g orderby g.Key select g.Key + "=" + string.Join("/", g); Console.WriteLine(string.Join(" ", g2)); var gj = from x in new[] { 1, 2 } join y in new[] { 1, 1, 3 } on x equals y into ys select x + ":" + ys.Count(); Console.WriteLine(string.Join(" ", gj)); var cross = from x in new[] { 1, 2 } from y in new[] { 'a', 'b' } select x + "" + y; Console.WriteLine(string.Join(" ", cross)); Console.WriteLine(w.Max(x => x.Length) + " " + w.Min(x => x.Length) + " " + w.Sum(x => x.Length) + " " + w.Average(x => x.Length) + w.LastOrDefault(x => x == "q") + w.FirstOrDefault()); var hs = a.ToList(); hs.RemoveAll(x => x > 4); Console.WriteLine(string.Join(",", hs)); Console.WriteLine(a.ToArray().Length + a.LongCount() + " " + a.AsEnumerable().Count() + string.Join(",", a.Append(0).Prepend(7))); Console.WriteLine(new[] { 1.5, 2.5 }.Sum() + " " + new[] { 1.5f, 2 }.Average() + " " + new long[] { 1, 2 }.Sum() + " " + new double?[] { 1, null, 3 }.Average());
        try { a.Single(); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); } try { new int[0].Max(); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); } try { new int[0].Average(); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); }
    }
}
