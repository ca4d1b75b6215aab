using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class A { public static T F<T>() { return default(T); } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(A.F());
    }
}
