using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static ulong state = 31337;
    static uint Next() { state = unchecked(state * 6364136223846793005UL + 1442695040888963407UL); return (uint)(state >> 33); }
    static void Main()
    {
        uint hash = 2166136261;
        for (int i = 1; i <= 2500; i++)
        {
            int a = unchecked((int)(Next() << (int)(Next() % 8))), b = unchecked((int)Next() - 1073741824) | 1; long l = unchecked((long)a * b * 31); ulong u = unchecked((ulong)l); uint v = unchecked((uint)b); short sh = unchecked((short)a); byte by = unchecked((byte)b); sbyte sb = unchecked((sbyte)a);
            string all = unchecked(a + b) + " " + unchecked(a * b) + " " + (a == int.MinValue && b == -1 ? 0 : a / b) + " " + (b == -1 ? 0 : a % b) + " " + (a << (b & 63)) + " " + (a >> (b & 31)) + " " + (l >> (a & 63)) + " " + (u >> (a & 63)) + " " + (u / v) + " " + (u % v) + " " + (l / b) + " " + (a & b) + " " + (a | b) + " " + (a ^ b) + " " + ~a + " " + (sh + by) + " " + (sb * sh) + " " + unchecked((uint)l) + " " + unchecked((int)u) + " " + (double)u + " " + (float)l + " " + (double)l + " " + (char)(by % 26 + 97) + a.ToString("X") + l.ToString("x") + by.ToString("D4") + Convert.ToString(a, 2) + (v > a) + (l < u % 1000) + Math.Sign(a - (long)b) + a.CompareTo(b) + a.GetHashCode() + l.GetHashCode();
            try { all += checked(a + b); } catch (OverflowException) { all += "o"; } try { all += checked((short)a); } catch (OverflowException) { all += "s"; } try { all += checked(a * b); } catch (OverflowException) { all += "m"; } try { all += checked((uint)a); } catch (OverflowException) { all += "u"; }
            foreach (char ch in all) hash = unchecked((hash ^ ch) * 16777619);
            if (i % 100 == 0) { Console.WriteLine(i + " " + hash.ToString("x8")); hash = 2166136261; }
        }
    }
}
