using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        var acts = new List<Func<int>>(); for (int i = 0; i < 3; i++) acts.Add(() => i); foreach (var f in acts) Console.Write(f() + " "); Console.WriteLine();
        acts.Clear(); foreach (int i in new[] { 1, 2, 3 }) acts.Add(() => i * 10); foreach (var f in acts) Console.Write(f() + " "); Console.WriteLine();
        acts.Clear(); int j = 0; while (j < 3) { int k = j; acts.Add(() => k++ + j); j++; } foreach (var f in acts) Console.Write(f() + " " + f() + " "); Console.WriteLine();
        Func<Func<int>> counter = () => { int n = 0; return () => ++n; }; var c1 = counter(); var c2 = counter(); Console.WriteLine(c1() + c1() + c2() + " " + c1());
        int shared = 1; Action inc = () => shared++; Action dbl = () => shared *= 2; inc(); dbl(); inc(); Console.WriteLine(shared);
        Func<int, Func<int, Func<int, int>>> curry = x => y => z => x * 100 + y * 10 + z; Console.WriteLine(curry(1)(2)(3)); Func<int, int> fib = null; fib = n => n < 2 ? n : fib(n - 1) + fib(n - 2); Console.WriteLine(fib(15));
        string[] words = { "b", "a" }; Array.Sort(words, (p, q) => string.CompareOrdinal(p, q)); Console.WriteLine(string.Concat(words)); Action<string> say = Console.WriteLine; say("hi"); new List<int> { 3, 1 }.ForEach(x => Console.Write(x)); Console.WriteLine();
        acts.Clear(); for (int i = 0; i < 2; i++) { acts.Add(() => { i += 10; return i; }); } Console.WriteLine(acts[0]() + " " + acts[1]());
        { int x = 5; Action a = () => x = 7; a(); Console.WriteLine(x); } { int x = 6; Func<int> g = () => x; x = 8; Console.WriteLine(g()); }
    }
}
