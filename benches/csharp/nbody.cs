// Five bodies in lists of numbers, 50,000 steps; the energy before and after.
using System;
using System.Collections.Generic;

class P
{
    static double Energy(List<double> x, List<double> y, List<double> z, List<double> u, List<double> v, List<double> w, List<double> m)
    {
        double e = 0;
        for (int i = 0; i < m.Count; i++)
        {
            e += 0.5 * m[i] * (u[i] * u[i] + v[i] * v[i] + w[i] * w[i]);
            for (int j = i + 1; j < m.Count; j++)
            {
                double dx = x[i] - x[j], dy = y[i] - y[j], dz = z[i] - z[j];
                e -= m[i] * m[j] / Math.Sqrt(dx * dx + dy * dy + dz * dz);
            }
        }
        return e;
    }

    static void Step(List<double> x, List<double> y, List<double> z, List<double> u, List<double> v, List<double> w, List<double> m, double dt)
    {
        int n = m.Count;
        for (int i = 0; i < n; i++)
        {
            for (int j = i + 1; j < n; j++)
            {
                double dx = x[i] - x[j], dy = y[i] - y[j], dz = z[i] - z[j];
                double d2 = dx * dx + dy * dy + dz * dz;
                double mag = dt / (d2 * Math.Sqrt(d2));
                double mi = m[i] * mag, mj = m[j] * mag;
                u[i] -= dx * mj; v[i] -= dy * mj; w[i] -= dz * mj;
                u[j] += dx * mi; v[j] += dy * mi; w[j] += dz * mi;
            }
        }
        for (int i = 0; i < n; i++)
        {
            x[i] += dt * u[i]; y[i] += dt * v[i]; z[i] += dt * w[i];
        }
    }

    static void Main()
    {
        var x = new List<double> { 0, 4.84, 8.34, 12.89, 15.38 };
        var y = new List<double> { 0, -1.16, 4.12, -15.11, -25.92 };
        var z = new List<double> { 0, -0.10, -0.40, -0.22, 0.18 };
        var u = new List<double> { 0, 0.606, -1.01, 1.08, 0.979 };
        var v = new List<double> { 0, 2.81, 1.82, 0.868, 0.594 };
        var w = new List<double> { 0, -0.02, 0.008, -0.01, -0.034 };
        var m = new List<double> { 39.47, 0.037, 0.011, 0.0017, 0.002 };
        Console.WriteLine(Energy(x, y, z, u, v, w, m).ToString("R"));
        for (int i = 0; i < 50000; i++) Step(x, y, z, u, v, w, m, 0.001);
        Console.WriteLine(Energy(x, y, z, u, v, w, m).ToString("R"));
    }
}
