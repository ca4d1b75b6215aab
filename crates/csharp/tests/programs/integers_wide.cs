using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        long f = 1; for (int i = 1; i <= 20; i++) f *= i; Console.WriteLine(f); ulong h = 14695981039346656037; foreach (char c in "hash") { h ^= c; h *= 1099511628211; } Console.WriteLine(h); uint r = 0xDEADBEEF; r = (r << 5) | (r >> 27); Console.WriteLine(r); Console.WriteLine(long.MinValue + " " + ulong.MaxValue + " " + short.MaxValue + " " + sbyte.MinValue); int hash = 17; foreach (int x in new[] { 1, 2, 3 }) hash = hash * 31 + x; Console.WriteLine(hash); int big = 70000; long m1 = -1; Console.WriteLine((short)big + " " + (sbyte)big + " " + (uint)m1 + " " + (ulong)m1 + " " + (int)(m1 + 3000000000u) + " " + (ushort)big);
        } static short Unused(int x) { unchecked { return (short)x; } } static void Other() {
    }
}
