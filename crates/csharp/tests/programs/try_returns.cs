using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class T { static int n; public static int A() { try { return 1; } finally { n = 5; } } public static int B() { int x = 1; try { return x; } finally { x = 9; } } public static int C() { foreach (int i in new[] { 1, 2, 3 }) { try { if (i == 2) return i * 10; } finally { Console.Write("f" + i + " "); } } return -1; } public static int D() { while (true) { try { try { break; } finally { Console.Write("in "); } } finally { Console.Write("out "); } } return n; } public static string E() { try { try { throw new Exception("1"); } finally { Console.Write("x "); } } catch (Exception e) { return e.Message; } finally { Console.Write("y "); } } }

static class Program
{
    static void Main()
    {
        Console.WriteLine(T.A() + " " + T.B()); Console.WriteLine(T.C()); Console.WriteLine(T.D()); Console.WriteLine(T.E());
    }
}
