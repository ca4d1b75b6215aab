using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class I { public static IEnumerable<int> Fib() { int a = 0, b = 1; while (true) { yield return a; int t = a + b; a = b; b = t; } } public static IEnumerable<string> Try() { try { yield return "a"; yield return "b"; } finally { Console.WriteLine("finally"); } } public static IEnumerable<int> Tree(int d) { if (d == 0) { yield return 0; yield break; } foreach (int x in Tree(d - 1)) yield return x; yield return d; } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(string.Join(",", I.Fib().Take(10))); foreach (var s in I.Try()) { Console.WriteLine(s); break; } foreach (var s in I.Try()) Console.WriteLine(s); Console.WriteLine(string.Join(",", I.Tree(4))); var e = I.Fib().GetEnumerator(); e.MoveNext(); e.MoveNext(); e.MoveNext(); Console.WriteLine(e.Current); var seq = I.Tree(2); Console.WriteLine(seq.Count() + " " + seq.Count());
    }
}
