using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        const int N = 3; const string S = "v" + "w"; const double D = N / 2 + 0.5; Console.WriteLine(N + S + D); const byte B = N; byte c = B + 1; Console.WriteLine(c); int[] a = new int[N]; Console.WriteLine(a.Length); switch (3) { case N: Console.WriteLine("N"); break; } const bool T = N > 2 && S.Length == 0 == false; Console.WriteLine(T); const char C = 'a'; Console.WriteLine((char)(C + 1)); const long L = int.MaxValue + 1L; Console.WriteLine(L); const uint U = 0xFFFFFFFF; Console.WriteLine(U); const float F = 1.1f; Console.WriteLine(F * 2); const int Neg = -5 % 3; Console.WriteLine(Neg + (7 ^ 2) + (1 << 4) + ~0); const string Null = null; Console.WriteLine(Null == null); Console.WriteLine(int.MaxValue + " " + double.Epsilon + " " + float.MinValue + " " + char.MaxValue.ToString().Length + " " + long.MinValue + " " + byte.MaxValue + sbyte.MinValue + short.MaxValue + ushort.MaxValue + ulong.MaxValue + " " + double.MinValue + Math.PI);
    }
}
