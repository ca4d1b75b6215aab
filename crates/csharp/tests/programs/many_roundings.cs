using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static ulong state = 777;
    static uint Next() { state = unchecked(state * 6364136223846793005UL + 1442695040888963407UL); return (uint)(state >> 33); }
    static void Main()
    {
        uint hash = 2166136261;
        for (int i = 1; i <= 2500; i++)
        {
            double x = ((int)Next() - 1073741824) / Math.Pow(2, Next() % 30);
            if (i % 3 == 0) x = ((int)(Next() % 20001) - 10000) / 200.0;
            string all = "";
            for (int d = 0; d < 4; d++) all += Math.Round(x, d).ToString("R") + "/" + Math.Round(x, d, MidpointRounding.AwayFromZero).ToString("R") + " ";
            all += Math.Floor(x) + " " + Math.Ceiling(x) + " " + Math.Truncate(x) + " " + (int)x + " " + Convert.ToInt32(x) + " " + (long)(x * 1000) + " " + Math.IEEERemainder(x, 7).ToString("R") + " " + (x % 7).ToString("R") + " " + (float)x;
            foreach (char ch in all) hash = unchecked((hash ^ ch) * 16777619);
            if (i % 100 == 0) { Console.WriteLine(i + " " + hash.ToString("x8")); hash = 2166136261; }
        }
    }
}
