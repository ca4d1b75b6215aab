using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

struct Cx { public readonly double Re, Im; public Cx(double r, double i) { Re = r; Im = i; } public static Cx operator *(Cx a, Cx b) { return new Cx(a.Re * b.Re - a.Im * b.Im, a.Re * b.Im + a.Im * b.Re); } public static Cx operator +(Cx a, Cx b) { return new Cx(a.Re + b.Re, a.Im + b.Im); } public static Cx operator ++(Cx a) { return new Cx(a.Re + 1, a.Im); } public static bool operator <(Cx a, Cx b) { return a.Re < b.Re; } public static bool operator >(Cx a, Cx b) { return a.Re > b.Re; } public static bool operator true(Cx a) { return a.Re != 0; } public static bool operator false(Cx a) { return a.Re == 0; } public static Cx operator !(Cx a) { return new Cx(-a.Re, -a.Im); } public static implicit operator Cx(double d) { return new Cx(d, 0); } public static explicit operator int(Cx c) { return (int)c.Re; } public override string ToString() { return Re + "+" + Im + "i"; } public double Abs2 => Re * Re + Im * Im; }

static class Program
{
    static void Main()
    {
        Cx z = 0, c = new Cx(-0.5, 0.5); int n = 0; while (z.Abs2 < 4 && n < 50) { z = z * z + c; n++; } Console.WriteLine(n); z = new Cx(1, 2); z += 1; z++; Console.WriteLine(z + " " + (z > c) + " " + !z + " " + (int)z); if (z) Console.WriteLine("true"); Cx? q = null; Console.WriteLine((q + z).HasValue); z *= 2; Console.WriteLine(z);
    }
}
