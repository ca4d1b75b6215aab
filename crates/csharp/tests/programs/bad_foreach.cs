using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        foreach (int x in 5) Console.WriteLine(x);
    }
}
