using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        int? a = 5, b = null; Console.WriteLine(a + b); Console.WriteLine((a + b) == null); Console.WriteLine(a + 1); Console.WriteLine(a > b); Console.WriteLine(a < b); Console.WriteLine(a == b); Console.WriteLine(b == null); Console.WriteLine(a != b); Console.WriteLine(a >= 5); Console.WriteLine(b >= b); Console.WriteLine(b == b);
        Console.WriteLine(a ?? 9); Console.WriteLine(b ?? 9); Console.WriteLine(a.HasValue + " " + b.HasValue); Console.WriteLine(a.Value + b.GetValueOrDefault() + b.GetValueOrDefault(3)); Console.WriteLine("[" + b + "]" + a);
        bool? t = true, f = false, n = null; Console.WriteLine((t & n) == null); Console.WriteLine(f & n); Console.WriteLine(t | n); Console.WriteLine((f | n) == null); Console.WriteLine(!n == null); Console.WriteLine(!t); Console.WriteLine((t ^ n).HasValue);
        try { Console.WriteLine((int)b); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); }
        a++; Console.WriteLine(a); b++; Console.WriteLine(b == null); a += 2; Console.WriteLine(a); a = a * 2 - 1; Console.WriteLine(a); double? d = a; Console.WriteLine(d / 2); long? l = null; l = a; Console.WriteLine(l); Console.WriteLine(-a); Console.WriteLine(~a);
        object o = a; Console.WriteLine(o.GetType()); o = b; Console.WriteLine(o == null); int? back = (int?)o; Console.WriteLine(back.HasValue); Console.WriteLine(o is int?); o = 7; Console.WriteLine(o is int?); Console.WriteLine((int?)o + 1); Console.WriteLine(a.Equals(15) + " " + b.Equals(null) + " " + a.GetHashCode() + " " + b.GetHashCode() + " " + a.ToString() + b.ToString() + ".");
        DateTime? when = null; Console.WriteLine(when?.Year == null); string s = null; Console.WriteLine(s?.Length ?? -1); int? len = s?.Length; Console.WriteLine(len.HasValue); s = "abc"; Console.WriteLine(s?.Length + s?[1]); int?[] arr = { 1, null, 3 }; Console.WriteLine(arr.Sum()); Console.WriteLine(arr.Count(q => q == null)); Console.WriteLine(arr.Max());
    }
}
