using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        var d = new Dictionary<string, int> { { "one", 1 }, { "two", 2 } }; d["three"] = 3; d["one"]++; foreach (var kv in d) Console.WriteLine(kv.Key + " " + kv.Value); int v; Console.WriteLine(d.TryGetValue("two", out v) + " " + v); Console.WriteLine(d.ContainsKey("x") + " " + d.Count); d.Remove("one"); d["four"] = 4; foreach (var k in d.Keys) Console.Write(k + " "); Console.WriteLine(); foreach (var x in d.Values) Console.Write(x + " "); Console.WriteLine();
        try { Console.WriteLine(d["zzz"]); } catch (KeyNotFoundException e) { Console.WriteLine("missing"); } try { d.Add("two", 5); } catch (ArgumentException e) { Console.WriteLine("twice"); } var e2 = new Dictionary<int, List<string>>(); for (int i = 0; i < 20; i++) { if (!e2.ContainsKey(i % 3)) e2[i % 3] = new List<string>(); e2[i % 3].Add("v" + i); } Console.WriteLine(string.Join(" ", e2.Select(p => p.Key + ":" + p.Value.Count))); Console.WriteLine(d.First()); var byd = new Dictionary<double, char> { [1.5] = 'a', [2.5] = 'b' }; Console.WriteLine(byd[2.5]);
    }
}
