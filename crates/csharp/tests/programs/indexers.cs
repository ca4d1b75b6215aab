using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class Grid { double[] d = new double[9]; public double this[int i, int j] { get { return d[i * 3 + j]; } set { d[i * 3 + j] = value; } } public string this[string s] { get { return s + "!"; } } }

static class Program
{
    static void Main()
    {
        var g = new Grid(); g[1, 2] = 5; g[1, 2] += 2; g[0, 0]--; Console.WriteLine(g[1, 2] + " " + g[0, 0] + " " + g["k"]);
    }
}
