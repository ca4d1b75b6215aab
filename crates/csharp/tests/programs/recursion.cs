using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class R { public static int Ack(int m, int n) { return m == 0 ? n + 1 : n == 0 ? Ack(m - 1, 1) : Ack(m - 1, Ack(m, n - 1)); } public static void Hanoi(int n, string a, string b, string c, ref int moves) { if (n == 0) return; Hanoi(n - 1, a, c, b, ref moves); moves++; Hanoi(n - 1, c, b, a, ref moves); } public static IEnumerable<string> Perm(string s) { if (s.Length <= 1) { yield return s; yield break; } for (int i = 0; i < s.Length; i++) foreach (var p in Perm(s.Remove(i, 1))) yield return s[i] + p; } public static bool Even(int n) { return n == 0 || Odd(n - 1); } public static bool Odd(int n) { return n != 0 && Even(n - 1); } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(R.Ack(2, 3)); int moves = 0; R.Hanoi(6, "a", "b", "c", ref moves); Console.WriteLine(moves); Console.WriteLine(string.Join(" ", R.Perm("abc"))); Console.WriteLine(R.Even(100) + " " + R.Odd(7));
    }
}
