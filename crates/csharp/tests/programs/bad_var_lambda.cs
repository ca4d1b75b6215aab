using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        var f = (int x) => x; Console.WriteLine(f);
    }
}
