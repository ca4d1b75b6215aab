using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { public static void F(int x) { } }

static class Program
{
    static void Main()
    {
        A.F("s");
    }
}
