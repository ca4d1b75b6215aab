using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        float a = 0.1f, b = 0.2f; Console.WriteLine(a + b); Console.WriteLine((double)(a + b) == 0.3); float s = 0; for (int i = 0; i < 10; i++) s += 0.1f; Console.WriteLine(s == 1f); Console.WriteLine(1e10f + " " + 1f / 3 + " " + (float)1e-8 + " " + float.MaxValue + " " + (int)2.9f + " " + 7f % 2.5f); double d = 1e308 * 10; Console.WriteLine(d + " " + -d + " " + (d - d)); Console.WriteLine(0.1 + 0.7 + " " + (0.1 + 0.7) * 10 + " " + (int)((0.1 + 0.7) * 10) + " " + 1.0 / 49 * 49 + " " + 100 * 1.1); Console.WriteLine((0.1).ToString("G17") + " " + (1.0 / 3).ToString("R") + " " + 5e-324 + " " + 123456789.123456789);
    }
}
