namespace Rhino.Geometry
{
    public struct BoundingBox
    {
        public Point3d Min; public Point3d Max;
        public BoundingBox(Point3d min, Point3d max) { Min = min; Max = max; }
        public BoundingBox(double x0, double y0, double z0, double x1, double y1, double z1) { Min = new Point3d(x0, y0, z0); Max = new Point3d(x1, y1, z1); }
        public BoundingBox(IEnumerable<Point3d> points) { this = Empty; foreach (Point3d p in points) Union(p); }
        public BoundingBox(IEnumerable<Point3d> points, Transform t) { this = Empty; foreach (Point3d p in points) Union(t * p); }
        public static BoundingBox Empty { get { return new BoundingBox(1, 0, 0, -1, 0, 0); } }
        public static BoundingBox Unset { get { return new BoundingBox(Point3d.Unset, Point3d.Unset); } }
        public bool IsValid { get { return Min.IsValid && Max.IsValid && Min.X <= Max.X && Min.Y <= Max.Y && Min.Z <= Max.Z; } }
        public Point3d Center { get { return (Min + Max) * 0.5; } }
        public Vector3d Diagonal { get { return Max - Min; } }
        public double Volume { get { Vector3d d = Diagonal; return IsValid ? d.X * d.Y * d.Z : 0; } }
        public double Area { get { Vector3d d = Diagonal; return IsValid ? 2 * (d.X * d.Y + d.Y * d.Z + d.Z * d.X) : 0; } }
        public Point3d PointAt(double x, double y, double z) { return new Point3d((1 - x) * Min.X + x * Max.X, (1 - y) * Min.Y + y * Max.Y, (1 - z) * Min.Z + z * Max.Z); }
        public Point3d Corner(bool minX, bool minY, bool minZ) { return new Point3d(minX ? Min.X : Max.X, minY ? Min.Y : Max.Y, minZ ? Min.Z : Max.Z); }
        public Point3d[] GetCorners()
        {
            return new Point3d[] { new Point3d(Min.X, Min.Y, Min.Z), new Point3d(Max.X, Min.Y, Min.Z), new Point3d(Max.X, Max.Y, Min.Z), new Point3d(Min.X, Max.Y, Min.Z),
                new Point3d(Min.X, Min.Y, Max.Z), new Point3d(Max.X, Min.Y, Max.Z), new Point3d(Max.X, Max.Y, Max.Z), new Point3d(Min.X, Max.Y, Max.Z) };
        }
        public Line[] GetEdges()
        {
            Point3d[] c = GetCorners();
            Line[] all = new Line[12];
            for (int i = 0; i < 4; i++) { all[i] = new Line(c[i], c[(i + 1) % 4]); all[i + 4] = new Line(c[i + 4], c[(i + 1) % 4 + 4]); all[i + 8] = new Line(c[i], c[i + 4]); }
            return all;
        }
        public bool Contains(Point3d p) { return Contains(p, false); }
        public bool Contains(Point3d p, bool strict)
        {
            if (strict) return p.X > Min.X && p.X < Max.X && p.Y > Min.Y && p.Y < Max.Y && p.Z > Min.Z && p.Z < Max.Z;
            return p.X >= Min.X && p.X <= Max.X && p.Y >= Min.Y && p.Y <= Max.Y && p.Z >= Min.Z && p.Z <= Max.Z;
        }
        public bool Contains(BoundingBox b) { return Contains(b.Min) && Contains(b.Max); }
        public bool Contains(BoundingBox b, bool strict) { return Contains(b.Min, strict) && Contains(b.Max, strict); }
        public Point3d ClosestPoint(Point3d p) { return new Point3d(RhinoMath.Clamp(p.X, Min.X, Max.X), RhinoMath.Clamp(p.Y, Min.Y, Max.Y), RhinoMath.Clamp(p.Z, Min.Z, Max.Z)); }
        public Point3d FurthestPoint(Point3d p) { Point3d m = Center; return new Point3d(p.X < m.X ? Max.X : Min.X, p.Y < m.Y ? Max.Y : Min.Y, p.Z < m.Z ? Max.Z : Min.Z); }
        public void Inflate(double amount) { Inflate(amount, amount, amount); }
        public void Inflate(double x, double y, double z) { Vector3d v = new Vector3d(x, y, z); Min = Min - v; Max = Max + v; }
        public bool MakeValid()
        {
            Point3d a = Min, b = Max;
            Min = new Point3d(Math.Min(a.X, b.X), Math.Min(a.Y, b.Y), Math.Min(a.Z, b.Z));
            Max = new Point3d(Math.Max(a.X, b.X), Math.Max(a.Y, b.Y), Math.Max(a.Z, b.Z));
            return IsValid;
        }
        public void Union(Point3d p)
        {
            if (!IsValid) { Min = p; Max = p; return; }
            Min = new Point3d(Math.Min(Min.X, p.X), Math.Min(Min.Y, p.Y), Math.Min(Min.Z, p.Z));
            Max = new Point3d(Math.Max(Max.X, p.X), Math.Max(Max.Y, p.Y), Math.Max(Max.Z, p.Z));
        }
        public void Union(BoundingBox b) { if (b.IsValid) { Union(b.Min); Union(b.Max); } }
        public static BoundingBox Union(BoundingBox a, BoundingBox b) { a.Union(b); return a; }
        public static BoundingBox Union(BoundingBox a, Point3d p) { a.Union(p); return a; }
        public static BoundingBox Intersection(BoundingBox a, BoundingBox b)
        {
            if (!a.IsValid || !b.IsValid) return Unset;
            BoundingBox c = new BoundingBox(Math.Max(a.Min.X, b.Min.X), Math.Max(a.Min.Y, b.Min.Y), Math.Max(a.Min.Z, b.Min.Z), Math.Min(a.Max.X, b.Max.X), Math.Min(a.Max.Y, b.Max.Y), Math.Min(a.Max.Z, b.Max.Z));
            return c.IsValid ? c : Unset;
        }
        public bool Transform(Transform t) { this = t.TransformBoundingBox(this); return IsValid; }
        public Brep ToBrep() { return Brep.CreateFromBox(this); }
        public override string ToString() { return Min + " - " + Max; }
    }
    public struct Box
    {
        public Plane Plane; public Interval X; public Interval Y; public Interval Z;
        public Box(Box other) { this = other; }
        public Box(BoundingBox b) { Plane = Plane.WorldXY; X = new Interval(b.Min.X, b.Max.X); Y = new Interval(b.Min.Y, b.Max.Y); Z = new Interval(b.Min.Z, b.Max.Z); }
        public Box(Plane plane, BoundingBox b) { Plane = plane; X = new Interval(b.Min.X, b.Max.X); Y = new Interval(b.Min.Y, b.Max.Y); Z = new Interval(b.Min.Z, b.Max.Z); }
        public Box(Plane plane, Interval x, Interval y, Interval z) { Plane = plane; X = x; Y = y; Z = z; }
        public Box(Plane plane, IEnumerable<Point3d> points)
        {
            BoundingBox b = BoundingBox.Empty;
            foreach (Point3d p in points) { Point3d local; plane.RemapToPlaneSpace(p, out local); b.Union(local); }
            this = new Box(plane, b);
        }
        public static Box Empty { get { return new Box(Plane.WorldXY, new Interval(1, -1), new Interval(1, -1), new Interval(1, -1)); } }
        public static Box Unset { get { return new Box(Plane.Unset, Interval.Unset, Interval.Unset, Interval.Unset); } }
        public bool IsValid { get { return Plane.IsValid && X.IsValid && Y.IsValid && Z.IsValid; } }
        public Point3d Center { get { return PointAt(0.5, 0.5, 0.5); } }
        public double Volume { get { return Math.Abs(X.Length * Y.Length * Z.Length); } }
        public double Area { get { double a = Math.Abs(X.Length), b = Math.Abs(Y.Length), c = Math.Abs(Z.Length); return 2 * (a * b + b * c + c * a); } }
        public BoundingBox BoundingBox { get { return new BoundingBox(GetCorners()); } }
        public Point3d PointAt(double x, double y, double z) { return Plane.PointAt(X.ParameterAt(x), Y.ParameterAt(y), Z.ParameterAt(z)); }
        public Point3d[] GetCorners()
        {
            return new Point3d[] { PointAt(0, 0, 0), PointAt(1, 0, 0), PointAt(1, 1, 0), PointAt(0, 1, 0), PointAt(0, 0, 1), PointAt(1, 0, 1), PointAt(1, 1, 1), PointAt(0, 1, 1) };
        }
        public bool Contains(Point3d p) { return Contains(p, false); }
        public bool Contains(Point3d p, bool strict) { Point3d l; Plane.RemapToPlaneSpace(p, out l); return X.IncludesParameter(l.X, strict) && Y.IncludesParameter(l.Y, strict) && Z.IncludesParameter(l.Z, strict); }
        public Point3d ClosestPoint(Point3d p)
        {
            Point3d l;
            Plane.RemapToPlaneSpace(p, out l);
            return Plane.PointAt(RhinoMath.Clamp(l.X, X.Min, X.Max), RhinoMath.Clamp(l.Y, Y.Min, Y.Max), RhinoMath.Clamp(l.Z, Z.Min, Z.Max));
        }
        public void Inflate(double amount) { Inflate(amount, amount, amount); }
        public void Inflate(double x, double y, double z) { MakeValid(); X = new Interval(X.T0 - x, X.T1 + x); Y = new Interval(Y.T0 - y, Y.T1 + y); Z = new Interval(Z.T0 - z, Z.T1 + z); }
        public bool MakeValid() { X.MakeIncreasing(); Y.MakeIncreasing(); Z.MakeIncreasing(); return IsValid; }
        public void Union(Point3d p) { Point3d l; Plane.RemapToPlaneSpace(p, out l); X.Grow(l.X); Y.Grow(l.Y); Z.Grow(l.Z); }
        public void RepositionBasePlane(Point3d origin)
        {
            Point3d l;
            Plane.RemapToPlaneSpace(origin, out l);
            Plane.Origin = origin; X = X - l.X; Y = Y - l.Y; Z = Z - l.Z;
        }
        public bool Transform(Transform t)
        {
            Vector3d x = Plane.XAxis, y = Plane.YAxis, z = Plane.ZAxis;
            x.Transform(t); y.Transform(t); z.Transform(t);
            double a = x.Length, b = y.Length, c = z.Length;
            if (!Plane.Transform(t)) return false;
            X = new Interval(X.T0 * a, X.T1 * a); Y = new Interval(Y.T0 * b, Y.T1 * b); Z = new Interval(Z.T0 * c, Z.T1 * c);
            return true;
        }
        public Brep ToBrep() { return Brep.CreateFromBox(this); }
    }
    public struct Sphere
    {
        public Plane EquatorialPlane; public double Radius;
        public Sphere(Point3d center, double radius) { EquatorialPlane = Plane.WorldXY; EquatorialPlane.Origin = center; Radius = radius; }
        public Sphere(Plane equator, double radius) { EquatorialPlane = equator; Radius = radius; }
        public static Sphere Unset { get { return new Sphere(Plane.Unset, RhinoMath.UnsetValue); } }
        public bool IsValid { get { return EquatorialPlane.IsValid && RhinoMath.IsValidDouble(Radius) && Radius > 0; } }
        public Point3d Center { get { return EquatorialPlane.Origin; } set { EquatorialPlane.Origin = value; } }
        public double Diameter { get { return 2 * Radius; } set { Radius = 0.5 * value; } }
        public Point3d NorthPole { get { return EquatorialPlane.PointAt(0, 0, Radius); } }
        public Point3d SouthPole { get { return EquatorialPlane.PointAt(0, 0, -Radius); } }
        public BoundingBox BoundingBox { get { Vector3d r = new Vector3d(Radius, Radius, Radius); return new BoundingBox(Center - r, Center + r); } }
        public Vector3d NormalAt(double longitude, double latitude)
        {
            double c = Math.Cos(latitude);
            return EquatorialPlane.XAxis * (c * Math.Cos(longitude)) + EquatorialPlane.YAxis * (c * Math.Sin(longitude)) + EquatorialPlane.ZAxis * Math.Sin(latitude);
        }
        public Point3d PointAt(double longitude, double latitude) { return Center + NormalAt(longitude, latitude) * Radius; }
        public bool ClosestParameter(Point3d p, out double longitude, out double latitude)
        {
            Point3d l;
            EquatorialPlane.RemapToPlaneSpace(p, out l);
            longitude = Math.Atan2(l.Y, l.X);
            if (longitude < 0) longitude += 2 * Math.PI;
            latitude = Math.Atan2(l.Z, Math.Sqrt(l.X * l.X + l.Y * l.Y));
            return l != Point3d.Origin;
        }
        public Point3d ClosestPoint(Point3d p) { Vector3d v = p - Center; if (!v.Unitize()) v = EquatorialPlane.XAxis; return Center + v * Radius; }
        public Circle LatitudeRadians(double a) { return new Circle(EquatorialPlane, EquatorialPlane.PointAt(0, 0, Radius * Math.Sin(a)), Radius * Math.Cos(a)); }
        public Circle LatitudeDegrees(double a) { return LatitudeRadians(RhinoMath.ToRadians(a)); }
        public Circle LongitudeRadians(double a) { return new Circle(new Plane(Center, NormalAt(a, 0), EquatorialPlane.ZAxis), Radius); }
        public Circle LongitudeDegrees(double a) { return LongitudeRadians(RhinoMath.ToRadians(a)); }
        public bool Translate(Vector3d v) { return EquatorialPlane.Translate(v); }
        public bool Rotate(double angle, Vector3d axis) { return EquatorialPlane.Rotate(angle, axis, Center); }
        public bool Rotate(double angle, Vector3d axis, Point3d point) { return EquatorialPlane.Rotate(angle, axis, point); }
        public bool Transform(Transform t) { Circle c = new Circle(EquatorialPlane, Radius); if (!c.Transform(t)) return false; EquatorialPlane = c.Plane; Radius = c.Radius; return true; }
        public Brep ToBrep() { return Brep.CreateFromSphere(this); }
        public NurbsSurface ToNurbsSurface() { return NurbsSurface.CreateFromSphere(this); }
        public RevSurface ToRevSurface() { return RevSurface.CreateFromSphere(this); }
    }
    public struct Cylinder
    {
        public Plane BasePlane; public double Radius; public double Height1; public double Height2;
        public Cylinder(Circle circle) { BasePlane = circle.Plane; Radius = circle.Radius; Height1 = 0; Height2 = 0; }
        public Cylinder(Circle circle, double height) { BasePlane = circle.Plane; Radius = circle.Radius; Height1 = height < 0 ? height : 0; Height2 = height < 0 ? 0 : height; }
        public bool IsValid { get { return BasePlane.IsValid && Radius > 0; } }
        public bool IsFinite { get { return Height1 != Height2; } }
        public double TotalHeight { get { return Height2 - Height1; } }
        public Vector3d Axis { get { return BasePlane.ZAxis; } }
        public Point3d Center { get { return BasePlane.Origin; } }
        public Circle CircleAt(double t) { return new Circle(BasePlane, BasePlane.PointAt(0, 0, t), Radius); }
        public Line LineAt(double a) { double x = Radius * Math.Cos(a), y = Radius * Math.Sin(a); return new Line(BasePlane.PointAt(x, y, Height1), BasePlane.PointAt(x, y, Height2)); }
        public Brep ToBrep(bool capBottom, bool capTop) { return Brep.CreateFromCylinder(this, capBottom, capTop); }
        public NurbsSurface ToNurbsSurface() { return NurbsSurface.CreateFromCylinder(this); }
        public RevSurface ToRevSurface() { return RevSurface.CreateFromCylinder(this); }
    }
    public struct Cone
    {
        public Plane Plane; public double Height; public double Radius;
        public Cone(Plane plane, double height, double radius) { Plane = plane; Height = height; Radius = radius; }
        public bool IsValid { get { return Plane.IsValid && Height != 0 && Radius > 0; } }
        public Point3d ApexPoint { get { return Plane.Origin; } }
        public Point3d BasePoint { get { return Plane.PointAt(0, 0, Height); } }
        public Vector3d Axis { get { return Plane.ZAxis; } }
        public double AngleInRadians() { return Math.Atan(Radius / Height); }
        public double AngleInDegrees() { return RhinoMath.ToDegrees(AngleInRadians()); }
        public Brep ToBrep(bool capBottom) { return Brep.CreateFromCone(this, capBottom); }
        public NurbsSurface ToNurbsSurface() { return NurbsSurface.CreateFromCone(this); }
        public RevSurface ToRevSurface() { return RevSurface.CreateFromCone(this); }
    }
    public struct Torus
    {
        public Plane Plane; public double MajorRadius; public double MinorRadius;
        public Torus(Plane plane, double major, double minor) { Plane = plane; MajorRadius = major; MinorRadius = minor; }
        public bool IsValid { get { return Plane.IsValid && MinorRadius > 0 && MajorRadius > MinorRadius; } }
        public Brep ToBrep() { return Brep.CreateFromTorus(this); }
        public NurbsSurface ToNurbsSurface() { return NurbsSurface.CreateFromTorus(this); }
        public RevSurface ToRevSurface() { return RevSurface.CreateFromTorus(this); }
    }
    public struct Ray3d
    {
        public Point3d Position; public Vector3d Direction;
        public Ray3d(Point3d position, Vector3d direction) { Position = position; Direction = direction; }
        public Point3d PointAt(double t) { return Position + Direction * t; }
    }
    public struct MeshFace : IEquatable<MeshFace>
    {
        public int A; public int B; public int C; public int D;
        public MeshFace(int a, int b, int c) { A = a; B = b; C = c; D = c; }
        public MeshFace(int a, int b, int c, int d) { A = a; B = b; C = c; D = d; }
        public static MeshFace Unset { get { return new MeshFace(int.MinValue, int.MinValue, int.MinValue, int.MinValue); } }
        public int this[int i] { get { return i == 0 ? A : i == 1 ? B : i == 2 ? C : i == 3 ? D : throw new IndexOutOfRangeException(); } set { if (i == 0) A = value; else if (i == 1) B = value; else if (i == 2) C = value; else if (i == 3) D = value; else throw new IndexOutOfRangeException(); } }
        public bool IsTriangle { get { return C == D; } }
        public bool IsQuad { get { return C != D; } }
        public MeshFace Flip() { return C == D ? new MeshFace(A, C, B) : new MeshFace(A, D, C, B); }
        public bool Equals(MeshFace o) { return A == o.A && B == o.B && C == o.C && D == o.D; }
        public override bool Equals(object o) { return o is MeshFace && Equals((MeshFace)o); }
        public override int GetHashCode() { return A ^ B << 8 ^ C << 16 ^ D << 24; }
        public override string ToString() { return C == D ? "T(" + A + ", " + B + ", " + C + ")" : "Q(" + A + ", " + B + ", " + C + ", " + D + ")"; }
    }
}
