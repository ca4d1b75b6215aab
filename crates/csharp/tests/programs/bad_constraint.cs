using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { public static T F<T>(T x) where T : struct { return x; } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(A.F("s"));
    }
}
