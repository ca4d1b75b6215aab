using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class M { public static double[,] Mul(double[,] a, double[,] b) { int n = a.GetLength(0), m = b.GetLength(1), k = a.GetLength(1); var c = new double[n, m]; for (int i = 0; i < n; i++) for (int j = 0; j < m; j++) for (int l = 0; l < k; l++) c[i, j] += a[i, l] * b[l, j]; return c; } }

static class Program
{
    static void Main()
    {
        var c = M.Mul(new double[,] { { 1, 2 }, { 3, 4 } }, new double[,] { { 5, 6 }, { 7, 8 } }); for (int i = 0; i < 2; i++) Console.WriteLine(c[i, 0] + " " + c[i, 1]);
    }
}
