using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static ulong state = 99;
    static uint Next() { state = unchecked(state * 6364136223846793005UL + 1442695040888963407UL); return (uint)(state >> 33); }
    static string Word() { const string letters = "aAbBcCzZ019"; string s = ""; int n = (int)(Next() % 6); for (int i = 0; i < n; i++) s += letters[(int)(Next() % letters.Length)]; return s; }
    static void Main()
    {
        uint hash = 2166136261;
        for (int i = 1; i <= 2500; i++)
        {
            string a = Word(), b = Word();
            string all = Math.Sign(string.Compare(a, b)) + " " + Math.Sign(string.Compare(a, b, true)) + " " + Math.Sign(string.CompareOrdinal(a, b)) + " " + Math.Sign(a.CompareTo(b)) + " " + string.Equals(a, b, StringComparison.OrdinalIgnoreCase) + a.IndexOf(b, StringComparison.Ordinal) + a.StartsWith(b, StringComparison.Ordinal) + a.Replace("a", b) + a.Contains(b) + a.ToUpperInvariant() + string.Join(",", (a + b).Split('a', 'B')) + (a + "," + b).LastIndexOf('a') + a.PadLeft(5, '.') + b.Trim('a', '0');
            foreach (char ch in all) hash = unchecked((hash ^ ch) * 16777619);
            if (i % 100 == 0) { Console.WriteLine(i + " " + hash.ToString("x8")); hash = 2166136261; }
        }
        var list = new List<string>(); for (int i = 0; i < 300; i++) list.Add(Word() + i); list.Sort(); Console.WriteLine(string.Join(" ", list.Take(40))); list.Sort(StringComparer.Ordinal); Console.WriteLine(string.Join(" ", list.Skip(100).Take(40))); Console.WriteLine(string.Join(" ", list.OrderBy(x => x, StringComparer.OrdinalIgnoreCase).Take(40)));
    }
}
