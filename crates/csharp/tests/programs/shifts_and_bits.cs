using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        Console.WriteLine(1 << 33); Console.WriteLine(-8 >> 1); Console.WriteLine(0xFFu >> 4); Console.WriteLine(~5); Console.WriteLine(6 & 3 | 8 ^ 1); Console.WriteLine(1L << 40); int x = 5; x <<= 2; x |= 1; x ^= 3; Console.WriteLine(x); x >>= 1; Console.WriteLine(x);
    }
}
