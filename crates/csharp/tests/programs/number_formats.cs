using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        double x = 1234.5678; int n = -42;
        foreach (string f in new[] { "F0", "F2", "F", "N0", "N2", "N", "E2", "e3", "E", "G4", "G", "P", "P1", "0", "0.00", "0.###", "#,##0.00", "000000.0", "#", "0.0%", "0.00E+00" }) Console.WriteLine(f + ": " + x.ToString(f));
        foreach (string f in new[] { "D", "D5", "X", "x4", "N0", "F1", "00000", "#,#", "G" }) Console.WriteLine(f + ": " + n.ToString(f));
        Console.WriteLine((0.0).ToString("#.##") + "|" + (0.5).ToString("#.##") + "|" + (-1.5).ToString("0.0;(0.0);zero") + "|" + (0.0).ToString("0.0;(0.0);zero") + "|" + 12345678.ToString("#,##0,") + "|" + 255.ToString("X2"));
        Console.WriteLine(2.5.ToString("F0") + " " + 3.5.ToString("F0") + " " + 0.125.ToString("F2") + " " + 1.005.ToString("F2") + " " + (-0.4).ToString("F0"));
    }
}
