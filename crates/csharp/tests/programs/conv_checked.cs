using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        int big = int.MaxValue;
        try { checked { big++; } } catch (OverflowException e) { Console.WriteLine(e.Message); }
        try { Console.WriteLine(checked((byte)(big & 0x1ff))); } catch (OverflowException) { Console.WriteLine("byte"); }
        try { double d = 1e20; Console.WriteLine(checked((int)d)); } catch (OverflowException) { Console.WriteLine("double"); }
        try { double d = double.NaN; Console.WriteLine(checked((long)d)); } catch (OverflowException) { Console.WriteLine("nan"); }
        try { int m = int.MinValue; Console.WriteLine(checked(-m)); } catch (OverflowException) { Console.WriteLine("neg"); }
        try { long l = long.MinValue; Console.WriteLine(checked(l - 1)); } catch (OverflowException) { Console.WriteLine("long"); }
        try { uint u = 0; Console.WriteLine(checked(u - 1)); } catch (OverflowException) { Console.WriteLine("uint"); }
        try { ulong u = ulong.MaxValue; Console.WriteLine(checked(u * 2)); } catch (OverflowException) { Console.WriteLine("ulong"); }
        try { int m = int.MinValue; int minus = -1; Console.WriteLine(m / minus); } catch (OverflowException) { Console.WriteLine("div"); } catch (ArithmeticException e) { Console.WriteLine(e.GetType()); }
        unchecked { int x = int.MaxValue; x += 10; Console.WriteLine(x); byte b = (byte)300; Console.WriteLine(b); }
        byte bb = 255; bb++; Console.WriteLine(bb); sbyte sb = 127; sb++; Console.WriteLine(sb); short sh = short.MinValue; sh--; Console.WriteLine(sh);
        try { checked { byte q = 255; q++; Console.WriteLine(q); } } catch (OverflowException) { Console.WriteLine("q"); }
        try { checked { byte q = 250; q += 10; Console.WriteLine(q); } } catch (OverflowException) { Console.WriteLine("q2"); }
    }
}
