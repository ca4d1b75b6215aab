using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        double d = 1; int x = d; Console.WriteLine(x);
    }
}
