using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        Console.WriteLine(string.Format("{0} {1} {0}", "a", 5)); Console.WriteLine(string.Format("{0,5}|{0,-5}|{1,8:F2}|{1,-8:F1}|", 42, 3.14159)); Console.WriteLine(string.Format("{{{0}}} {{}}", 1)); Console.WriteLine(string.Format("{0:X4} {0:D6} {1:0.00} {2}", 255, 2.0 / 3, null)); Console.WriteLine($"{1 + 1} {"s" + 't'} {(true ? 1 : 2)} {3.5:F2} {7,4} {-7,-4}|"); int q = 3; Console.WriteLine($"{q}{q:D3}{{q}}{q * 2,6:X}"); Console.WriteLine($@"a\{q}""b"""); try { string.Format("{1}", 1); } catch (FormatException) { Console.WriteLine("bad index"); } try { string.Format("{0", 1); } catch (FormatException) { Console.WriteLine("bad brace"); } Console.WriteLine(string.Format("{0:yyyy-MM-dd} {1:hh\\:mm}", new DateTime(2020, 1, 2), new TimeSpan(1, 2, 3))); Console.WriteLine("{0}-{1}", 1, 'x'); Console.Write("{0}\n", true); Console.WriteLine(string.Format("{0}", new[] { 1, 2 })); Console.WriteLine(string.Format("{0} {1}", new object[] { 1, "z" }));
    }
}
