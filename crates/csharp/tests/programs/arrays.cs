using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        int[] a = new int[3]; a[1] = 5; Console.WriteLine(string.Join(",", a)); int[] b = { 3, 1, 2 }; Array.Sort(b); Console.WriteLine(string.Join(",", b)); Array.Reverse(b); Console.WriteLine(b[0] + " " + b.Length + " " + Array.IndexOf(b, 1));
        int[,] g = new int[2, 3]; g[1, 2] = 7; Console.WriteLine(g[1, 2] + " " + g.GetLength(0) + " " + g.GetLength(1) + " " + g.Length + " " + g.Rank); int[,] h = { { 1, 2 }, { 3, 4 } }; int sum = 0; foreach (int x in h) sum += x; Console.WriteLine(sum + " " + h[1, 0]);
        int[][] j = new int[2][]; j[0] = new[] { 1, 2 }; j[1] = new int[] { 3 }; foreach (var row in j) Console.Write(row.Length + ";"); Console.WriteLine(j[0][1]);
        var c = (int[])b.Clone(); c[0] = 99; Console.WriteLine(b[0] + " " + c[0]); Array.Resize(ref c, 5); Console.WriteLine(string.Join(",", c)); string[] s = new string[2]; Console.WriteLine(s[0] == null); double[] d = new double[2]; d[0] += 1.5; d[0]++; Console.WriteLine(d[0]);
        try { a[3] = 1; } catch (IndexOutOfRangeException e) { Console.WriteLine(e.Message); } try { int minus = -1; a = new int[minus]; } catch (OverflowException) { Console.WriteLine("overflow"); }
        int[] copy = new int[5]; Array.Copy(b, 0, copy, 1, 3); Console.WriteLine(string.Join(",", copy)); Console.WriteLine(Array.Exists(b, q => q > 2) + " " + Array.Find(b, q => q < 3)); bool[] flags = new bool[2]; Console.WriteLine(flags[1]);
    }
}
