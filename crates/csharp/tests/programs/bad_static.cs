using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public int X; public static int F() { return X; } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(A.F());
    }
}
