using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        int x = 1; Console.WriteLine(x[0]);
    }
}
