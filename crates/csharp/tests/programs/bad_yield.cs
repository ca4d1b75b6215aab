using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { public static int F() { yield return 1; } }

static class Program
{
    static void Main()
    {
        A.F();
    }
}
