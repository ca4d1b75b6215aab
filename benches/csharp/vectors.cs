// 10^6 turns of vector arithmetic: a sum, a product with a number, a cross product and a length in each. The struct
// stands here as script components have it from RhinoCommon.
using System;

struct Vector3d
{
    public double X; public double Y; public double Z;
    public Vector3d(double x, double y, double z) { X = x; Y = y; Z = z; }
    public double Length { get { return Math.Sqrt(X * X + Y * Y + Z * Z); } }
    public static Vector3d operator +(Vector3d a, Vector3d b) { return new Vector3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
    public static Vector3d operator *(Vector3d a, double k) { return new Vector3d(a.X * k, a.Y * k, a.Z * k); }
    public static Vector3d CrossProduct(Vector3d a, Vector3d b)
    {
        return new Vector3d(a.Y * b.Z - b.Y * a.Z, a.Z * b.X - b.Z * a.X, a.X * b.Y - b.X * a.Y);
    }
}

class P
{
    static double Run(int n)
    {
        var axis = new Vector3d(0.6, 0.0, 0.8);
        var at = new Vector3d(1, 2, 3);
        double sum = 0;
        for (int i = 0; i < n; i++)
        {
            at = at + Vector3d.CrossProduct(axis, at) * 0.001;
            sum += at.Length;
        }
        return sum;
    }
    static void Main() { Console.WriteLine(Run(1000000).ToString("R")); }
}
