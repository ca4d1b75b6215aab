using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class A { private int x = 1; public int Y { get { return x; } } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(new A().x);
    }
}
