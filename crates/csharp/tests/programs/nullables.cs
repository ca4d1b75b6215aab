using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        int? a = null, b = 5; Console.WriteLine(a + b); Console.WriteLine((a + b).HasValue + " " + (b * 2) + " " + (a ?? 9) + " " + (a == null) + " " + (b > 3) + " " + (a > 3) + " " + (a == b) + " " + (a != b)); Console.WriteLine(b.Value + " " + a.GetValueOrDefault() + " " + a.GetValueOrDefault(4) + "[" + a + "]"); try { Console.WriteLine(a.Value); } catch (InvalidOperationException e) { Console.WriteLine(e.Message); } b++; Console.WriteLine(b); a = b; Console.WriteLine(a.HasValue); double? d = b; Console.WriteLine(d); object o = b; Console.WriteLine(o is int); string s = null; Console.WriteLine(s?.Length); Console.WriteLine(s?.Length ?? -1); s = "abc"; Console.WriteLine(s?.Substring(1)?.Length); int[] arr = null; Console.WriteLine(arr?[0]); bool? f = null; Console.WriteLine(f == true); int? sum = 0; foreach (int? x in new int?[] { 1, null, 3 }) if (x != null) sum += x; Console.WriteLine(sum);
    }
}
