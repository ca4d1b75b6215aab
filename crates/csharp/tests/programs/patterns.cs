using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        foreach (object o in new object[] { 1, -5, "text", 2.5, null, new[] { 1, 2 }, 'c' }) { string r = "?"; if (o is int n && n < 0) r = "neg " + n; else if (o is int m) r = "int " + m; else if (o is string s) r = "str " + s.Length; else if (o == null) r = "null"; else if (o is int[] a) r = "arr " + a.Length; else r = o.GetType().Name; Console.WriteLine(r); } object x = 5; if (x is int i && i > 3) Console.WriteLine(i); if (!(x is string)) Console.WriteLine("no string");
    }
}
