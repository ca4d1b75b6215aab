namespace Rhino.Geometry
{
    public struct Line : IEquatable<Line>
    {
        public Point3d From; public Point3d To;
        public Line(Point3d from, Point3d to) { From = from; To = to; }
        public Line(Point3d start, Vector3d span) { From = start; To = start + span; }
        public Line(Point3d start, Vector3d direction, double length) { direction.Unitize(); From = start; To = start + direction * length; }
        public Line(double x0, double y0, double z0, double x1, double y1, double z1) { From = new Point3d(x0, y0, z0); To = new Point3d(x1, y1, z1); }
        public static Line Unset { get { return new Line(Point3d.Unset, Point3d.Unset); } }
        public double FromX { get { return From.X; } set { From.X = value; } }
        public double FromY { get { return From.Y; } set { From.Y = value; } }
        public double FromZ { get { return From.Z; } set { From.Z = value; } }
        public double ToX { get { return To.X; } set { To.X = value; } }
        public double ToY { get { return To.Y; } set { To.Y = value; } }
        public double ToZ { get { return To.Z; } set { To.Z = value; } }
        public double Length { get { return From.DistanceTo(To); } set { Vector3d v = UnitTangent; if (v.IsZero) v = Vector3d.ZAxis; To = From + v * value; } }
        public Vector3d Direction { get { return To - From; } }
        public Vector3d UnitTangent { get { Vector3d v = To - From; v.Unitize(); return v; } }
        public bool IsValid { get { return From.IsValid && To.IsValid && From != To; } }
        public BoundingBox BoundingBox { get { return new BoundingBox(new Point3d[] { From, To }); } }
        public Point3d PointAt(double t) { return new Point3d((1 - t) * From.X + t * To.X, (1 - t) * From.Y + t * To.Y, (1 - t) * From.Z + t * To.Z); }
        public Point3d PointAtLength(double distance) { return From + UnitTangent * distance; }
        public void Flip() { Point3d p = From; From = To; To = p; }
        public bool Extend(double start, double end) { Vector3d v = UnitTangent; if (v.IsZero) return false; From = From - v * start; To = To + v * end; return true; }
        public double ClosestParameter(Point3d p) { Vector3d d = To - From; double q = d * d; return q > 0 ? ((p - From) * d) / q : 0; }
        public Point3d ClosestPoint(Point3d p, bool finite) { double t = ClosestParameter(p); if (finite) t = RhinoMath.Clamp(t, 0.0, 1.0); return PointAt(t); }
        public double DistanceTo(Point3d p, bool finite) { return ClosestPoint(p, finite).DistanceTo(p); }
        public double MinimumDistanceTo(Point3d p) { return DistanceTo(p, true); }
        public double MaximumDistanceTo(Point3d p) { return Math.Max(From.DistanceTo(p), To.DistanceTo(p)); }
        public double MaximumDistanceTo(Line o) { return Math.Max(MaximumDistanceTo(o.From), MaximumDistanceTo(o.To)); }
        public bool Transform(Transform t) { From = t * From; To = t * To; return true; }
        public NurbsCurve ToNurbsCurve() { return NurbsCurve.CreateFromLine(this); }
        public bool EpsilonEquals(Line o, double e) { return From.EpsilonEquals(o.From, e) && To.EpsilonEquals(o.To, e); }
        public static bool operator ==(Line a, Line b) { return a.From == b.From && a.To == b.To; }
        public static bool operator !=(Line a, Line b) { return !(a == b); }
        public bool Equals(Line o) { return this == o; }
        public override bool Equals(object o) { return o is Line && (Line)o == this; }
        public override int GetHashCode() { return From.GetHashCode() ^ To.GetHashCode(); }
        public override string ToString() { return From + "," + To; }
    }
    public struct Circle
    {
        public Plane Plane; public double Radius;
        public Circle(Plane plane, double radius) { Plane = plane; Radius = radius; }
        public Circle(Plane plane, Point3d center, double radius) { Plane = plane; Plane.Origin = center; Radius = radius; }
        public Circle(Point3d center, double radius) { Plane = Plane.WorldXY; Plane.Origin = center; Radius = radius; }
        public Circle(double radius) { Plane = Plane.WorldXY; Radius = radius; }
        public Circle(Arc arc) { Plane = arc.Plane; Radius = arc.Radius; }
        public Circle(Point3d a, Point3d b, Point3d c)
        {
            Point3d center;
            Plane = new Plane(); Radius = 0;
            if (!Through(a, b, c, out center)) { Plane = Plane.Unset; Radius = RhinoMath.UnsetValue; return; }
            Vector3d x = a - center, z = Vector3d.CrossProduct(b - a, c - a);
            Plane = new Plane(center, x, Vector3d.CrossProduct(z, x));
            Radius = center.DistanceTo(a);
        }
        // The centre by barycentric weights of the triangle's sides.
        static bool Through(Point3d a, Point3d b, Point3d c, out Point3d center)
        {
            Vector3d u = b - a, v = c - a, n = Vector3d.CrossProduct(u, v);
            double q = 2 * (n * n);
            center = a;
            if (!(q > 0)) return false;
            center = a + (Vector3d.CrossProduct(n, u) * (v * v) + Vector3d.CrossProduct(v, n) * (u * u)) / q;
            return true;
        }
        public Circle(Point3d start, Vector3d tangent, Point3d end)
        {
            Arc arc = new Arc(start, tangent, end);
            Plane = arc.Plane; Radius = arc.Radius;
        }
        public static Circle Unset { get { return new Circle(Plane.Unset, RhinoMath.UnsetValue); } }
        public Point3d Center { get { return Plane.Origin; } set { Plane.Origin = value; } }
        public double Diameter { get { return 2 * Radius; } set { Radius = 0.5 * value; } }
        public double Circumference { get { return 2 * Math.PI * Math.Abs(Radius); } set { Radius = value / (2 * Math.PI); } }
        public Vector3d Normal { get { return Plane.ZAxis; } }
        public bool IsValid { get { return RhinoMath.IsValidDouble(Radius) && Radius > 0 && Plane.IsValid; } }
        public BoundingBox BoundingBox { get { return new Arc(this, 2 * Math.PI).BoundingBox(); } }
        public Point3d PointAt(double t) { return Plane.PointAt(Radius * Math.Cos(t), Radius * Math.Sin(t)); }
        public Vector3d TangentAt(double t) { return Plane.YAxis * Math.Cos(t) - Plane.XAxis * Math.Sin(t); }
        public bool ClosestParameter(Point3d p, out double t)
        {
            double x, y;
            Plane.ClosestParameter(p, out x, out y);
            t = Math.Atan2(y, x);
            if (t < 0) t += 2 * Math.PI;
            return x != 0 || y != 0;
        }
        public Point3d ClosestPoint(Point3d p) { double t; ClosestParameter(p, out t); return PointAt(t); }
        public bool IsInPlane(Plane plane, double tolerance) { for (int i = 0; i < 4; i++) if (Math.Abs(plane.DistanceTo(PointAt(i * Math.PI / 2))) > tolerance) return false; return true; }
        public void Reverse() { Plane.YAxis = -Plane.YAxis; Plane.ZAxis = -Plane.ZAxis; }
        public bool Rotate(double angle, Vector3d axis) { return Rotate(angle, axis, Center); }
        public bool Rotate(double angle, Vector3d axis, Point3d point) { return Plane.Rotate(angle, axis, point); }
        public bool Translate(Vector3d v) { return Plane.Translate(v); }
        public bool Transform(Transform t)
        {
            Vector3d x = Plane.XAxis;
            x.Transform(t);
            double scale = x.Length;
            if (!Plane.Transform(t)) return false;
            Radius *= scale;
            return true;
        }
        public NurbsCurve ToNurbsCurve() { return NurbsCurve.CreateFromCircle(this); }
        public override string ToString() { return "Circle (Radius = " + Radius + ", Center= " + Center + ")"; }
    }
    public struct Arc
    {
        public Plane Plane; public double Radius; public Interval AngleDomain;
        public Arc(Circle circle, double angle) { Plane = circle.Plane; Radius = circle.Radius; AngleDomain = new Interval(0, angle); }
        public Arc(Circle circle, Interval angles) { Plane = circle.Plane; Radius = circle.Radius; AngleDomain = angles; }
        public Arc(Plane plane, double radius, double angle) { Plane = plane; Radius = radius; AngleDomain = new Interval(0, angle); }
        public Arc(Point3d center, double radius, double angle) { Plane = Plane.WorldXY; Plane.Origin = center; Radius = radius; AngleDomain = new Interval(0, angle); }
        public Arc(Plane plane, Point3d center, double radius, double angle) { Plane = plane; Plane.Origin = center; Radius = radius; AngleDomain = new Interval(0, angle); }
        public Arc(Point3d start, Point3d interior, Point3d end)
        {
            Circle c = new Circle(start, interior, end);
            Plane = c.Plane; Radius = c.Radius; AngleDomain = Interval.Unset;
            double t;
            if (c.ClosestParameter(end, out t)) AngleDomain = new Interval(0, t);
        }
        // The circle through both points that the direction touches: its centre lies across the direction in the plane of the two.
        public Arc(Point3d start, Vector3d tangent, Point3d end)
        {
            Vector3d chord = end - start, n = Vector3d.CrossProduct(tangent, chord);
            Plane = Plane.Unset; Radius = RhinoMath.UnsetValue; AngleDomain = Interval.Unset;
            if (!tangent.Unitize() || !n.Unitize()) return;
            Vector3d across = Vector3d.CrossProduct(n, tangent);
            Radius = (chord * chord) / (2 * (chord * across));
            Point3d center = start + across * Radius;
            Plane = new Plane(center, start - center, tangent);
            double t;
            new Circle(Plane, Radius).ClosestParameter(end, out t);
            AngleDomain = new Interval(0, t);
        }
        public static Arc Unset { get { return new Arc(Circle.Unset, Interval.Unset); } }
        public Point3d Center { get { return Plane.Origin; } set { Plane.Origin = value; } }
        public double Diameter { get { return 2 * Radius; } set { Radius = 0.5 * value; } }
        public double Circumference { get { return 2 * Math.PI * Math.Abs(Radius); } }
        public double Angle { get { return AngleDomain.Length; } set { AngleDomain = new Interval(AngleDomain.T0, AngleDomain.T0 + value); } }
        public double AngleDegrees { get { return RhinoMath.ToDegrees(Angle); } set { Angle = RhinoMath.ToRadians(value); } }
        public double StartAngle { get { return AngleDomain.T0; } set { AngleDomain = new Interval(value, AngleDomain.T1); } }
        public double EndAngle { get { return AngleDomain.T1; } set { AngleDomain = new Interval(AngleDomain.T0, value); } }
        public double StartAngleDegrees { get { return RhinoMath.ToDegrees(StartAngle); } set { StartAngle = RhinoMath.ToRadians(value); } }
        public double EndAngleDegrees { get { return RhinoMath.ToDegrees(EndAngle); } set { EndAngle = RhinoMath.ToRadians(value); } }
        public double Length { get { return Math.Abs(Angle * Radius); } }
        public bool IsCircle { get { return Math.Abs(Math.Abs(Angle) - 2 * Math.PI) <= RhinoMath.ZeroTolerance; } }
        public bool IsValid { get { return Radius > 0 && RhinoMath.IsValidDouble(Radius) && Plane.IsValid && AngleDomain.IsIncreasing && Angle <= 2 * Math.PI + RhinoMath.ZeroTolerance; } }
        public Point3d StartPoint { get { return PointAt(AngleDomain.T0); } }
        public Point3d MidPoint { get { return PointAt(AngleDomain.Mid); } }
        public Point3d EndPoint { get { return PointAt(AngleDomain.T1); } }
        public Point3d PointAt(double t) { return Plane.PointAt(Radius * Math.Cos(t), Radius * Math.Sin(t)); }
        public Vector3d TangentAt(double t) { return Plane.YAxis * Math.Cos(t) - Plane.XAxis * Math.Sin(t); }
        public BoundingBox BoundingBox() { return ToNurbsCurve().GetBoundingBox(true); }
        public double ClosestParameter(Point3d p)
        {
            double t;
            new Circle(Plane, Radius).ClosestParameter(p, out t);
            while (t < AngleDomain.T0) t += 2 * Math.PI;
            while (t - 2 * Math.PI >= AngleDomain.T0) t -= 2 * Math.PI;
            if (t <= AngleDomain.T1) return t;
            return p.DistanceTo(StartPoint) <= p.DistanceTo(EndPoint) ? AngleDomain.T0 : AngleDomain.T1;
        }
        public Point3d ClosestPoint(Point3d p) { return PointAt(ClosestParameter(p)); }
        public void Reverse() { AngleDomain.Reverse(); Plane.YAxis = -Plane.YAxis; Plane.ZAxis = -Plane.ZAxis; }
        public bool Trim(Interval domain) { if (!domain.IsIncreasing || domain.Length > 2 * Math.PI) return false; AngleDomain = domain; return true; }
        public bool Transform(Transform t) { Circle c = new Circle(Plane, Radius); if (!c.Transform(t)) return false; Plane = c.Plane; Radius = c.Radius; return true; }
        public NurbsCurve ToNurbsCurve() { return NurbsCurve.CreateFromArc(this); }
        public override string ToString() { return "Arc (Radius = " + Radius + ", Angle = " + Angle + ")"; }
    }
    public struct Ellipse
    {
        public Plane Plane; public double Radius1; public double Radius2;
        public Ellipse(Plane plane, double radius1, double radius2) { Plane = plane; Radius1 = radius1; Radius2 = radius2; }
        public Ellipse(Point3d center, Point3d second, Point3d third) { Plane = new Plane(center, second, third); Radius1 = center.DistanceTo(second); Radius2 = center.DistanceTo(third); }
        public Point3d Center { get { return Plane.Origin; } set { Plane.Origin = value; } }
        public bool IsValid { get { return Plane.IsValid && Radius1 > 0 && Radius2 > 0; } }
        public double FocalDistance { get { return Math.Sqrt(Math.Abs(Radius1 * Radius1 - Radius2 * Radius2)); } }
        public NurbsCurve ToNurbsCurve() { return NurbsCurve.CreateFromEllipse(this); }
    }
    public struct Rectangle3d
    {
        public Plane Plane; public Interval X; public Interval Y;
        public Rectangle3d(Plane plane, double width, double height) { Plane = plane; X = new Interval(0, width); Y = new Interval(0, height); MakeIncreasing(); }
        public Rectangle3d(Plane plane, Interval width, Interval height) { Plane = plane; X = width; Y = height; }
        public Rectangle3d(Plane plane, Point3d a, Point3d b)
        {
            double x0, y0, x1, y1;
            plane.ClosestParameter(a, out x0, out y0); plane.ClosestParameter(b, out x1, out y1);
            Plane = plane; X = new Interval(x0, x1); Y = new Interval(y0, y1);
            MakeIncreasing();
        }
        public static Rectangle3d Unset { get { return new Rectangle3d(Plane.Unset, Interval.Unset, Interval.Unset); } }
        public bool IsValid { get { return Plane.IsValid && X.IsValid && Y.IsValid; } }
        public double Width { get { return Math.Abs(X.Length); } set { X = new Interval(X.T0, X.T0 + value); } }
        public double Height { get { return Math.Abs(Y.Length); } set { Y = new Interval(Y.T0, Y.T0 + value); } }
        public double Area { get { return Width * Height; } }
        public double Circumference { get { return 2 * (Width + Height); } }
        public Point3d Center { get { return Plane.PointAt(X.Mid, Y.Mid); } }
        public BoundingBox BoundingBox { get { return new BoundingBox(new Point3d[] { Corner(0), Corner(1), Corner(2), Corner(3) }); } }
        public Point3d Corner(int i)
        {
            switch (i)
            {
                case 0: return Plane.PointAt(X.T0, Y.T0); case 1: return Plane.PointAt(X.T1, Y.T0);
                case 2: return Plane.PointAt(X.T1, Y.T1); case 3: return Plane.PointAt(X.T0, Y.T1);
            }
            throw new IndexOutOfRangeException("Rectangle corner index must be between and including 0 and 3");
        }
        public Point3d PointAt(double x, double y) { return Plane.PointAt(X.ParameterAt(x), Y.ParameterAt(y)); }
        // By a parameter from 0 to 4, a side each.
        public Point3d PointAt(double t)
        {
            t = RhinoMath.Clamp(t, 0.0, 4.0);
            int side = Math.Min((int)t, 3);
            return new Line(Corner(side), Corner((side + 1) % 4)).PointAt(t - side);
        }
        public PointContainment Contains(Point3d p) { double x, y; Plane.ClosestParameter(p, out x, out y); return Contains(x, y); }
        public PointContainment Contains(double x, double y)
        {
            if (!X.IncludesParameter(x) || !Y.IncludesParameter(y)) return PointContainment.Outside;
            return x == X.T0 || x == X.T1 || y == Y.T0 || y == Y.T1 ? PointContainment.Coincident : PointContainment.Inside;
        }
        public Point3d ClosestPoint(Point3d p) { return ClosestPoint(p, true); }
        public Point3d ClosestPoint(Point3d p, bool includeInterior)
        {
            double u, v;
            Plane.ClosestParameter(p, out u, out v);
            double x = RhinoMath.Clamp(u, X.Min, X.Max), y = RhinoMath.Clamp(v, Y.Min, Y.Max);
            if (!includeInterior && x == u && y == v)
            {
                double west = x - X.Min, east = X.Max - x, south = y - Y.Min, north = Y.Max - y, least = Math.Min(Math.Min(west, east), Math.Min(south, north));
                if (least == west) x = X.Min; else if (least == south) y = Y.Min; else if (least == north) y = Y.Max; else x = X.Max;
            }
            return Plane.PointAt(x, y);
        }
        public void MakeIncreasing() { X.MakeIncreasing(); Y.MakeIncreasing(); }
        public void RecenterPlane(int corner) { RecenterPlane(Corner(corner)); }
        public void RecenterPlane(Point3d origin)
        {
            double u, v;
            Plane.ClosestParameter(origin, out u, out v);
            Plane.Origin = Plane.PointAt(u, v);
            X = X - u; Y = Y - v;
        }
        public bool Transform(Transform t)
        {
            Vector3d x = Plane.XAxis, y = Plane.YAxis;
            x.Transform(t); y.Transform(t);
            double a = x.Length, b = y.Length;
            if (!Plane.Transform(t)) return false;
            X = new Interval(X.T0 * a, X.T1 * a); Y = new Interval(Y.T0 * b, Y.T1 * b);
            return true;
        }
        public Polyline ToPolyline() { return new Polyline(new Point3d[] { Corner(0), Corner(1), Corner(2), Corner(3), Corner(0) }); }
        public NurbsCurve ToNurbsCurve() { return ToPolyline().ToNurbsCurve(); }
    }
}
