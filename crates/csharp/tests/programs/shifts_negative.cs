using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        int x = 1; Console.WriteLine(x << 31); Console.WriteLine(x << 32); Console.WriteLine(x << 33); Console.WriteLine(x << -1); Console.WriteLine(-8 >> 1); Console.WriteLine(-1 >> 31); Console.WriteLine(-8 >> 33);
        uint u = 0x80000000; Console.WriteLine(u >> 31); Console.WriteLine(u << 1); long l = 1; Console.WriteLine(l << 63); Console.WriteLine(l << 64); Console.WriteLine(-1L >> 60); ulong ul = ulong.MaxValue; Console.WriteLine(ul >> 60);
        byte b = 255; Console.WriteLine(b << 4); b <<= 4; Console.WriteLine(b); short s = -1; s >>= 3; Console.WriteLine(s); s <<= 12; Console.WriteLine(s);
        Console.WriteLine(~5); Console.WriteLine(~0u); Console.WriteLine(~(byte)1); Console.WriteLine(5 & 3 | 4 ^ 1); Console.WriteLine((5 & 3) == 1 && (6 | 1) == 7);
        int h = 17; h = h * 31 ^ 5; h ^= h >> 3; Console.WriteLine(h); Console.WriteLine(0xFFFFFFFF); Console.WriteLine(0x7FFFFFFF); Console.WriteLine(0xFFFFFFFFF);
    }
}
