using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        int a = int.MaxValue; a++; Console.WriteLine(a);
        unchecked { Console.WriteLine(int.MaxValue + a * 2); }
        try { int b = int.MaxValue; b = checked(b + 1); Console.WriteLine(b); } catch (OverflowException e) { Console.WriteLine(e.Message); }
        long c = (long)int.MaxValue + 1; Console.WriteLine(c); Console.WriteLine((int)c); byte d = 255; d++; Console.WriteLine(d); double big = 300.7; Console.WriteLine((byte)big); sbyte s = -128; s--; Console.WriteLine(s);
        uint u = 0; u--; Console.WriteLine(u); ulong ul = ulong.MaxValue; Console.WriteLine(ul); ul++; Console.WriteLine(ul);
    }
}
