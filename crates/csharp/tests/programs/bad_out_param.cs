using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { public static int F(int x) { return; } }

static class Program
{
    static void Main()
    {
        A.F(1);
    }
}
