using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class C { public static Func<int> Counter() { int n = 0; return () => ++n; } public static Func<int, Func<int, int>> Add = a => b => a + b; public static int Apply(Func<int, int> f, int x) { return f(x); } public static int Twice(int x) { return x * 2; } }

static class Program
{
    static void Main()
    {
        var c = C.Counter(); c(); c(); Console.WriteLine(c()); Console.WriteLine(C.Add(2)(3)); Console.WriteLine(C.Apply(C.Twice, 4) + C.Apply(x => x + 1, 4)); var fs = new List<Action>(); for (int i = 0; i < 3; i++) fs.Add(() => Console.Write(i + " ")); foreach (var f in fs) f(); Console.WriteLine(); fs.Clear(); foreach (int i in new[] { 1, 2, 3 }) fs.Add(() => Console.Write(i + " ")); foreach (var f in fs) f(); Console.WriteLine(); int total = 0; Action<int> add = x => total += x; add(3); add(4); Console.WriteLine(total); Func<int, int> fact = null; fact = n => n < 2 ? 1 : n * fact(n - 1); Console.WriteLine(fact(10)); Func<double, double> sq = Math.Sqrt; Console.WriteLine(sq(16)); Predicate<string> isEmpty = string.IsNullOrEmpty; Console.WriteLine(isEmpty("")); Comparison<int> cmp = delegate (int p, int r) { return r - p; }; Console.WriteLine(cmp(1, 5)); Action nothing = delegate { Console.WriteLine("anon"); }; nothing();
    }
}
