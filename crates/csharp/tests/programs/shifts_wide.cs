using System;
class P {
    static void Main() {
        ulong u = 0xF0F0F0F0F0F0F0F1; long l = long.MinValue; uint i = 0x80000001; byte b = 200; int n = -8;
        foreach (int by in new[] { 0, 1, 31, 32, 33, 63, 64, -1 }) Console.WriteLine((u << by) + " " + (u >> by) + " " + (l << by) + " " + (l >> by) + " " + (i << by) + " " + (i >> by) + " " + (b << by) + " " + (b >> by) + " " + (n >> by));
        u = u << 8 | b; u >>= 3; u <<= b; Console.WriteLine(u); Console.WriteLine((u >> 56 - 8 & 255).GetType());
    }
}
