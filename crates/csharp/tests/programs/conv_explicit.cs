using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        double[] values = { 0.5, -0.5, 1.9999, -1.9999, 255.7, -129.2, 65535.9 };
        foreach (double v in values) Console.WriteLine((int)v + " " + (long)v + " " + (short)v + " " + (float)v);
        int[] ints = { 0, 255, 256, -1, 70000, int.MinValue, int.MaxValue };
        foreach (int v in ints) Console.WriteLine((byte)v + " " + (sbyte)v + " " + (short)v + " " + (ushort)v + " " + (uint)v + " " + (ulong)v + " " + (int)(char)v);
        long[] longs = { long.MinValue, long.MaxValue, 1L << 40, -5 };
        foreach (long v in longs) Console.WriteLine((int)v + " " + (uint)v + " " + (byte)v + " " + (ulong)v + " " + (short)v);
        char c = (char)(('a' + 1)); Console.WriteLine(c); Console.WriteLine((char)65 + "" + (char)98L + (char)99.9);
    }
}
