// Decimals in fields, lists, dictionaries, queries, switches and rounding.
using System;
using System.Collections.Generic;
using System.Linq;
struct Price { public decimal Net; public decimal Gross { get { return Math.Round(Net * 1.19m, 2); } } }
class Account { const decimal Rate = 0.035m; decimal balance; public decimal[] Log = new decimal[3]; public static decimal Total; public void Add(decimal x) { balance += x; Total += x; } public decimal Interest(int years = 1, decimal extra = 0.5m) { decimal b = balance; for (int i = 0; i < years; i++) b *= 1 + Rate; return b - balance + extra; } }
class P
{
    static decimal Sum(params decimal[] list) { decimal s = 0; foreach (decimal x in list) s += x; return s; }
    static T Largest<T>(IEnumerable<T> list) where T : IComparable<T> { T best = default(T); foreach (T x in list) if (x.CompareTo(best) > 0) best = x; return best; }
    static void Main()
    {
        var p = new Price { Net = 19.99m }; var q = p; q.Net = 5; Console.WriteLine(p.Gross + " " + q.Gross + " " + new Price().Net);
        var a = new Account(); a.Add(100); a.Add(0.10m); Console.WriteLine(a.Interest() + " " + a.Interest(10) + " " + a.Interest(2, extra: 1) + " " + Account.Total + " " + a.Log[2]);
        var list = new List<decimal> { 3.5m, 1.25m, 2, 1.250m }; list.Sort(); Console.WriteLine(string.Join(" ", list) + " " + list.Sum() + " " + list.Average() + " " + list.Max() + " " + list.Min() + " " + list.IndexOf(1.25m) + " " + list.Contains(2.0m));
        Console.WriteLine(list.Distinct().Count() + " " + list.GroupBy(x => decimal.Truncate(x)).Count() + " " + list.Select(x => x * 2).OrderByDescending(x => x).First() + " " + list.Sum(x => x * x) + " " + new[] { 1, 2 }.Sum(x => (decimal)x / 3) + " " + new decimal?[] { 1, null, 2 }.Sum());
        var names = new Dictionary<decimal, string> { { 1.0m, "one" } }; Console.WriteLine(names[1.00m] + " " + names.ContainsKey(1.01m));
        Console.WriteLine(Sum() + " " + Sum(1, 2.5m, 3) + " " + Largest(new[] { 0.5m, 2.5m, 1m }));
        foreach (decimal d in new[] { 2.5m, -2.5m, 2.345m, -2.345m, 1.005m, 0.5m, 1.5m })
            Console.Write(Math.Round(d) + " " + Math.Round(d, 2) + " " + Math.Round(d, MidpointRounding.AwayFromZero) + " " + Math.Round(d, 2, MidpointRounding.AwayFromZero) + " " + Math.Floor(d) + " " + Math.Ceiling(d) + " " + Math.Truncate(d) + " " + Math.Abs(d) + " " + Math.Sign(d) + "; ");
        Console.WriteLine();
        decimal m = 5; m++; ++m; m--; m -= 0.5m; m *= 2; m /= 4; m %= 2; Console.WriteLine(m + " " + -m + " " + +m + " " + (m > 1 ? "more" : "less"));
        dynamic w = 1.5m; Console.WriteLine(w + 1 + " " + (w * 2m) + " " + (w > 1));
        Console.WriteLine(Math.Max(1m, 2) + " " + Math.Min(1.5m, 1) + " " + decimal.Compare(1, 2) + " " + decimal.Add(1, 2) + " " + decimal.Remainder(7, 4) + " " + (0.1m + 0.2m == 0.3m) + " " + (0.1 + 0.2 == 0.3));
        long factorial = 1; decimal exact = 1; for (int i = 2; i <= 27; i++) { exact *= i; } Console.WriteLine(exact + " " + factorial);
        Func<decimal, decimal> half = x => x / 2; Console.WriteLine(half(3) + " " + half(half(1)));
        var t = (1.5m, 2); Console.WriteLine(t.Item1 + t.Item2); Console.WriteLine(new { Cost = 1.50m });
    }
}
