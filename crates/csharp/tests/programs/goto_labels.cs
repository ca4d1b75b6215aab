// Jumps out of loops, backwards, out of try, within switch, to labels of blocks around.
using System;
class P
{
    static int Find(int[,] a, int x) { int i = 0; for (i = 0; i < 3; i++) for (int j = 0; j < 3; j++) if (a[i, j] == x) goto found; return -1; found: return i; }
    static void Main()
    {
        int n = 0; again: n++; if (n < 3) goto again; Console.WriteLine(n);
        Console.WriteLine(Find(new int[,] { { 1, 2, 3 }, { 4, 5, 6 }, { 7, 8, 9 } }, 8) + " " + Find(new int[3, 3], 1));
        try { for (int i = 0; ; i++) { try { if (i == 2) goto end; Console.Write(i); } finally { Console.Write("f"); } } } finally { Console.WriteLine("F"); } 
        end: Console.WriteLine("end");
        for (int k = 0; k < 4; k++)
            switch (k) { case 0: Console.Write("zero "); goto case 2; case 1: Console.Write("one "); goto default; case 2: Console.Write("two "); break; default: Console.Write("other "); if (k == 3) goto done; break; }
        done: Console.WriteLine();
        { int q = 1; inner: if (q < 4) { q *= 2; goto inner; } Console.WriteLine(q); }
        string s = "b"; switch (s) { case "a": Console.WriteLine("A"); break; case "b": goto case "a"; }
    }
}
