using System;
using System.Linq;

static class Program
{
    static void Main()
    {
        int Fact(int n) { return n < 2 ? 1 : n * Fact(n - 1); }
        int total = 0;
        void Add(int x) { total += x; }
        Add(3);
        Add(4);
        Console.WriteLine(Fact(5) + " " + total);
        bool Long(string s, out int r) { r = s.Length; return r > 2; }
        int q;
        Console.WriteLine(Long("abc", out q) + " " + q);
        Console.WriteLine(string.Join(",", new[] { 1, 2, 3 }.Select(Sq)));
        int Sq(int x) => x * x;
    }
}
