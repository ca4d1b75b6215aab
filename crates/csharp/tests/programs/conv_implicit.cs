using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        byte b = 200; short s = b; ushort us = b; int i = s; uint ui = us; long l = i; ulong ul = ui; float f = l; double d = f; char c = 'x';
        Console.WriteLine(b + " " + s + " " + us + " " + i + " " + ui + " " + l + " " + ul + " " + f + " " + d);
        i = c; ui = c; l = c; f = c; d = c; us = c;
        Console.WriteLine(i + " " + ui + " " + l + " " + f + " " + d + " " + us);
        long big = long.MaxValue; f = big; d = big;
        Console.WriteLine(f.ToString("R") + " " + d.ToString("R"));
        int exact = 16777217; f = exact; Console.WriteLine((int)f); d = exact; Console.WriteLine((int)d);
        const int small = 100; byte fromConst = small; sbyte sb = -100; Console.WriteLine(fromConst + " " + sb);
        object o = b; Console.WriteLine(o.GetType() + " " + (o is byte) + " " + (o is int));
    }
}
