using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        Console.WriteLine("{0} {1:F2} {2,6}|{3,-6}|{{}}", "a", 1.5, 42, "x");
        Console.WriteLine(string.Format("{0:N1} {0:E2} {1}", 1234.5, null));
        try { Console.WriteLine(string.Format("{1}", 1)); } catch (FormatException e) { Console.WriteLine(e.Message); }
        try { Console.WriteLine(string.Format("{0", 1)); } catch (FormatException e) { Console.WriteLine("format"); }
        int a = 3; Console.WriteLine($"{a} {a + 1:D3} {a,4} {(a > 2 ? "big" : "small")} {{x}}"); Console.WriteLine($@"c:\{a}");
    }
}
