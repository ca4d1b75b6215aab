using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

[Flags] enum Side { None = 0, Left = 1, Right = 2, Top = 4, Bottom = 8, All = Left | Right | Top | Bottom, Ends = Left | Right }
enum Plain : byte { A = 1, B, C = 10, D, E = 200 }
enum Dup { X = 1, Y = 1, Z = 2 }
class P { static void Main() {
 Side s = Side.Left | Side.Top; Console.WriteLine(s); Console.WriteLine((int)s); Console.WriteLine(s & Side.Left); Console.WriteLine(s & ~Side.Left); Console.WriteLine(s ^ Side.All); Console.WriteLine(Side.Left | Side.Right); Console.WriteLine((Side)16); Console.WriteLine((Side)17); Console.WriteLine(Side.None); Console.WriteLine((Side)0);
 Console.WriteLine(s.HasFlag(Side.Top) + " " + s.HasFlag(Side.Ends) + " " + s.HasFlag(Side.None));
 s |= Side.Bottom; s &= ~Side.Left; Console.WriteLine(s); s++; Console.WriteLine(s);
 Plain p = Plain.B; p++; Console.WriteLine(p); p = (Plain)11; Console.WriteLine(p); Console.WriteLine((Plain)5); Console.WriteLine(p + 1); Console.WriteLine(Plain.D - Plain.A); Console.WriteLine(p > Plain.C); Console.WriteLine(p.ToString("D") + p.ToString("X") + p.ToString("G"));
 Console.WriteLine((Plain)Enum.Parse(typeof(Plain), "C")); Console.WriteLine((Plain)Enum.Parse(typeof(Plain), "d", true)); Side parsed; Console.WriteLine(Enum.TryParse("Left, Bottom", out parsed) + " " + parsed); Console.WriteLine(Enum.TryParse("Nope", out parsed) + " " + parsed);
 foreach (Plain q in Enum.GetValues(typeof(Plain))) Console.Write(q + "=" + (byte)q + " "); Console.WriteLine(); Console.WriteLine(string.Join("|", Enum.GetNames(typeof(Side)))); Console.WriteLine(Enum.IsDefined(typeof(Plain), "B") + " " + Enum.IsDefined(typeof(Plain), (byte)3)); Console.WriteLine(Enum.GetName(typeof(Plain), 10));
 Console.WriteLine(Dup.X == Dup.Y); Console.WriteLine(p.GetType() + " " + p.Equals(Plain.D) + " " + p.CompareTo(Plain.A)); object o = Plain.A; Console.WriteLine(o is Plain); Console.WriteLine((int)(Plain)o); Console.WriteLine($"{Plain.A} {Plain.B:D} {s,20}|");
 switch (p) { case Plain.A: Console.WriteLine("a"); break; case Plain.D: Console.WriteLine("dd"); goto case Plain.A; default: break; }
 var d = new Dictionary<Plain, int> { { Plain.A, 1 }, { Plain.E, 2 } }; Console.WriteLine(d[Plain.E]); Console.WriteLine(default(Plain)); Console.WriteLine((Side)(-1)); Console.WriteLine(Enum.GetUnderlyingType(typeof(Plain)));
} }
