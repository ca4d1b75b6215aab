using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;

class Body { public double X, Y, Z, VX, VY, VZ, M; }

static class Program
{
    static void Main()
    {
        var b = new List<Body>(); for (int i = 0; i < 4; i++) b.Add(new Body { X = i, Y = i * i, Z = 1.0 / (i + 1), M = 1 + i }); for (int s = 0; s < 50; s++) { for (int i = 0; i < b.Count; i++) for (int j = i + 1; j < b.Count; j++) { double dx = b[i].X - b[j].X, dy = b[i].Y - b[j].Y, dz = b[i].Z - b[j].Z; double d2 = dx * dx + dy * dy + dz * dz; double mag = 0.001 / (d2 * Math.Sqrt(d2)); b[i].VX -= dx * b[j].M * mag; b[i].VY -= dy * b[j].M * mag; b[i].VZ -= dz * b[j].M * mag; b[j].VX += dx * b[i].M * mag; b[j].VY += dy * b[i].M * mag; b[j].VZ += dz * b[i].M * mag; } foreach (var o in b) { o.X += 0.001 * o.VX; o.Y += 0.001 * o.VY; o.Z += 0.001 * o.VZ; } } foreach (var o in b) Console.WriteLine(o.X.ToString("R") + " " + o.VY.ToString("R"));
    }
}
