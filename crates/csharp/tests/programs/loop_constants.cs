using System;
using System.Collections.Generic;

class P
{
    static IEnumerable<double> Halves(int n)
    {
        for (int i = 0; i < n; i++)
        {
            yield return i * 0.5 + 0.25;
            if (i % 3 == 2) yield return -1.5;
        }
    }

    static int Found(int[] a, int wanted)
    {
        for (int i = 0; i < a.Length; i++)
        {
            try { if (a[i] / (i - 2) == wanted) return i * 1000; }
            catch (DivideByZeroException) { continue; }
            finally { a[i] += 10; }
        }
        return -1;
    }

    static void Main()
    {
        double s = 0;
        for (int i = 0; i < 3; i++) { s = i == 1 ? -0.0 : s * 1.0; Console.WriteLine(1 / s); }
        for (int i = 5; i < 5; i++) Console.WriteLine("never");
        for (int i = 0; i < 0; i++) Console.WriteLine("never");
        int n = 0;
        for (int i = 0; i < 10; i++) { if (i % 2 == 0) continue; if (i > 7) break; n += i * 3; }
        Console.WriteLine(n);
        for (int i = 10; i > 0; i -= 3) n = n * 7 + i;
        for (int i = 0; i < 100; i += 33) n ^= i;
        for (int i = 0; i < 1000; i += 200) n += i >> 2;
        Console.WriteLine(n);
        for (int i = 0; i < 4; i++) { i++; n += i; }
        Console.WriteLine(n);
        long big = 0;
        for (long i = 1; i < 3000000000L; i *= 3) big += i % 1000L - i / 7L;
        Console.WriteLine(big + " " + (big << 3) + " " + (big >> 2) + " " + (big & 0xFFFL));
        for (int i = int.MaxValue - 2; i > 0; i++) n++;
        Console.WriteLine(n);
        double nan = double.NaN;
        int count = 0;
        for (int i = 0; i < 4; i++)
        {
            if (nan < 1.0) count += 1; else count += 10;
            if (!(nan >= 1.0)) count += 100;
            if (nan != nan) count += 1000;
            if (nan == 1.0 || nan > 2.0 || nan <= 3.0) count += 10000;
            while (nan > 0.5) count++;
        }
        Console.WriteLine(count);
        foreach (double x in Halves(5)) Console.Write(x + " ");
        Console.WriteLine();
        Console.WriteLine(Found(new[] { 8, 6, 4, 5, 6 }, 5) + " " + Found(new[] { 1 }, 5));
        int[] powers = new int[20];
        for (int i = 0; i < 20; i++) for (int j = 0; j < 20; j++) powers[(i * 7 + j * 3) % 20] += i * 2 - j % 3 + 1;
        Console.WriteLine(string.Join(",", powers));
        var made = new List<Func<int>>();
        for (int i = 0; i < 3; i++) { int k = i * 100 + 7; made.Add(() => k + 7); }
        foreach (var f in made) Console.Write(f() + " ");
        int t = 0;
        do { t += 13; if (t == 39) continue; } while (t < 50);
        Console.WriteLine(t);
        try { for (int i = 3; i > -3; i--) Console.Write(100 / i + " "); } catch (DivideByZeroException) { Console.WriteLine("zero"); }
        int least = int.MinValue;
        try { for (int i = -1; i < 0; i++) Console.Write(least % i); } catch (ArithmeticException) { Console.WriteLine("overflow"); }
        checked
        {
            try { int m = int.MaxValue - 1; for (int i = 0; i < 9; i++) m += 1; } catch (OverflowException) { Console.WriteLine("checked"); }
        }
        Console.WriteLine((1 << 33) + " " + (-17 >> 2) + " " + -17 / 5 + " " + -17 % 5 + " " + (5 & 12) + " " + (5 | 12) + " " + (5 ^ 12));
    }
}
