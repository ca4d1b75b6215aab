using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static ulong state = 4711;
    static uint Next() { state = unchecked(state * 6364136223846793005UL + 1442695040888963407UL); return (uint)(state >> 33); }
    static void Main()
    {
        var d = new Dictionary<int, int>(); var h = new HashSet<int>(); var s = new SortedDictionary<int, int>(); uint hash = 2166136261;
        for (int i = 1; i <= 2500; i++)
        {
            int k = (int)(Next() % 60);
            switch (Next() % 4) { case 0: d.Remove(k); h.Remove(k); s.Remove(k); break; case 1: d[k] = i; h.Add(k); s[k] = i; break; case 2: if (!d.ContainsKey(k)) d.Add(k, -i); h.Add(k + 100); break; default: if (Next() % 40 == 0) { d.Clear(); h.Clear(); s.Clear(); } break; }
            if (i % 10 == 0) { string all = string.Join(",", d.Select(p => p.Key + "=" + p.Value)) + ";" + string.Join(",", h) + ";" + string.Join(",", s.Keys) + d.Count; foreach (char ch in all) hash = unchecked((hash ^ ch) * 16777619); }
            if (i % 100 == 0) { Console.WriteLine(i + " " + hash.ToString("x8")); hash = 2166136261; }
        }
    }
}
