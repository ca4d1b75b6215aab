using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

enum Color { Red, Green = 5, Blue } [Flags] enum Opt { None = 0, A = 1, B = 2, C = 4, All = 7 } enum Small : byte { X = 200 }

static class Program
{
    static void Main()
    {
        Color c = Color.Green; Console.WriteLine(c + " " + (int)c + " " + (Color)6 + " " + (Color)99 + " " + (c == Color.Green) + " " + (c + 1) + " " + (Color.Blue - Color.Green)); Opt o = Opt.A | Opt.C; Console.WriteLine(o + " " + (o & Opt.B) + " " + o.HasFlag(Opt.C) + " " + (Opt)7 + " " + (Opt)8 + " " + ~Opt.A); Console.WriteLine((Small)200); Console.WriteLine(Enum.Parse(typeof(Color), "Blue")); foreach (Color x in Enum.GetValues(typeof(Color))) Console.Write(x + " "); Console.WriteLine(string.Join(",", Enum.GetNames(typeof(Color)))); switch (c) { case Color.Red: Console.WriteLine("r"); break; case Color.Green: Console.WriteLine("g"); break; } Color d; Console.WriteLine(Enum.TryParse("Red", out d) + " " + d); var dict = new Dictionary<Color, int> { { Color.Red, 1 } }; Console.WriteLine(dict[Color.Red]); Console.WriteLine(c.ToString("D") + string.Format("{0}", c)); object box = c; Console.WriteLine(box.Equals(Color.Green) + " " + (int)(Color)box);
    }
}
