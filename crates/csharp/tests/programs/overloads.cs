using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

static class O { public static string F(int x) { return "int"; } public static string F(long x) { return "long"; } public static string F(double x) { return "double"; } public static string F(object x) { return "object"; } public static string F(string x) { return "string"; } public static string F(params int[] x) { return "params"; } public static string G<T>(T x) { return "generic"; } public static string G(int x) { return "int"; } public static string H(float x) { return "float"; } public static string H(double x) { return "double"; } public static string J(IEnumerable<int> x) { return "enumerable"; } public static string J(List<int> x) { return "list"; } }

static class Program
{
    static void Main()
    {
        byte b = 1; uint u = 1; Console.WriteLine(O.F(1) + O.F(1L) + O.F(1f) + O.F(b) + O.F(u) + O.F('a') + O.F("s") + O.F(null as string) + O.F((object)1) + O.F(1, 2) + O.F()); Console.WriteLine(O.G(1) + O.G("s") + O.G<int>(1) + O.H(1) + O.H(1.5) + O.J(new List<int>()) + O.J(new int[0]));
    }
}
