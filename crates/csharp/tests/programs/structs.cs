using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

struct P { public double X, Y; public P(double x, double y) { X = x; Y = y; } public void Move(double d) { X += d; } public double Len { get { return Math.Sqrt(X * X + Y * Y); } } public static P operator +(P a, P b) { return new P(a.X + b.X, a.Y + b.Y); } public static P operator *(double k, P a) { return new P(k * a.X, k * a.Y); } public static P operator -(P a) { return new P(-a.X, -a.Y); } public static bool operator ==(P a, P b) { return a.X == b.X && a.Y == b.Y; } public static bool operator !=(P a, P b) { return !(a == b); } public override bool Equals(object o) { return o is P && (P)o == this; } public override int GetHashCode() { return X.GetHashCode() ^ Y.GetHashCode(); } public override string ToString() { return "(" + X + "," + Y + ")"; } public static implicit operator P(double d) { return new P(d, d); } public static explicit operator double(P p) { return p.Len; } }
class Holder { public P Field; public P Prop { get; set; } public P[] Arr = new P[2]; }
struct Line { public P A; public P B; }

static class Program
{
    static void Main()
    {
        P a = new P(1, 2); P b = a; b.X = 9; Console.WriteLine(a + " " + b); b.Move(1); Console.WriteLine(b.X); Console.WriteLine(2 * (a + b) + " " + -a + " " + (a == b) + " " + a.Equals(new P(1, 2))); var list = new List<P> { a, b }; P c = list[0]; c.Move(5); Console.WriteLine(list[0] + " " + c); list[0].Move(100); Console.WriteLine(list[0]); P[] arr = { a, b }; arr[0].X = 50; arr[0].Move(1); Console.WriteLine(arr[0] + " " + a); var h = new Holder(); h.Field.X = 3; h.Field.Move(1); h.Arr[1].Y = 8; Console.WriteLine(h.Field + " " + h.Arr[1] + " " + h.Prop); h.Prop = a; Console.WriteLine(h.Prop.X); object box = a; a.X = 77; Console.WriteLine(box + " " + a); Line l; l.A = a; l.B = new P(); l.B.Y = 4; Line m = l; m.A.X = 0; Console.WriteLine(l.A + " " + m.A + " " + m.B); P imp = 3.0; Console.WriteLine(imp + " " + (double)new P(3, 4)); foreach (P p in arr) Console.Write(p + " "); Console.WriteLine(); var d = new Dictionary<P, string>(); d[new P(1, 1)] = "x"; Console.WriteLine(d[new P(1, 1)]); P def = default(P); Console.WriteLine(def);
    }
}
