using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        int[] v = { 0, 7, -7, 42, 1234567, -1234567, int.MaxValue, int.MinValue };
        string[] f = { "D", "D5", "d10", "X", "x8", "N0", "N2", "F2", "E3", "G", "P0", "000", "#,#", "00-00", "0.0" };
        foreach (int d in v) { foreach (string s in f) Console.Write(d.ToString(s, System.Globalization.CultureInfo.InvariantCulture) + " "); Console.WriteLine(); }
        long big = 1234567890123; Console.WriteLine(big.ToString("N0", System.Globalization.CultureInfo.InvariantCulture) + " " + big.ToString("X")); byte b = 200; Console.WriteLine(b.ToString("X2") + b.ToString("D4")); Console.WriteLine((-1L).ToString("X") + " " + ((short)-1).ToString("X") + " " + ((sbyte)-1).ToString("X2"));
    }
}
