using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { public readonly int X = 1; }

static class Program
{
    static void Main()
    {
        var a = new A(); a.X = 2; Console.WriteLine(a.X);
    }
}
