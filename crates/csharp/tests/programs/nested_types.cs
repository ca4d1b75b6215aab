using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class Outer { int secret = 42; public class Inner { public int Read(Outer o) { return o.secret; } public enum Kind { A, B } } public struct Pt { public int X; } public static Inner Make() { return new Inner(); } private const int C = 5; public class Deep { public int G() { return C; } } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(Outer.Make().Read(new Outer()) + " " + Outer.Inner.Kind.B + " " + new Outer.Pt { X = 3 }.X + " " + new Outer.Deep().G());
    }
}
