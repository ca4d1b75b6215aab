// 10^6 turns over members of RhinoCommon's points and vectors. Katydid runs the marked lines in a script component with
// its own Rhino.Geometry; Mono, which cannot run RhinoCommon, runs them with the structs that stand here.
using System;

struct Vector3d
{
    public double X; public double Y; public double Z;
    public Vector3d(double x, double y, double z) { X = x; Y = y; Z = z; }
    public double Length { get { return Math.Sqrt(X * X + Y * Y + Z * Z); } }
    public bool Unitize()
    {
        double length = Length;
        if (length == 0) return false;
        X /= length; Y /= length; Z /= length;
        return true;
    }
    public static Vector3d operator +(Vector3d a, Vector3d b) { return new Vector3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
    public static Vector3d operator *(Vector3d a, double k) { return new Vector3d(a.X * k, a.Y * k, a.Z * k); }
    public static double operator *(Vector3d a, Vector3d b) { return a.X * b.X + a.Y * b.Y + a.Z * b.Z; }
    public static Vector3d CrossProduct(Vector3d a, Vector3d b)
    {
        return new Vector3d(a.Y * b.Z - b.Y * a.Z, a.Z * b.X - b.Z * a.X, a.X * b.Y - b.X * a.Y);
    }
}

struct Point3d
{
    public double X; public double Y; public double Z;
    public Point3d(double x, double y, double z) { X = x; Y = y; Z = z; }
    public double DistanceTo(Point3d p)
    {
        double x = p.X - X, y = p.Y - Y, z = p.Z - Z;
        return Math.Sqrt(x * x + y * y + z * z);
    }
    public static Point3d operator +(Point3d a, Vector3d b) { return new Point3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
    public static Vector3d operator -(Point3d a, Point3d b) { return new Vector3d(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
}

class P
{
    // BEGIN
    static double Run(int n)
    {
        Point3d centre = new Point3d(1, 2, 3);
        Point3d at = new Point3d(4, 6, 3);
        Vector3d axis = new Vector3d(0.6, 0.0, 0.8);
        double sum = 0;
        for (int i = 0; i < n; i++)
        {
            Vector3d away = at - centre;
            Vector3d turn = Vector3d.CrossProduct(axis, away);
            turn.Unitize();
            at = at + turn * 0.01;
            sum += at.DistanceTo(centre) + turn * away;
        }
        return sum;
    }
    // END
    static void Main() { Console.WriteLine(Run(1000000).ToString("R")); }
}
