using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        int n = 2000; var comp = new bool[n + 1]; int count = 0; for (int i = 2; i <= n; i++) { if (comp[i]) continue; count++; for (int j = i * 2; j <= n; j += i) comp[j] = true; } Console.WriteLine(count); long s = 0; for (int i = 0; i < 100000; i++) { s += i % 7 * (i & 3); } Console.WriteLine(s);
    }
}
