namespace Rhino.Geometry
{
    public struct Point2d : IEquatable<Point2d>
    {
        public double X; public double Y;
        public Point2d(double x, double y) { X = x; Y = y; }
        public Point2d(Point2d p) { X = p.X; Y = p.Y; }
        public Point2d(Point3d p) { X = p.X; Y = p.Y; }
        public Point2d(Vector2d v) { X = v.X; Y = v.Y; }
        public static Point2d Origin { get { return new Point2d(0, 0); } }
        public static Point2d Unset { get { return new Point2d(RhinoMath.UnsetValue, RhinoMath.UnsetValue); } }
        public bool IsValid { get { return RhinoMath.IsValidDouble(X) && RhinoMath.IsValidDouble(Y); } }
        public double this[int i] { get { return i == 0 ? X : i == 1 ? Y : throw new IndexOutOfRangeException(); } set { if (i == 0) X = value; else if (i == 1) Y = value; else throw new IndexOutOfRangeException(); } }
        public double DistanceTo(Point2d p) { return Math.Sqrt((X - p.X) * (X - p.X) + (Y - p.Y) * (Y - p.Y)); }
        public double DistanceToSquared(Point2d p) { return (X - p.X) * (X - p.X) + (Y - p.Y) * (Y - p.Y); }
        public static Point2d operator +(Point2d a, Vector2d b) { return new Point2d(a.X + b.X, a.Y + b.Y); }
        public static Point2d operator +(Point2d a, Point2d b) { return new Point2d(a.X + b.X, a.Y + b.Y); }
        public static Point2d operator -(Point2d a, Vector2d b) { return new Point2d(a.X - b.X, a.Y - b.Y); }
        public static Vector2d operator -(Point2d a, Point2d b) { return new Vector2d(a.X - b.X, a.Y - b.Y); }
        public static Point2d operator *(Point2d a, double k) { return new Point2d(a.X * k, a.Y * k); }
        public static Point2d operator *(double k, Point2d a) { return a * k; }
        public static Point2d operator /(Point2d a, double k) { return new Point2d(a.X / k, a.Y / k); }
        public static bool operator ==(Point2d a, Point2d b) { return a.X == b.X && a.Y == b.Y; }
        public static bool operator !=(Point2d a, Point2d b) { return !(a == b); }
        public bool Equals(Point2d p) { return this == p; }
        public override bool Equals(object o) { return o is Point2d && (Point2d)o == this; }
        public override int GetHashCode() { return X.GetHashCode() ^ Y.GetHashCode(); }
        public override string ToString() { return X + "," + Y; }
    }
    public struct Vector2d : IEquatable<Vector2d>
    {
        public double X; public double Y;
        public Vector2d(double x, double y) { X = x; Y = y; }
        public double Length { get { return Math.Sqrt(X * X + Y * Y); } }
        public static Vector2d Zero { get { return new Vector2d(0, 0); } }
        public bool Unitize() { double n = Length; if (!(n > 0)) return false; X /= n; Y /= n; return true; }
        public bool Rotate(double angle) { double c = Math.Cos(angle), s = Math.Sin(angle), x = c * X - s * Y; Y = s * X + c * Y; X = x; return true; }
        public static Vector2d operator +(Vector2d a, Vector2d b) { return new Vector2d(a.X + b.X, a.Y + b.Y); }
        public static Vector2d operator -(Vector2d a, Vector2d b) { return new Vector2d(a.X - b.X, a.Y - b.Y); }
        public static Vector2d operator -(Vector2d a) { return new Vector2d(-a.X, -a.Y); }
        public static Vector2d operator *(Vector2d a, double k) { return new Vector2d(a.X * k, a.Y * k); }
        public static Vector2d operator *(double k, Vector2d a) { return a * k; }
        public static double operator *(Vector2d a, Vector2d b) { return a.X * b.X + a.Y * b.Y; }
        public static Vector2d operator /(Vector2d a, double k) { return new Vector2d(a.X / k, a.Y / k); }
        public static bool operator ==(Vector2d a, Vector2d b) { return a.X == b.X && a.Y == b.Y; }
        public static bool operator !=(Vector2d a, Vector2d b) { return !(a == b); }
        public bool Equals(Vector2d p) { return this == p; }
        public override bool Equals(object o) { return o is Vector2d && (Vector2d)o == this; }
        public override int GetHashCode() { return X.GetHashCode() ^ Y.GetHashCode(); }
        public override string ToString() { return X + "," + Y; }
    }
    public struct Point3d : IEquatable<Point3d>, IComparable<Point3d>
    {
        public double X; public double Y; public double Z;
        public Point3d(double x, double y, double z) { X = x; Y = y; Z = z; }
        public Point3d(Point3d p) { X = p.X; Y = p.Y; Z = p.Z; }
        public Point3d(Point3f p) { X = p.X; Y = p.Y; Z = p.Z; }
        public Point3d(Vector3d v) { X = v.X; Y = v.Y; Z = v.Z; }
        public static Point3d Origin { get { return new Point3d(0, 0, 0); } }
        public static Point3d Unset { get { return new Point3d(RhinoMath.UnsetValue, RhinoMath.UnsetValue, RhinoMath.UnsetValue); } }
        public bool IsValid { get { return RhinoMath.IsValidDouble(X) && RhinoMath.IsValidDouble(Y) && RhinoMath.IsValidDouble(Z); } }
        public double this[int i]
        {
            get { return i == 0 ? X : i == 1 ? Y : i == 2 ? Z : throw new IndexOutOfRangeException(); }
            set { if (i == 0) X = value; else if (i == 1) Y = value; else if (i == 2) Z = value; else throw new IndexOutOfRangeException(); }
        }
        public double MinimumCoordinate { get { return Math.Min(Math.Abs(X), Math.Min(Math.Abs(Y), Math.Abs(Z))); } }
        public double MaximumCoordinate { get { return Math.Max(Math.Abs(X), Math.Max(Math.Abs(Y), Math.Abs(Z))); } }
        public double DistanceTo(Point3d p) { return (this - p).Length; }
        public double DistanceToSquared(Point3d p) { return (this - p).SquareLength; }
        public void Interpolate(Point3d a, Point3d b, double t) { X = a.X + t * (b.X - a.X); Y = a.Y + t * (b.Y - a.Y); Z = a.Z + t * (b.Z - a.Z); }
        public void Transform(Transform xform) { Point3d p = xform * this; X = p.X; Y = p.Y; Z = p.Z; }
        public bool EpsilonEquals(Point3d o, double e) { return Math.Abs(X - o.X) <= e && Math.Abs(Y - o.Y) <= e && Math.Abs(Z - o.Z) <= e; }
        public static Point3d Add(Point3d a, Vector3d b) { return a + b; }
        public static Point3d Add(Vector3d a, Point3d b) { return a + b; }
        public static Point3d Add(Point3d a, Point3d b) { return a + b; }
        public static Vector3d Subtract(Point3d a, Point3d b) { return a - b; }
        public static Point3d Subtract(Point3d a, Vector3d b) { return a - b; }
        public static Point3d Multiply(Point3d a, double k) { return a * k; }
        public static Point3d Multiply(double k, Point3d a) { return a * k; }
        public static Point3d Divide(Point3d a, double k) { return a / k; }
        // The first of each group of points within the tolerance stays.
        public static Point3d[] CullDuplicates(IEnumerable<Point3d> points, double tolerance)
        {
            List<Point3d> kept = new List<Point3d>();
            foreach (Point3d p in points)
            {
                bool isNew = true;
                for (int i = 0; isNew && i < kept.Count; i++) isNew = kept[i].DistanceTo(p) > tolerance;
                if (isNew) kept.Add(p);
            }
            return kept.ToArray();
        }
        public static bool ArePointsCoplanar(IEnumerable<Point3d> points, double tolerance)
        {
            List<Point3d> all = new List<Point3d>(points);
            for (int i = 1; i < all.Count; i++)
                for (int j = i + 1; j < all.Count; j++)
                {
                    Vector3d n = Vector3d.CrossProduct(all[i] - all[0], all[j] - all[0]);
                    if (!n.Unitize()) continue;
                    for (int k = 1; k < all.Count; k++) if (Math.Abs((all[k] - all[0]) * n) > tolerance) return false;
                    return true;
                }
            return true;
        }
        public static Point3d operator +(Point3d a, Vector3d b) { return new Point3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Point3d operator +(Vector3d a, Point3d b) { return new Point3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Point3d operator +(Point3d a, Point3d b) { return new Point3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Point3d operator -(Point3d a, Vector3d b) { return new Point3d(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
        public static Vector3d operator -(Point3d a, Point3d b) { return new Vector3d(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
        public static Point3d operator -(Point3d a) { return new Point3d(-a.X, -a.Y, -a.Z); }
        public static Point3d operator *(Point3d a, double k) { return new Point3d(a.X * k, a.Y * k, a.Z * k); }
        public static Point3d operator *(double k, Point3d a) { return new Point3d(a.X * k, a.Y * k, a.Z * k); }
        public static Point3d operator /(Point3d a, double k) { return new Point3d(a.X / k, a.Y / k, a.Z / k); }
        public static bool operator ==(Point3d a, Point3d b) { return a.X == b.X && a.Y == b.Y && a.Z == b.Z; }
        public static bool operator !=(Point3d a, Point3d b) { return !(a == b); }
        public static bool operator <(Point3d a, Point3d b) { return a.CompareTo(b) < 0; }
        public static bool operator >(Point3d a, Point3d b) { return a.CompareTo(b) > 0; }
        public static bool operator <=(Point3d a, Point3d b) { return a.CompareTo(b) <= 0; }
        public static bool operator >=(Point3d a, Point3d b) { return a.CompareTo(b) >= 0; }
        public static explicit operator Vector3d(Point3d p) { return new Vector3d(p.X, p.Y, p.Z); }
        public static explicit operator Point3d(Vector3d v) { return new Point3d(v.X, v.Y, v.Z); }
        public static implicit operator Point3d(Point3f p) { return new Point3d(p.X, p.Y, p.Z); }
        public int CompareTo(Point3d o) { return X != o.X ? X.CompareTo(o.X) : Y != o.Y ? Y.CompareTo(o.Y) : Z.CompareTo(o.Z); }
        public bool Equals(Point3d p) { return this == p; }
        public override bool Equals(object o) { return o is Point3d && (Point3d)o == this; }
        public override int GetHashCode() { return X.GetHashCode() ^ Y.GetHashCode() ^ Z.GetHashCode(); }
        public override string ToString() { return X + "," + Y + "," + Z; }
    }
    public struct Vector3d : IEquatable<Vector3d>, IComparable<Vector3d>
    {
        public double X; public double Y; public double Z;
        public Vector3d(double x, double y, double z) { X = x; Y = y; Z = z; }
        public Vector3d(Point3d p) { X = p.X; Y = p.Y; Z = p.Z; }
        public Vector3d(Vector3d v) { X = v.X; Y = v.Y; Z = v.Z; }
        public Vector3d(Vector3f v) { X = v.X; Y = v.Y; Z = v.Z; }
        public static Vector3d Zero { get { return new Vector3d(0, 0, 0); } }
        public static Vector3d XAxis { get { return new Vector3d(1, 0, 0); } }
        public static Vector3d YAxis { get { return new Vector3d(0, 1, 0); } }
        public static Vector3d ZAxis { get { return new Vector3d(0, 0, 1); } }
        public static Vector3d Unset { get { return new Vector3d(RhinoMath.UnsetValue, RhinoMath.UnsetValue, RhinoMath.UnsetValue); } }
        public double this[int i]
        {
            get { return i == 0 ? X : i == 1 ? Y : i == 2 ? Z : throw new IndexOutOfRangeException(); }
            set { if (i == 0) X = value; else if (i == 1) Y = value; else if (i == 2) Z = value; else throw new IndexOutOfRangeException(); }
        }
        public double SquareLength { get { return X * X + Y * Y + Z * Z; } }
        public double Length { get { return Math.Sqrt(X * X + Y * Y + Z * Z); } }
        public bool IsZero { get { return X == 0 && Y == 0 && Z == 0; } }
        public bool IsValid { get { return RhinoMath.IsValidDouble(X) && RhinoMath.IsValidDouble(Y) && RhinoMath.IsValidDouble(Z); } }
        public bool IsUnitVector { get { return IsValid && Math.Abs(Length - 1.0) <= RhinoMath.SqrtEpsilon; } }
        public double MinimumCoordinate { get { return Math.Min(Math.Abs(X), Math.Min(Math.Abs(Y), Math.Abs(Z))); } }
        public double MaximumCoordinate { get { return Math.Max(Math.Abs(X), Math.Max(Math.Abs(Y), Math.Abs(Z))); } }
        public bool IsTiny() { return IsTiny(RhinoMath.ZeroTolerance); }
        public bool IsTiny(double tolerance) { return Math.Abs(X) <= tolerance && Math.Abs(Y) <= tolerance && Math.Abs(Z) <= tolerance; }
        public bool Unitize()
        {
            double n = Math.Sqrt(X * X + Y * Y + Z * Z);
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
        public void Transform(Transform t)
        {
            double x = t.M00 * X + t.M01 * Y + t.M02 * Z, y = t.M10 * X + t.M11 * Y + t.M12 * Z, z = t.M20 * X + t.M21 * Y + t.M22 * Z;
            X = x; Y = y; Z = z;
        }
        // The rule of openNURBS (ON_3dVector::PerpendicularTo): the two largest components change places, one with its sign
        // turned; which of equals comes first is part of the rule.
        public bool PerpendicularTo(Vector3d v)
        {
            double x = Math.Abs(v.X), y = Math.Abs(v.Y), z = Math.Abs(v.Z);
            int i, j;
            if (y > x) { if (z > y) { i = 2; j = 1; } else if (z >= x) { i = 1; j = 2; } else { i = 1; j = 0; } }
            else if (z > x) { i = 2; j = 0; }
            else if (z > y) { i = 0; j = 2; }
            else { i = 0; j = 1; }
            X = 0; Y = 0; Z = 0;
            this[i] = 0.0 - v[j]; this[j] = v[i];
            return v[i] != 0;
        }
        public int IsParallelTo(Vector3d o) { return IsParallelTo(o, RhinoMath.DefaultAngleTolerance); }
        public int IsParallelTo(Vector3d o, double angle)
        {
            double n = Length * o.Length;
            if (!(n > 0)) return 0;
            double c = (this * o) / n, least = Math.Cos(angle);
            return c >= least ? 1 : c <= -least ? -1 : 0;
        }
        public bool IsPerpendicularTo(Vector3d o) { return IsPerpendicularTo(o, RhinoMath.DefaultAngleTolerance); }
        public bool IsPerpendicularTo(Vector3d o, double angle)
        {
            double n = Length * o.Length;
            return n > 0 && Math.Abs(this * o) / n <= Math.Sin(angle);
        }
        public static Vector3d CrossProduct(Vector3d a, Vector3d b) { return new Vector3d(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X); }
        // Kahan's formula keeps its digits near 0 and pi.
        public static double VectorAngle(Vector3d a, Vector3d b)
        {
            if (!a.Unitize() || !b.Unitize()) return RhinoMath.UnsetValue;
            double c = a * b;
            if (c >= 1.0) return 0.0;
            if (c <= -1.0) return Math.PI;
            return 2.0 * Math.Atan2((a - b).Length, (a + b).Length);
        }
        public static double VectorAngle(Vector3d a, Vector3d b, Vector3d normal)
        {
            double angle = VectorAngle(a, b);
            return CrossProduct(a, b) * normal < 0 ? 2.0 * Math.PI - angle : angle;
        }
        public static double VectorAngle(Vector3d a, Vector3d b, Plane plane)
        {
            Vector3d u = new Vector3d(a * plane.XAxis, a * plane.YAxis, 0), v = new Vector3d(b * plane.XAxis, b * plane.YAxis, 0);
            if (!u.Unitize() || !v.Unitize()) return RhinoMath.UnsetValue;
            double angle = Math.Atan2(u.X * v.Y - u.Y * v.X, u * v);
            return angle < 0 ? angle + 2.0 * Math.PI : angle;
        }
        public static bool AreOrthogonal(Vector3d x, Vector3d y, Vector3d z) { return Math.Abs(x * y) <= RhinoMath.SqrtEpsilon && Math.Abs(y * z) <= RhinoMath.SqrtEpsilon && Math.Abs(z * x) <= RhinoMath.SqrtEpsilon; }
        public static bool AreOrthonormal(Vector3d x, Vector3d y, Vector3d z) { return AreOrthogonal(x, y, z) && x.IsUnitVector && y.IsUnitVector && z.IsUnitVector; }
        public static bool AreRighthanded(Vector3d x, Vector3d y, Vector3d z) { return AreOrthonormal(x, y, z) && CrossProduct(x, y) * z > RhinoMath.SqrtEpsilon; }
        public bool EpsilonEquals(Vector3d o, double e) { return Math.Abs(X - o.X) <= e && Math.Abs(Y - o.Y) <= e && Math.Abs(Z - o.Z) <= e; }
        public static Vector3d Multiply(Vector3d a, double k) { return a * k; }
        public static Vector3d Multiply(double k, Vector3d a) { return a * k; }
        public static double Multiply(Vector3d a, Vector3d b) { return a * b; }
        public static Vector3d Divide(Vector3d a, double k) { return a / k; }
        public static Vector3d Add(Vector3d a, Vector3d b) { return a + b; }
        public static Vector3d Subtract(Vector3d a, Vector3d b) { return a - b; }
        public static Vector3d Negate(Vector3d a) { return -a; }
        public static Vector3d operator +(Vector3d a, Vector3d b) { return new Vector3d(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Vector3d operator -(Vector3d a, Vector3d b) { return new Vector3d(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
        public static Vector3d operator -(Vector3d a) { return new Vector3d(-a.X, -a.Y, -a.Z); }
        public static Vector3d operator *(Vector3d a, double k) { return new Vector3d(a.X * k, a.Y * k, a.Z * k); }
        public static Vector3d operator *(double k, Vector3d a) { return new Vector3d(a.X * k, a.Y * k, a.Z * k); }
        public static double operator *(Vector3d a, Vector3d b) { return a.X * b.X + a.Y * b.Y + a.Z * b.Z; }
        public static Vector3d operator /(Vector3d a, double k) { return new Vector3d(a.X / k, a.Y / k, a.Z / k); }
        public static bool operator ==(Vector3d a, Vector3d b) { return a.X == b.X && a.Y == b.Y && a.Z == b.Z; }
        public static bool operator !=(Vector3d a, Vector3d b) { return !(a == b); }
        public static bool operator <(Vector3d a, Vector3d b) { return a.CompareTo(b) < 0; }
        public static bool operator >(Vector3d a, Vector3d b) { return a.CompareTo(b) > 0; }
        public static implicit operator Vector3d(Vector3f v) { return new Vector3d(v.X, v.Y, v.Z); }
        public int CompareTo(Vector3d o) { return X != o.X ? X.CompareTo(o.X) : Y != o.Y ? Y.CompareTo(o.Y) : Z.CompareTo(o.Z); }
        public bool Equals(Vector3d v) { return this == v; }
        public override bool Equals(object o) { return o is Vector3d && (Vector3d)o == this; }
        public override int GetHashCode() { return X.GetHashCode() ^ Y.GetHashCode() ^ Z.GetHashCode(); }
        public override string ToString() { return X + "," + Y + "," + Z; }
    }
    public struct Point3f : IEquatable<Point3f>
    {
        public float X; public float Y; public float Z;
        public Point3f(float x, float y, float z) { X = x; Y = y; Z = z; }
        public static Point3f Unset { get { return new Point3f(RhinoMath.UnsetSingle, RhinoMath.UnsetSingle, RhinoMath.UnsetSingle); } }
        public double DistanceTo(Point3f p) { return ((Point3d)this).DistanceTo(p); }
        public void Transform(Transform t) { Point3f p = (Point3f)(t * (Point3d)this); X = p.X; Y = p.Y; Z = p.Z; }
        public static Point3f operator +(Point3f a, Vector3f b) { return new Point3f(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Point3f operator +(Point3f a, Point3f b) { return new Point3f(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Point3f operator -(Point3f a, Vector3f b) { return new Point3f(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
        public static Vector3f operator -(Point3f a, Point3f b) { return new Vector3f(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
        public static Point3f operator *(Point3f a, float k) { return new Point3f(a.X * k, a.Y * k, a.Z * k); }
        public static Point3f operator *(float k, Point3f a) { return a * k; }
        public static bool operator ==(Point3f a, Point3f b) { return a.X == b.X && a.Y == b.Y && a.Z == b.Z; }
        public static bool operator !=(Point3f a, Point3f b) { return !(a == b); }
        public static explicit operator Point3f(Point3d p) { return new Point3f((float)p.X, (float)p.Y, (float)p.Z); }
        public static explicit operator Vector3f(Point3f p) { return new Vector3f(p.X, p.Y, p.Z); }
        public bool Equals(Point3f p) { return this == p; }
        public override bool Equals(object o) { return o is Point3f && (Point3f)o == this; }
        public override int GetHashCode() { return X.GetHashCode() ^ Y.GetHashCode() ^ Z.GetHashCode(); }
        public override string ToString() { return X + "," + Y + "," + Z; }
    }
    public struct Vector3f : IEquatable<Vector3f>
    {
        public float X; public float Y; public float Z;
        public Vector3f(float x, float y, float z) { X = x; Y = y; Z = z; }
        public static Vector3f Zero { get { return new Vector3f(0, 0, 0); } }
        public static Vector3f XAxis { get { return new Vector3f(1, 0, 0); } }
        public static Vector3f YAxis { get { return new Vector3f(0, 1, 0); } }
        public static Vector3f ZAxis { get { return new Vector3f(0, 0, 1); } }
        public float Length { get { return (float)((Vector3d)this).Length; } }
        public bool Unitize() { Vector3d v = this; bool done = v.Unitize(); if (done) { X = (float)v.X; Y = (float)v.Y; Z = (float)v.Z; } return done; }
        public bool Reverse() { X = -X; Y = -Y; Z = -Z; return true; }
        public static Vector3f operator +(Vector3f a, Vector3f b) { return new Vector3f(a.X + b.X, a.Y + b.Y, a.Z + b.Z); }
        public static Vector3f operator -(Vector3f a, Vector3f b) { return new Vector3f(a.X - b.X, a.Y - b.Y, a.Z - b.Z); }
        public static Vector3f operator *(Vector3f a, float k) { return new Vector3f(a.X * k, a.Y * k, a.Z * k); }
        public static Vector3f operator *(float k, Vector3f a) { return a * k; }
        public static double operator *(Vector3f a, Vector3f b) { return a.X * b.X + a.Y * b.Y + a.Z * b.Z; }
        public static bool operator ==(Vector3f a, Vector3f b) { return a.X == b.X && a.Y == b.Y && a.Z == b.Z; }
        public static bool operator !=(Vector3f a, Vector3f b) { return !(a == b); }
        public static explicit operator Vector3f(Vector3d v) { return new Vector3f((float)v.X, (float)v.Y, (float)v.Z); }
        public bool Equals(Vector3f p) { return this == p; }
        public override bool Equals(object o) { return o is Vector3f && (Vector3f)o == this; }
        public override int GetHashCode() { return X.GetHashCode() ^ Y.GetHashCode() ^ Z.GetHashCode(); }
        public override string ToString() { return X + "," + Y + "," + Z; }
    }
}
