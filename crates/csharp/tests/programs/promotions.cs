using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        byte a = 10, b = 20; int c = a + b; Console.WriteLine(c); a += 5; Console.WriteLine(a); char ch = 'a'; ch++; Console.WriteLine(ch); Console.WriteLine(ch + 1); Console.WriteLine((char)(ch + 1)); float f = 1.5f; double d = f * 2; Console.WriteLine(d); Console.WriteLine(5 / 2f); long l = 3; Console.WriteLine(l / 2); uint u = 3; Console.WriteLine(u - 4); short sh = (short)(a + 1); Console.WriteLine(sh);
    }
}
