using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { public static void F(int x) { } public static void F(int x, int y, int z) { } }

static class Program
{
    static void Main()
    {
        A.F(1, 2);
    }
}
