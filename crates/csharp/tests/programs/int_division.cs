using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        Console.WriteLine(7 / 2); Console.WriteLine(-7 / 2); Console.WriteLine(-7 % 3); Console.WriteLine(7 % -3);
        Console.WriteLine(7.0 / 2); Console.WriteLine(1 / 3 * 3.0); Console.WriteLine((double)1 / 3);
    }
}
