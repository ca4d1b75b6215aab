using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { public static void F(ref int x) { } }

static class Program
{
    static void Main()
    {
        int x = 1; A.F(x);
    }
}
