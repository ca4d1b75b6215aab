namespace Rhino
{
    public static class RhinoMath
    {
        public const double UnsetValue = -1.23432101234321e+308;
        public const double ZeroTolerance = 2.3283064365386962890625e-10;
        public const double SqrtEpsilon = 1.490116119385e-8;
        public static double ToRadians(double degrees) { return degrees * Math.PI / 180.0; }
        public static double ToDegrees(double radians) { return radians * 180.0 / Math.PI; }
        public static bool IsValidDouble(double x) { return x != UnsetValue && !double.IsNaN(x) && !double.IsInfinity(x); }
        public static double Clamp(double x, double a, double b) { return x < a ? a : x > b ? b : x; }
        public static int Clamp(int x, int a, int b) { return x < a ? a : x > b ? b : x; }
    }
}
namespace Rhino.Geometry
{
    public struct Point2d
    {
        public double X; public double Y;
        public Point2d(double x, double y) { X = x; Y = y; }
        public double DistanceTo(Point2d p) { return Math.Sqrt((X - p.X) * (X - p.X) + (Y - p.Y) * (Y - p.Y)); }
        public override string ToString() { return X + "," + Y; }
    }
    public struct Point3d
    {
        public double X; public double Y; public double Z;
        public Point3d(double x, double y, double z) { X = x; Y = y; Z = z; }
        public Point3d(Point3d p) { X = p.X; Y = p.Y; Z = p.Z; }
        public Point3d(Vector3d v) { X = v.X; Y = v.Y; Z = v.Z; }
        public static Point3d Origin { get { return new Point3d(0, 0, 0); } }
        public static Point3d Unset { get { return new Point3d(RhinoMath.UnsetValue, RhinoMath.UnsetValue, RhinoMath.UnsetValue); } }
        public bool IsValid { get { return RhinoMath.IsValidDouble(X) && RhinoMath.IsValidDouble(Y) && RhinoMath.IsValidDouble(Z); } }
        public double DistanceTo(Point3d p) { return (this - p).Length; }
        public double DistanceToSquared(Point3d p) { return (this - p).SquareLength; }
        public static Point3d Add(Point3d a, Vector3d b) { return a + b; }
        public static Point3d operator +(Point3d a, Vector3d b) { return new Point3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Point3d operator +(Vector3d a, Point3d b) { return new Point3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Point3d operator +(Point3d a, Point3d b) { return new Point3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Point3d operator -(Point3d a, Vector3d b) { return new Point3d(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
        public static Vector3d operator -(Point3d a, Point3d b) { return new Vector3d(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
        public static Point3d operator -(Point3d a) { return new Point3d(-a.X, -a.Y, -a.Z); }
        public static Point3d operator *(Point3d a, double k) { return new Point3d(a.X * k, a.Y * k, a.Z * k); }
        public static Point3d operator *(double k, Point3d a) { return a * k; }
        public static Point3d operator /(Point3d a, double k) { return a * (1.0 / k); }
        public static bool operator ==(Point3d a, Point3d b) { return a.X == b.X && a.Y == b.Y && a.Z == b.Z; }
        public static bool operator !=(Point3d a, Point3d b) { return !(a == b); }
        public static implicit operator Vector3d(Point3d p) { return new Vector3d(p.X, p.Y, p.Z); }
        public override bool Equals(object o) { return o is Point3d && (Point3d)o == this; }
        public override int GetHashCode() { return X.GetHashCode() ^ Y.GetHashCode() ^ Z.GetHashCode(); }
        public override string ToString() { return X + "," + Y + "," + Z; }
    }
    public struct Vector3d
    {
        public double X; public double Y; public double Z;
        public Vector3d(double x, double y, double z) { X = x; Y = y; Z = z; }
        public Vector3d(Point3d p) { X = p.X; Y = p.Y; Z = p.Z; }
        public Vector3d(Vector3d v) { X = v.X; Y = v.Y; Z = v.Z; }
        public static Vector3d Zero { get { return new Vector3d(0, 0, 0); } }
        public static Vector3d XAxis { get { return new Vector3d(1, 0, 0); } }
        public static Vector3d YAxis { get { return new Vector3d(0, 1, 0); } }
        public static Vector3d ZAxis { get { return new Vector3d(0, 0, 1); } }
        public static Vector3d Unset { get { return new Vector3d(RhinoMath.UnsetValue, RhinoMath.UnsetValue, RhinoMath.UnsetValue); } }
        public double SquareLength { get { return X * X + Y * Y + Z * Z; } }
        public double Length { get { return Math.Sqrt(SquareLength); } }
        public bool IsZero { get { return X == 0 && Y == 0 && Z == 0; } }
        public bool IsValid { get { return RhinoMath.IsValidDouble(X) && RhinoMath.IsValidDouble(Y) && RhinoMath.IsValidDouble(Z); } }
        public bool Unitize()
        {
            double n = Length;
            if (!(n > 0)) return false;
            X /= n; Y /= n; Z /= n;
            return true;
        }
        public bool Reverse() { X = -X; Y = -Y; Z = -Z; return true; }
        // Rodrigues' formula.
        public bool Rotate(double angle, Vector3d axis)
        {
            if (!axis.Unitize()) return false;
            double c = Math.Cos(angle), s = Math.Sin(angle);
            Vector3d v = this * c + CrossProduct(axis, this) * s + axis * ((axis * this) * (1 - c));
            X = v.X; Y = v.Y; Z = v.Z;
            return true;
        }
        public static Vector3d CrossProduct(Vector3d a, Vector3d b) { return new Vector3d(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X); }
        public static double VectorAngle(Vector3d a, Vector3d b)
        {
            if (!a.Unitize() || !b.Unitize()) return RhinoMath.UnsetValue;
            return Math.Atan2(CrossProduct(a, b).Length, a * b);
        }
        public static Vector3d Multiply(Vector3d a, double k) { return a * k; }
        public static Vector3d Multiply(double k, Vector3d a) { return a * k; }
        public static double Multiply(Vector3d a, Vector3d b) { return a * b; }
        public static Vector3d Add(Vector3d a, Vector3d b) { return a + b; }
        public static Vector3d Subtract(Vector3d a, Vector3d b) { return a - b; }
        public static Vector3d operator +(Vector3d a, Vector3d b) { return new Vector3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Vector3d operator -(Vector3d a, Vector3d b) { return new Vector3d(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
        public static Vector3d operator -(Vector3d a) { return new Vector3d(-a.X, -a.Y, -a.Z); }
        public static Vector3d operator *(Vector3d a, double k) { return new Vector3d(a.X * k, a.Y * k, a.Z * k); }
        public static Vector3d operator *(double k, Vector3d a) { return a * k; }
        public static double operator *(Vector3d a, Vector3d b) { return a.X * b.X + a.Y * b.Y + a.Z * b.Z; }
        public static Vector3d operator /(Vector3d a, double k) { return new Vector3d(a.X / k, a.Y / k, a.Z / k); }
        public static bool operator ==(Vector3d a, Vector3d b) { return a.X == b.X && a.Y == b.Y && a.Z == b.Z; }
        public static bool operator !=(Vector3d a, Vector3d b) { return !(a == b); }
        public static explicit operator Point3d(Vector3d v) { return new Point3d(v.X, v.Y, v.Z); }
        public override bool Equals(object o) { return o is Vector3d && (Vector3d)o == this; }
        public override int GetHashCode() { return X.GetHashCode() ^ Y.GetHashCode() ^ Z.GetHashCode(); }
        public override string ToString() { return X + "," + Y + "," + Z; }
    }
    public struct Interval
    {
        public double T0; public double T1;
        public Interval(double t0, double t1) { T0 = t0; T1 = t1; }
        public double Min { get { return Math.Min(T0, T1); } }
        public double Max { get { return Math.Max(T0, T1); } }
        public double Mid { get { return 0.5 * (T0 + T1); } }
        public double Length { get { return T1 - T0; } }
        public double ParameterAt(double t) { return (1 - t) * T0 + t * T1; }
        public double NormalizedParameterAt(double x) { return (x - T0) / (T1 - T0); }
        public bool IncludesParameter(double t) { return t >= Min && t <= Max; }
        public override string ToString() { return T0 + "," + T1; }
    }
    public struct Plane
    {
        public Point3d Origin; public Vector3d XAxis; public Vector3d YAxis; public Vector3d ZAxis;
        public Plane(Point3d origin, Vector3d normal)
        {
            Origin = origin; ZAxis = normal; ZAxis.Unitize();
            // The direction that opennurbs takes: across the two largest components.
            XAxis = Perpendicular(ZAxis); XAxis.Unitize();
            YAxis = Vector3d.CrossProduct(ZAxis, XAxis); YAxis.Unitize();
        }
        public Plane(Point3d origin, Vector3d x, Vector3d y)
        {
            Origin = origin; XAxis = x; XAxis.Unitize();
            YAxis = y - XAxis * (XAxis * y); YAxis.Unitize();
            ZAxis = Vector3d.CrossProduct(XAxis, YAxis); ZAxis.Unitize();
        }
        public Plane(Point3d a, Point3d b, Point3d c) : this(a, b - a, c - a) { }
        static Vector3d Perpendicular(Vector3d v)
        {
            double x = Math.Abs(v.X), y = Math.Abs(v.Y), z = Math.Abs(v.Z);
            if (y > x) {
                if (z > y) return new Vector3d(v.Z, 0, -v.X);
                return z >= x ? new Vector3d(0, v.Z, -v.Y) : new Vector3d(-v.Y, v.X, 0);
            }
            if (z > x) return new Vector3d(v.Z, 0, -v.X);
            return z > y ? new Vector3d(v.Z, 0, -v.X) : new Vector3d(-v.Y, v.X, 0);
        }
        public Vector3d Normal { get { return ZAxis; } }
        public static Plane WorldXY { get { return new Plane(Point3d.Origin, Vector3d.XAxis, Vector3d.YAxis); } }
        public static Plane WorldYZ { get { return new Plane(Point3d.Origin, Vector3d.YAxis, Vector3d.ZAxis); } }
        public static Plane WorldZX { get { return new Plane(Point3d.Origin, Vector3d.ZAxis, Vector3d.XAxis); } }
        public double OriginX { get { return Origin.X; } }
        public double OriginY { get { return Origin.Y; } }
        public double OriginZ { get { return Origin.Z; } }
        public Point3d PointAt(double u, double v) { return Origin + XAxis * u + YAxis * v; }
        public Point3d PointAt(double u, double v, double w) { return Origin + XAxis * u + YAxis * v + ZAxis * w; }
        public double DistanceTo(Point3d p) { return (p - Origin) * ZAxis; }
        public Point3d ClosestPoint(Point3d p) { return p - ZAxis * DistanceTo(p); }
        public bool ClosestParameter(Point3d p, out double s, out double t) { s = (p - Origin) * XAxis; t = (p - Origin) * YAxis; return true; }
        public bool Rotate(double angle, Vector3d axis) { XAxis.Rotate(angle, axis); YAxis.Rotate(angle, axis); ZAxis.Rotate(angle, axis); return true; }
        public void Flip() { Vector3d x = XAxis; XAxis = YAxis; YAxis = x; ZAxis = -ZAxis; }
        public override string ToString() { return "Origin=" + Origin + " XAxis=" + XAxis + ", YAxis=" + YAxis + ", ZAxis=" + ZAxis; }
    }
    public struct Line
    {
        public Point3d From; public Point3d To;
        public Line(Point3d a, Point3d b) { From = a; To = b; }
        public Line(Point3d a, Vector3d v) { From = a; To = a + v; }
        public Line(double x0, double y0, double z0, double x1, double y1, double z1) { From = new Point3d(x0, y0, z0); To = new Point3d(x1, y1, z1); }
        public Line(Point3d a, Vector3d v, double length) { v.Unitize(); From = a; To = a + v * length; }
        public double Length { get { return From.DistanceTo(To); } }
        public Vector3d Direction { get { return To - From; } }
        public Vector3d UnitTangent { get { Vector3d v = To - From; v.Unitize(); return v; } }
        public bool IsValid { get { return From.IsValid && To.IsValid && From != To; } }
        public Point3d PointAt(double t) { return From + (To - From) * t; }
        public void Flip() { Point3d p = From; From = To; To = p; }
        public double ClosestParameter(Point3d p) { Vector3d d = To - From; double q = d * d; return q > 0 ? ((p - From) * d) / q : 0; }
        public Point3d ClosestPoint(Point3d p, bool finite) { double t = ClosestParameter(p); if (finite) t = RhinoMath.Clamp(t, 0.0, 1.0); return PointAt(t); }
        public double DistanceTo(Point3d p, bool finite) { return ClosestPoint(p, finite).DistanceTo(p); }
        public override string ToString() { return From + "," + To; }
    }
    public struct BoundingBox
    {
        public Point3d Min; public Point3d Max;
        public BoundingBox(Point3d min, Point3d max) { Min = min; Max = max; }
        public bool IsValid { get { return Min.IsValid && Max.IsValid && Min.X <= Max.X && Min.Y <= Max.Y && Min.Z <= Max.Z; } }
        public Point3d Center { get { return (Min + Max) * 0.5; } }
        public Vector3d Diagonal { get { return Max - Min; } }
        public static BoundingBox Empty { get { return new BoundingBox(new Point3d(1, 0, 0), new Point3d(-1, 0, 0)); } }
        public bool Contains(Point3d p) { return p.X >= Min.X && p.X <= Max.X && p.Y >= Min.Y && p.Y <= Max.Y && p.Z >= Min.Z && p.Z <= Max.Z; }
        public void Union(Point3d p)
        {
            if (!IsValid) { Min = p; Max = p; return; }
            Min = new Point3d(Math.Min(Min.X, p.X), Math.Min(Min.Y, p.Y), Math.Min(Min.Z, p.Z));
            Max = new Point3d(Math.Max(Max.X, p.X), Math.Max(Max.Y, p.Y), Math.Max(Max.Z, p.Z));
        }
        public void Union(BoundingBox b) { if (b.IsValid) { Union(b.Min); Union(b.Max); } }
    }
    public struct Circle
    {
        public Plane Plane; public double Radius;
        public Circle(Plane plane, double radius) { Plane = plane; Radius = radius; }
        public Circle(Point3d center, double radius) { Plane = Plane.WorldXY; Plane.Origin = center; Radius = radius; }
        public Circle(double radius) { Plane = Plane.WorldXY; Radius = radius; }
        public Point3d Center { get { return Plane.Origin; } }
        public double Diameter { get { return 2 * Radius; } }
        public double Circumference { get { return 2 * Math.PI * Radius; } }
        public Vector3d Normal { get { return Plane.ZAxis; } }
        public Point3d PointAt(double t) { return Plane.PointAt(Radius * Math.Cos(t), Radius * Math.Sin(t)); }
    }
    public class Polyline : IEnumerable<Point3d>
    {
        List<Point3d> points;
        public Polyline() { points = new List<Point3d>(); }
        public Polyline(int capacity) { points = new List<Point3d>(); }
        public Polyline(IEnumerable<Point3d> own) { points = new List<Point3d>(own); }
        public int Count { get { return points.Count; } }
        public int SegmentCount { get { return Math.Max(0, points.Count - 1); } }
        public Point3d this[int i] { get { return points[i]; } set { points[i] = value; } }
        public Point3d First { get { return points[0]; } }
        public Point3d Last { get { return points[points.Count - 1]; } }
        public bool IsClosed { get { return points.Count > 2 && First == Last; } }
        public void Add(Point3d p) { points.Add(p); }
        public void Add(double x, double y, double z) { points.Add(new Point3d(x, y, z)); }
        public void AddRange(IEnumerable<Point3d> more) { points.AddRange(more); }
        public void Insert(int i, Point3d p) { points.Insert(i, p); }
        public void RemoveAt(int i) { points.RemoveAt(i); }
        public void Clear() { points.Clear(); }
        public void Reverse() { points.Reverse(); }
        public Point3d[] ToArray() { return points.ToArray(); }
        public double Length { get { double sum = 0; for (int i = 1; i < points.Count; i++) sum += points[i - 1].DistanceTo(points[i]); return sum; } }
        public Line SegmentAt(int i) { return new Line(points[i], points[i + 1]); }
        public IEnumerator<Point3d> GetEnumerator() { return points.GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
}
