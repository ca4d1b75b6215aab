using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        var c = System.Globalization.CultureInfo.InvariantCulture; double[] v = { 5.25, -5.25, 0, 1234567.891, 0.004 };
        string[] f = { "0.0;(0.0);zero", "+0;-0", "0.00' m'", "\"pre\"0", "#;;", "0,.0", "0,0.00", "#.#", "0.##\\%", "##0.00%", "0000.0000", "#######", "-0", "x0y0", "0.0#####", "e0", "0e+00" };
        foreach (string s in f) { foreach (double d in v) Console.Write("[" + d.ToString(s, c) + "]"); Console.WriteLine(); }
    }
}
