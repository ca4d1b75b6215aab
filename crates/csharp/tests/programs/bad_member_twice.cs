using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { int x; string x; }

static class Program
{
    static void Main()
    {
        Console.WriteLine();
    }
}
