using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { public static int F(int x) { if (x > 0) return 1; } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(A.F(1));
    }
}
