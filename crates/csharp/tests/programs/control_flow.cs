using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class Program
{
    static void Main()
    {
        int i = 0; while (true) { if (++i > 5) break; if (i % 2 == 0) continue; Console.Write(i + " "); } do { Console.Write(i-- + " "); } while (i > 3); Console.WriteLine(); for (int a = 0, b = 10; a < b; a += 3, b--) Console.Write(a + ":" + b + " "); Console.WriteLine(); for (int x = 0; x < 3; x++) { for (int y = 0; y < 3; y++) { if (y == 2) break; if (x == 1) goto next; Console.Write(x + "" + y + " "); } next: ; } Console.WriteLine(); foreach (string s in new[] { "a", "b", "q", "z" }) { switch (s) { case "a": case "b": Console.Write("ab "); break; case "q": goto default; default: Console.Write("def "); break; } } Console.WriteLine(); int n = 3; switch (n) { case 1: Console.Write("1"); goto case 2; case 2: Console.Write("2"); break; case 3: Console.Write("3"); goto case 1; } Console.WriteLine(); int k = n > 2 ? n < 5 ? 1 : 2 : 3; Console.WriteLine(k); int p = 5; p = p++ + ++p; Console.WriteLine(p); int z = 10; z -= z++ - --z; Console.WriteLine(z); bool t = true; t &= false; Console.WriteLine(t | true ^ true);
    }
}
