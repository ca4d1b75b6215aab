using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        int n = 42; double d = 3.14159; string s = "hi"; DateTime t = new DateTime(2020, 5, 6); object o = null; Console.WriteLine($"{n} {d:F2} {s,6}|{s,-6}|{n:X4} {n,8:D5} {t:yyyy-MM-dd} [{o}] {{n}} {(n > 40 ? "big" : "small")} {s.Length + 1} {new[] { 1, 2 }.Length}"); Console.WriteLine($"{$"{n}" + "x"} {string.Join(",", new[] { 1, 2 }.Select(q => $"<{q}>"))}"); Console.WriteLine($@"c:\{s}\{n}"); Console.WriteLine($"{d}{n}{s}{true}{'c'}{1.0f / 3}"); string u = $"{1}" + $"{2}"; Console.WriteLine(u); Console.WriteLine($"{n:N0} {1234567:N2} {0.256:P1} {n:0000} {-n:+0;-0} {d:0.#} {d,10:0.00}|"); Console.WriteLine("a" + $"{s}" + 'c' + 1 + 2.5 + null + true);
    }
}
