using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        int[] a = { 1, 2, 3, 4 }; var q = from x in a where x % 2 == 0 select x * 10; Console.WriteLine(string.Join(",", q)); var q2 = from x in a from y in a where x < y orderby x descending, y select x + "" + y; Console.WriteLine(string.Join(" ", q2)); var q3 = from x in a let s = x * x where s > 3 select new { x, s }; foreach (var t in q3) Console.WriteLine(t.x + " " + t.s); var q4 = from x in a group x by x % 2 into g orderby g.Key select g.Key + ":" + g.Sum(); Console.WriteLine(string.Join(" ", q4)); var q5 = from x in a join y in new[] { 2, 4, 6 } on x equals y / 2 select x + "-" + y; Console.WriteLine(string.Join(" ", q5)); var lazy = a.Where(x => { Console.Write("w" + x + " "); return x > 2; }); Console.WriteLine("made"); Console.WriteLine(lazy.First());
    }
}
