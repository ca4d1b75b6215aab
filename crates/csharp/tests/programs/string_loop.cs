using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        string s = "The quick brown fox"; int v = 0; foreach (char c in s) if ("aeiou".IndexOf(char.ToLower(c)) >= 0) v++; Console.WriteLine(v); string r = ""; for (int i = s.Length - 1; i >= 0; i--) r += s[i]; Console.WriteLine(r); var counts = new Dictionary<char, int>(); foreach (char c in s) { if (!counts.ContainsKey(c)) counts[c] = 0; counts[c]++; } foreach (var p in counts.OrderByDescending(q => q.Value).ThenBy(q => q.Key).Take(3)) Console.Write("[" + p.Key + p.Value + "]"); Console.WriteLine(); Console.WriteLine((int)'A' + " " + (char)66 + " " + ('a' + 1) + " " + (char)('a' + 1) + " " + char.IsDigit('5') + char.IsLetter('x') + char.IsUpper('x')); string n = null; Console.WriteLine("[" + n + "]" + (n == "") + (n + "x").Length);
    }
}
