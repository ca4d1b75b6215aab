using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        Func<int, string> f = x => x; Console.WriteLine(f(1));
    }
}
