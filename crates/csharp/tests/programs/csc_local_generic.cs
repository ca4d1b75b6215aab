using System;
using System.Collections.Generic;
using System.Linq;

class Program
{
    int field = 7;

    static void Main()
    {
        T Last<T>(List<T> list) { return list[list.Count - 1]; }
        IEnumerable<int> Squares(int n)
        {
            for (int i = 1; i <= n; i++) yield return i * i;
        }
        Console.WriteLine(Last(new List<int> { 1, 2, 3 }));
        Console.WriteLine(Last<string>(new List<string> { "a", "b" }));
        Console.WriteLine(string.Join(",", Squares(4)));
        int scale = 10;
        IEnumerable<int> Scaled(IEnumerable<int> source)
        {
            foreach (int x in source) { if (x > 9) yield break; yield return x * scale; }
        }
        var lazy = Scaled(Squares(5));
        scale = 100;
        Console.WriteLine(string.Join(",", lazy));
        int Count<T>(IEnumerable<T> s) where T : class
        {
            int n = 0;
            foreach (T x in s) if (x != null) n++;
            return n;
        }
        Console.WriteLine(Count(new[] { "x", null, "y" }));
        int Depth<T>(T x, int n) { return n == 0 ? 0 : 1 + Depth(x, n - 1); }
        Console.WriteLine(Depth("q", 5));
        new Program().Instance();
        Func<int, int> f = Fact;
        int Fact(int n) => n < 2 ? 1 : n * Fact(n - 1);
        Console.WriteLine(f(6));
    }

    void Instance()
    {
        string Show<T>(T x) { return x + "/" + field; }
        Console.WriteLine(Show(1.5) + " " + Show('c'));
    }
}
