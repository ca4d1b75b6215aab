using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class P
{
    static void Main()
    {
        for (int seed = -3; seed < 22; seed++)
        {
            var r = new Random(seed * 1000003 + seed);
            uint hash = 2166136261;
            string all = "";
            for (int i = 0; i < 25; i++) all += r.Next() + " " + r.Next(100) + " " + r.Next(-50, 50) + " " + r.NextDouble().ToString("R") + " ";
            byte[] b = new byte[9]; r.NextBytes(b); all += string.Join(",", b) + r.Next(int.MinValue, int.MaxValue);
            foreach (char ch in all) hash = unchecked((hash ^ ch) * 16777619);
            Console.WriteLine(seed + " " + hash.ToString("x8"));
        }
    }
}
