namespace Rhino.Geometry
{
    public struct Plane : IEquatable<Plane>
    {
        public Point3d Origin; public Vector3d XAxis; public Vector3d YAxis; public Vector3d ZAxis;
        public Plane(Plane other) { Origin = other.Origin; XAxis = other.XAxis; YAxis = other.YAxis; ZAxis = other.ZAxis; }
        public Plane(Point3d origin, Vector3d normal)
        {
            Origin = origin; ZAxis = normal; ZAxis.Unitize();
            XAxis = new Vector3d(); XAxis.PerpendicularTo(ZAxis); XAxis.Unitize();
            YAxis = Vector3d.CrossProduct(ZAxis, XAxis); YAxis.Unitize();
        }
        public Plane(Point3d origin, Vector3d x, Vector3d y)
        {
            Origin = origin; XAxis = x; XAxis.Unitize();
            YAxis = y - XAxis * (XAxis * y); YAxis.Unitize();
            ZAxis = Vector3d.CrossProduct(XAxis, YAxis); ZAxis.Unitize();
        }
        public Plane(Point3d a, Point3d b, Point3d c) : this(a, b - a, c - a) { }
        // The plane of ax + by + cz + d = 0, its origin the foot of the world's.
        public Plane(double a, double b, double c, double d) : this(Foot(a, b, c, d), new Vector3d(a, b, c)) { }
        static Point3d Foot(double a, double b, double c, double d) { double k = -d / (a * a + b * b + c * c); return new Point3d(a * k, b * k, c * k); }
        public static Plane WorldXY { get { return new Plane(Point3d.Origin, Vector3d.XAxis, Vector3d.YAxis); } }
        public static Plane WorldYZ { get { return new Plane(Point3d.Origin, Vector3d.YAxis, Vector3d.ZAxis); } }
        public static Plane WorldZX { get { return new Plane(Point3d.Origin, Vector3d.ZAxis, Vector3d.XAxis); } }
        public static Plane Unset { get { Plane p = new Plane(); p.Origin = Point3d.Unset; p.XAxis = Vector3d.Unset; p.YAxis = Vector3d.Unset; p.ZAxis = Vector3d.Unset; return p; } }
        public static Plane CreateFromNormal(Point3d origin, Vector3d normal) { return new Plane(origin, normal); }
        public static Plane CreateFromFrame(Point3d origin, Vector3d x, Vector3d y) { return new Plane(origin, x, y); }
        public static Plane CreateFromPoints(Point3d a, Point3d b, Point3d c) { return new Plane(a, b, c); }
        public Vector3d Normal { get { return ZAxis; } }
        public double OriginX { get { return Origin.X; } set { Origin.X = value; } }
        public double OriginY { get { return Origin.Y; } set { Origin.Y = value; } }
        public double OriginZ { get { return Origin.Z; } set { Origin.Z = value; } }
        public bool IsValid { get { return Origin.IsValid && Vector3d.AreRighthanded(XAxis, YAxis, ZAxis); } }
        public Plane Clone() { return this; }
        public Point3d PointAt(double u, double v) { return Origin + XAxis * u + YAxis * v; }
        public Point3d PointAt(double u, double v, double w) { return Origin + XAxis * u + YAxis * v + ZAxis * w; }
        public double[] GetPlaneEquation() { return new double[] { ZAxis.X, ZAxis.Y, ZAxis.Z, -(ZAxis * (Origin - Point3d.Origin)) }; }
        public double ValueAt(Point3d p) { return (p - Origin) * ZAxis; }
        public double DistanceTo(Point3d p) { return (p - Origin) * ZAxis; }
        public Point3d ClosestPoint(Point3d p) { return p - ZAxis * DistanceTo(p); }
        public bool ClosestParameter(Point3d p, out double s, out double t) { s = (p - Origin) * XAxis; t = (p - Origin) * YAxis; return true; }
        public bool RemapToPlaneSpace(Point3d p, out Point3d local) { Vector3d d = p - Origin; local = new Point3d(d * XAxis, d * YAxis, d * ZAxis); return true; }
        public bool IsCoplanar(Plane o) { return IsCoplanar(o, RhinoMath.ZeroTolerance); }
        public bool IsCoplanar(Plane o, double tolerance) { return ZAxis.IsParallelTo(o.ZAxis) != 0 && Math.Abs(DistanceTo(o.Origin)) <= tolerance; }
        public bool Rotate(double angle, Vector3d axis) { return XAxis.Rotate(angle, axis) && YAxis.Rotate(angle, axis) && ZAxis.Rotate(angle, axis); }
        public bool Rotate(double angle, Vector3d axis, Point3d center)
        {
            Vector3d d = Origin - center;
            if (!d.Rotate(angle, axis)) return false;
            Origin = center + d;
            return Rotate(angle, axis);
        }
        public bool Translate(Vector3d v) { Origin += v; return true; }
        public bool Transform(Transform t)
        {
            Point3d o = t * Origin;
            Vector3d x = XAxis, y = YAxis;
            x.Transform(t); y.Transform(t);
            Plane p = new Plane(o, x, y);
            bool done = p.XAxis.Length > 0 && p.YAxis.Length > 0;
            if (done) { Origin = p.Origin; XAxis = p.XAxis; YAxis = p.YAxis; ZAxis = p.ZAxis; }
            return done;
        }
        public void Flip() { Vector3d x = XAxis; XAxis = YAxis; YAxis = x; ZAxis = -ZAxis; }
        public bool UpdateEquation() { return true; }
        public static PlaneFitResult FitPlaneToPoints(IEnumerable<Point3d> points, out Plane plane) { double deviation; return FitPlaneToPoints(points, out plane, out deviation); }
        // The plane through the centre across the direction of least spread: the eigenvector of the smallest eigenvalue of the
        // points' moments, by Jacobi's rotations.
        public static PlaneFitResult FitPlaneToPoints(IEnumerable<Point3d> points, out Plane plane, out double deviation)
        {
            plane = Plane.Unset; deviation = 0;
            int n = 0;
            Point3d center = Point3d.Origin;
            foreach (Point3d p in points) { center += p; n++; }
            if (n < 3) return PlaneFitResult.Failure;
            center = center / n;
            double[,] m = new double[3, 3], v = new double[,] { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
            foreach (Point3d p in points)
            {
                Vector3d d = p - center;
                for (int i = 0; i < 3; i++) for (int j = 0; j < 3; j++) m[i, j] += d[i] * d[j];
            }
            for (int turn = 0; turn < 60; turn++)
                for (int p = 0; p < 2; p++)
                    for (int q = p + 1; q < 3; q++)
                    {
                        if (m[p, q] == 0) continue;
                        double theta = (m[q, q] - m[p, p]) / (2 * m[p, q]);
                        double t = (theta < 0 ? -1 : 1) / (Math.Abs(theta) + Math.Sqrt(theta * theta + 1));
                        double c = 1 / Math.Sqrt(t * t + 1), s = t * c;
                        for (int k = 0; k < 3; k++) { double a = m[k, p], b = m[k, q]; m[k, p] = c * a - s * b; m[k, q] = s * a + c * b; }
                        for (int k = 0; k < 3; k++) { double a = m[p, k], b = m[q, k]; m[p, k] = c * a - s * b; m[q, k] = s * a + c * b; }
                        for (int k = 0; k < 3; k++) { double a = v[k, p], b = v[k, q]; v[k, p] = c * a - s * b; v[k, q] = s * a + c * b; }
                    }
            int least = 0, most = 0;
            for (int i = 1; i < 3; i++) { if (m[i, i] < m[least, least]) least = i; if (m[i, i] > m[most, most]) most = i; }
            if (least == most) return PlaneFitResult.Failure;
            int middle = 3 - least - most;
            plane = new Plane(center, new Vector3d(v[0, most], v[1, most], v[2, most]), new Vector3d(v[0, middle], v[1, middle], v[2, middle]));
            foreach (Point3d p in points) deviation = Math.Max(deviation, Math.Abs(plane.DistanceTo(p)));
            return m[middle, middle] <= 1e-20 * m[most, most] ? PlaneFitResult.Inconclusive : PlaneFitResult.Success;
        }
        public bool EpsilonEquals(Plane o, double e) { return Origin.EpsilonEquals(o.Origin, e) && XAxis.EpsilonEquals(o.XAxis, e) && YAxis.EpsilonEquals(o.YAxis, e) && ZAxis.EpsilonEquals(o.ZAxis, e); }
        public static bool operator ==(Plane a, Plane b) { return a.Origin == b.Origin && a.XAxis == b.XAxis && a.YAxis == b.YAxis && a.ZAxis == b.ZAxis; }
        public static bool operator !=(Plane a, Plane b) { return !(a == b); }
        public bool Equals(Plane o) { return this == o; }
        public override bool Equals(object o) { return o is Plane && (Plane)o == this; }
        public override int GetHashCode() { return Origin.GetHashCode() ^ XAxis.GetHashCode() ^ YAxis.GetHashCode(); }
        public override string ToString() { return "Origin=" + Origin + " XAxis=" + XAxis + ", YAxis=" + YAxis + ", ZAxis=" + ZAxis; }
    }
    public struct Transform : IEquatable<Transform>
    {
        public double M00; public double M01; public double M02; public double M03;
        public double M10; public double M11; public double M12; public double M13;
        public double M20; public double M21; public double M22; public double M23;
        public double M30; public double M31; public double M32; public double M33;
        public Transform(double diagonal) { this = new Transform(); M00 = diagonal; M11 = diagonal; M22 = diagonal; M33 = 1; }
        public Transform(Transform other) { this = other; }
        public static Transform Identity { get { return new Transform(1.0); } }
        public static Transform ZeroTransformation { get { return new Transform(0.0); } }
        public static Transform Unset { get { Transform t = new Transform(); for (int i = 0; i < 4; i++) for (int j = 0; j < 4; j++) t[i, j] = RhinoMath.UnsetValue; return t; } }
        public double this[int row, int column]
        {
            get
            {
                if (row < 0 || row > 3) throw new IndexOutOfRangeException("Negative row indices are not allowed when accessing a Transform matrix");
                if (column < 0 || column > 3) throw new IndexOutOfRangeException("Negative column indices are not allowed when accessing a Transform matrix");
                switch (row * 4 + column)
                {
                    case 0: return M00; case 1: return M01; case 2: return M02; case 3: return M03;
                    case 4: return M10; case 5: return M11; case 6: return M12; case 7: return M13;
                    case 8: return M20; case 9: return M21; case 10: return M22; case 11: return M23;
                    case 12: return M30; case 13: return M31; case 14: return M32; default: return M33;
                }
            }
            set
            {
                if (row < 0 || row > 3 || column < 0 || column > 3) throw new IndexOutOfRangeException("A Transform has rows and columns 0 to 3");
                switch (row * 4 + column)
                {
                    case 0: M00 = value; break; case 1: M01 = value; break; case 2: M02 = value; break; case 3: M03 = value; break;
                    case 4: M10 = value; break; case 5: M11 = value; break; case 6: M12 = value; break; case 7: M13 = value; break;
                    case 8: M20 = value; break; case 9: M21 = value; break; case 10: M22 = value; break; case 11: M23 = value; break;
                    case 12: M30 = value; break; case 13: M31 = value; break; case 14: M32 = value; break; default: M33 = value; break;
                }
            }
        }
        // By its columns: where the axes and the origin go.
        static Transform Columns(Vector3d x, Vector3d y, Vector3d z, Vector3d o)
        {
            Transform t = new Transform(1.0);
            t.M00 = x.X; t.M10 = x.Y; t.M20 = x.Z;
            t.M01 = y.X; t.M11 = y.Y; t.M21 = y.Z;
            t.M02 = z.X; t.M12 = z.Y; t.M22 = z.Z;
            t.M03 = o.X; t.M13 = o.Y; t.M23 = o.Z;
            return t;
        }
        static Transform Frame(Plane p) { return Columns(p.XAxis, p.YAxis, p.ZAxis, p.Origin - Point3d.Origin); }
        // The same about a point instead of the origin.
        Transform About(Point3d p) { Vector3d v = new Vector3d(p); return Translation(v) * this * Translation(-v); }
        public static Transform Translation(Vector3d v) { return Columns(Vector3d.XAxis, Vector3d.YAxis, Vector3d.ZAxis, v); }
        public static Transform Translation(double x, double y, double z) { return Translation(new Vector3d(x, y, z)); }
        public static Transform Diagonal(Vector3d d) { return Diagonal(d.X, d.Y, d.Z); }
        public static Transform Diagonal(double x, double y, double z) { Transform t = new Transform(1.0); t.M00 = x; t.M11 = y; t.M22 = z; return t; }
        public static Transform Scale(Point3d anchor, double factor) { return Diagonal(factor, factor, factor).About(anchor); }
        public static Transform Scale(Plane plane, double x, double y, double z) { return Frame(plane) * Diagonal(x, y, z) * Inverse(plane); }
        static Transform Inverse(Plane p) { return Frame(p).Transposed3() * Translation(-(p.Origin - Point3d.Origin)); }
        // The turn of an orthonormal frame, undone.
        Transform Transposed3() { return Columns(new Vector3d(M00, M01, M02), new Vector3d(M10, M11, M12), new Vector3d(M20, M21, M22), Vector3d.Zero); }
        public static Transform Rotation(double angle, Point3d center) { return Rotation(angle, Vector3d.ZAxis, center); }
        public static Transform Rotation(double angle, Vector3d axis, Point3d center) { return Rotation(Math.Sin(angle), Math.Cos(angle), axis, center); }
        public static Transform Rotation(double s, double c, Vector3d axis, Point3d center)
        {
            if (!axis.Unitize()) return Identity;
            double x = axis.X, y = axis.Y, z = axis.Z, k = 1 - c;
            Transform t = Columns(new Vector3d(c + x * x * k, y * x * k + z * s, z * x * k - y * s),
                new Vector3d(x * y * k - z * s, c + y * y * k, z * y * k + x * s),
                new Vector3d(x * z * k + y * s, y * z * k - x * s, c + z * z * k), Vector3d.Zero);
            return t.About(center);
        }
        public static Transform Rotation(Vector3d from, Vector3d to, Point3d center)
        {
            if (!from.Unitize() || !to.Unitize()) return Identity;
            Vector3d axis = Vector3d.CrossProduct(from, to);
            double s = axis.Length, c = from * to;
            if (!axis.Unitize()) { axis.PerpendicularTo(from); axis.Unitize(); s = 0; c = c < 0 ? -1 : 1; }
            return Rotation(s, c, axis, center);
        }
        public static Transform Rotation(Vector3d x0, Vector3d y0, Vector3d z0, Vector3d x1, Vector3d y1, Vector3d z1)
        {
            return Columns(x1, y1, z1, Vector3d.Zero) * Columns(x0, y0, z0, Vector3d.Zero).Transposed3();
        }
        public static Transform RotationZYX(double yaw, double pitch, double roll)
        {
            return Rotation(yaw, Vector3d.ZAxis, Point3d.Origin) * Rotation(pitch, Vector3d.YAxis, Point3d.Origin) * Rotation(roll, Vector3d.XAxis, Point3d.Origin);
        }
        public static Transform RotationZYZ(double a, double b, double c)
        {
            return Rotation(a, Vector3d.ZAxis, Point3d.Origin) * Rotation(b, Vector3d.YAxis, Point3d.Origin) * Rotation(c, Vector3d.ZAxis, Point3d.Origin);
        }
        public static Transform Mirror(Plane plane) { return Mirror(plane.Origin, plane.ZAxis); }
        // Householder's reflection.
        public static Transform Mirror(Point3d point, Vector3d n)
        {
            if (!n.Unitize()) return Identity;
            return Columns(Vector3d.XAxis - 2 * n.X * n, Vector3d.YAxis - 2 * n.Y * n, Vector3d.ZAxis - 2 * n.Z * n, Vector3d.Zero).About(point);
        }
        public static Transform PlanarProjection(Plane plane)
        {
            Vector3d n = plane.ZAxis;
            return Columns(Vector3d.XAxis - n.X * n, Vector3d.YAxis - n.Y * n, Vector3d.ZAxis - n.Z * n, Vector3d.Zero).About(plane.Origin);
        }
        public static Transform ProjectAlong(Plane plane, Vector3d d)
        {
            Vector3d n = plane.ZAxis;
            double k = d * n;
            if (k == 0) return Unset;
            d = d / k;
            return Columns(Vector3d.XAxis - n.X * d, Vector3d.YAxis - n.Y * d, Vector3d.ZAxis - n.Z * d, Vector3d.Zero).About(plane.Origin);
        }
        public static Transform PlaneToPlane(Plane from, Plane to) { return Frame(to) * Inverse(from); }
        public static Transform ChangeBasis(Plane from, Plane to) { return Inverse(to) * Frame(from); }
        public static Transform Shear(Plane plane, Vector3d x, Vector3d y, Vector3d z) { return Frame(plane) * Columns(x, y, z, Vector3d.Zero) * Inverse(plane); }
        public static Transform Multiply(Transform a, Transform b) { return a * b; }
        public static Transform operator *(Transform a, Transform b)
        {
            Transform t = new Transform();
            for (int i = 0; i < 4; i++)
                for (int j = 0; j < 4; j++)
                {
                    double sum = 0;
                    for (int k = 0; k < 4; k++) sum += a[i, k] * b[k, j];
                    t[i, j] = sum;
                }
            return t;
        }
        public static Point3d operator *(Transform t, Point3d p)
        {
            double w = t.M30 * p.X + t.M31 * p.Y + t.M32 * p.Z + t.M33;
            if (w != 0) w = 1.0 / w;
            return new Point3d((t.M00 * p.X + t.M01 * p.Y + t.M02 * p.Z + t.M03) * w, (t.M10 * p.X + t.M11 * p.Y + t.M12 * p.Z + t.M13) * w, (t.M20 * p.X + t.M21 * p.Y + t.M22 * p.Z + t.M23) * w);
        }
        public static Vector3d operator *(Transform t, Vector3d v) { v.Transform(t); return v; }
        // By elimination with the largest pivots; the determinant is the pivots' product.
        double Solve(out Transform inverse)
        {
            Transform a = this;
            inverse = Identity;
            double determinant = 1;
            for (int c = 0; c < 4; c++)
            {
                int p = c;
                for (int r = c + 1; r < 4; r++) if (Math.Abs(a[r, c]) > Math.Abs(a[p, c])) p = r;
                if (a[p, c] == 0) return 0;
                if (p != c)
                {
                    determinant = -determinant;
                    for (int k = 0; k < 4; k++) { double x = a[p, k]; a[p, k] = a[c, k]; a[c, k] = x; x = inverse[p, k]; inverse[p, k] = inverse[c, k]; inverse[c, k] = x; }
                }
                double pivot = a[c, c];
                determinant *= pivot;
                for (int k = 0; k < 4; k++) { a[c, k] = a[c, k] / pivot; inverse[c, k] = inverse[c, k] / pivot; }
                for (int r = 0; r < 4; r++)
                {
                    double f = a[r, c];
                    if (r == c || f == 0) continue;
                    for (int k = 0; k < 4; k++) { a[r, k] = a[r, k] - f * a[c, k]; inverse[r, k] = inverse[r, k] - f * inverse[c, k]; }
                }
            }
            return determinant;
        }
        public double Determinant { get { Transform t; return Solve(out t); } }
        public bool TryGetInverse(out Transform inverse) { return Solve(out inverse) != 0; }
        public Transform Transpose() { Transform t = new Transform(); for (int i = 0; i < 4; i++) for (int j = 0; j < 4; j++) t[i, j] = this[j, i]; return t; }
        public Transform Clone() { return this; }
        public bool IsValid { get { for (int i = 0; i < 4; i++) for (int j = 0; j < 4; j++) if (!RhinoMath.IsValidDouble(this[i, j])) return false; return true; } }
        public bool IsIdentity { get { return this == Identity; } }
        public bool IsZero { get { return this == ZeroTransformation; } }
        public bool IsAffine { get { return M30 == 0 && M31 == 0 && M32 == 0 && M33 == 1; } }
        public bool IsLinear { get { return IsAffine && M03 == 0 && M13 == 0 && M23 == 0; } }
        public Point3d[] TransformList(IEnumerable<Point3d> points) { List<Point3d> all = new List<Point3d>(); foreach (Point3d p in points) all.Add(this * p); return all.ToArray(); }
        public BoundingBox TransformBoundingBox(BoundingBox b) { BoundingBox made = BoundingBox.Empty; foreach (Point3d p in b.GetCorners()) made.Union(this * p); return made; }
        public double[] ToDoubleArray(bool rowDominant) { double[] all = new double[16]; for (int i = 0; i < 4; i++) for (int j = 0; j < 4; j++) all[rowDominant ? i * 4 + j : j * 4 + i] = this[i, j]; return all; }
        public static bool operator ==(Transform a, Transform b) { for (int i = 0; i < 4; i++) for (int j = 0; j < 4; j++) if (a[i, j] != b[i, j]) return false; return true; }
        public static bool operator !=(Transform a, Transform b) { return !(a == b); }
        public bool Equals(Transform o) { return this == o; }
        public override bool Equals(object o) { return o is Transform && (Transform)o == this; }
        public override int GetHashCode() { double sum = 0; for (int i = 0; i < 4; i++) for (int j = 0; j < 4; j++) sum = sum * 3 + this[i, j]; return sum.GetHashCode(); }
        public override string ToString() { return "R0=(" + M00 + "," + M01 + "," + M02 + "," + M03 + "), R1=(" + M10 + "," + M11 + "," + M12 + "," + M13 + "), R2=(" + M20 + "," + M21 + "," + M22 + "," + M23 + "), R3=(" + M30 + "," + M31 + "," + M32 + "," + M33 + ")"; }
    }
}
