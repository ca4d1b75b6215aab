using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        var t = new List<List<double>>(); for (int i = 0; i < 3; i++) { t.Add(new List<double>()); for (int j = 0; j <= i; j++) t[i].Add(i * 0.5 + j); } foreach (var row in t) Console.WriteLine(string.Join(" ", row)); t[1][0] *= 3; t[2][1]++; Console.WriteLine(t[1][0] + " " + t[2][1] + " " + t.Sum(r => r.Count) + " " + t.SelectMany(r => r).Max()); var flat = t.SelectMany(r => r).Where(x => x > 1).Distinct().ToList(); Console.WriteLine(flat.Count);
    }
}
