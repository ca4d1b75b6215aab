using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

sealed class A { } class B : A { }

static class Program
{
    static void Main()
    {
        Console.WriteLine();
    }
}
