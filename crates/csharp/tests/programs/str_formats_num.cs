using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        double[] v = { 0, 1, -1, 0.5, 1234.5678, -9876.54321, 1e10, 1.5e-7, 123456789.123, 0.1 + 0.2, 1.0 / 3, 2.5, 3.5, -2.5, 1e15, 1e16, 123456789012345680, 5e-324, double.MaxValue };
        string[] f = { "F0", "F2", "F5", "N0", "N2", "E", "E2", "e4", "G", "G3", "G17", "R", "P", "P0", "0", "0.##", "0.###", "#.##", "00.00", "#,##0.0", "0.0E+0", "0%", "C2".Substring(0,0) };
        foreach (double d in v) { foreach (string s in f) Console.Write(d.ToString(s, System.Globalization.CultureInfo.InvariantCulture) + " "); Console.WriteLine(); }
    }
}
