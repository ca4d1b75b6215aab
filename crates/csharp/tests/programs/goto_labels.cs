using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        int i = 0; again: i++; if (i < 3) goto again; Console.WriteLine(i); for (int a = 0; a < 3; a++) { for (int b = 0; b < 3; b++) { if (a * b == 2) goto done; Console.Write(a * b + " "); } } done: Console.WriteLine("done"); int k = 2; switch (k) { case 1: Console.WriteLine(1); goto default; case 2: k = 5; goto case 1; default: Console.WriteLine("def" + k); break; } int n = 0; do { n++; if (n == 2) continue; if (n > 4) break; Console.Write(n); } while (n < 10); Console.WriteLine(); while (true) { if (n-- < 0) break; if (n % 2 == 0) continue; Console.Write(n); } Console.WriteLine(); for (int a = 0, b = 10; a < b; a += 3, b--) Console.Write(a + ":" + b + " "); Console.WriteLine(); for (; ; ) { break; } foreach (char c in "xyz") { if (c == 'y') continue; Console.Write(c); } Console.WriteLine(); { int q = 1; { int r = q + 1; Console.WriteLine(r); } } if (n > 0) ; else Console.WriteLine("neg");
    }
}
