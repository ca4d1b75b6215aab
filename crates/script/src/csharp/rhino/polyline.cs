namespace Rhino.Collections
{
    using Rhino.Geometry;
    public class RhinoList<T> : IList<T>
    {
        protected List<T> items;
        public RhinoList() { items = new List<T>(); }
        public RhinoList(int capacity) { items = new List<T>(); }
        public RhinoList(IEnumerable<T> own) { items = new List<T>(own); }
        public int Count { get { return items.Count; } }
        public int Capacity { get { return items.Count; } set { } }
        public bool IsReadOnly { get { return false; } }
        public T this[int i] { get { return items[i]; } set { items[i] = value; } }
        public T First { get { return items[0]; } set { items[0] = value; } }
        public T Last { get { return items[items.Count - 1]; } set { items[items.Count - 1] = value; } }
        public void Add(T item) { items.Add(item); }
        public void AddRange(IEnumerable<T> more) { items.AddRange(more); }
        public void Insert(int i, T item) { items.Insert(i, item); }
        public void InsertRange(int i, IEnumerable<T> more) { items.InsertRange(i, more); }
        public bool Remove(T item) { return items.Remove(item); }
        public void RemoveAt(int i) { items.RemoveAt(i); }
        public void RemoveRange(int i, int count) { items.RemoveRange(i, count); }
        public int RemoveAll(Predicate<T> match) { return items.RemoveAll(match); }
        public void Clear() { items.Clear(); }
        public bool Contains(T item) { return items.Contains(item); }
        public int IndexOf(T item) { return items.IndexOf(item); }
        public int FindIndex(Predicate<T> match) { return items.FindIndex(match); }
        public T Find(Predicate<T> match) { return items.Find(match); }
        public void CopyTo(T[] to) { items.CopyTo(to); }
        public void CopyTo(T[] to, int at) { items.CopyTo(to, at); }
        public void Reverse() { items.Reverse(); }
        public void Sort() { items.Sort(); }
        public void Sort(Comparison<T> order) { items.Sort(order); }
        public T[] ToArray() { return items.ToArray(); }
        public IEnumerator<T> GetEnumerator() { return items.GetEnumerator(); }
        IEnumerator IEnumerable.GetEnumerator() { return items.GetEnumerator(); }
    }
    public class CurveList : RhinoList<Curve>
    {
        public CurveList() { }
        public CurveList(IEnumerable<Curve> curves) : base(curves) { }
        public void Add(Line line) { Add(new LineCurve(line)); }
        public void Add(Circle circle) { Add(new ArcCurve(circle)); }
        public void Add(Arc arc) { Add(new ArcCurve(arc)); }
        public void Add(Polyline polyline) { Add(polyline.ToPolylineCurve()); }
    }
    public class Point3dList : RhinoList<Point3d>
    {
        public Point3dList() { }
        public Point3dList(int capacity) : base(capacity) { }
        public Point3dList(IEnumerable<Point3d> own) : base(own) { }
        public BoundingBox BoundingBox { get { return new BoundingBox(items); } }
        public void Add(double x, double y, double z) { items.Add(new Point3d(x, y, z)); }
        public int ClosestIndex(Point3d p) { return ClosestIndexInList(items, p); }
        public static int ClosestIndexInList(IList<Point3d> list, Point3d p)
        {
            int best = -1;
            double least = double.MaxValue;
            for (int i = 0; i < list.Count; i++) { double d = list[i].DistanceToSquared(p); if (d < least) { least = d; best = i; } }
            return best;
        }
        public static Point3d ClosestPointInList(IList<Point3d> list, Point3d p) { int i = ClosestIndexInList(list, p); return i < 0 ? Point3d.Unset : list[i]; }
        public void Transform(Transform t) { for (int i = 0; i < items.Count; i++) items[i] = t * items[i]; }
        public void SetAllX(double x) { for (int i = 0; i < items.Count; i++) items[i] = new Point3d(x, items[i].Y, items[i].Z); }
        public void SetAllY(double y) { for (int i = 0; i < items.Count; i++) items[i] = new Point3d(items[i].X, y, items[i].Z); }
        public void SetAllZ(double z) { for (int i = 0; i < items.Count; i++) items[i] = new Point3d(items[i].X, items[i].Y, z); }
    }
}
namespace Rhino.Geometry
{
    using Rhino.Collections;
    public class Polyline : Point3dList
    {
        public Polyline() { }
        public Polyline(int capacity) : base(capacity) { }
        public Polyline(IEnumerable<Point3d> own) : base(own) { }
        public int SegmentCount { get { return Math.Max(0, items.Count - 1); } }
        public bool IsClosed { get { return items.Count > 2 && First == Last; } }
        public bool IsClosedWithinTolerance(double tolerance) { return items.Count > 2 && First.DistanceTo(Last) <= tolerance; }
        public bool IsValid
        {
            get
            {
                if (items.Count < 2) return false;
                for (int i = 0; i < items.Count; i++) if (!items[i].IsValid || i > 0 && items[i] == items[i - 1]) return false;
                return items.Count > 2 || !(First == Last);
            }
        }
        public double Length { get { double sum = 0; for (int i = 1; i < items.Count; i++) sum += items[i - 1].DistanceTo(items[i]); return sum; } }
        public Line SegmentAt(int i) { if (i < 0 || i >= SegmentCount) throw new ArgumentOutOfRangeException("index"); return new Line(items[i], items[i + 1]); }
        public Line[] GetSegments() { Line[] all = new Line[SegmentCount]; for (int i = 0; i < all.Length; i++) all[i] = SegmentAt(i); return all; }
        // The whole part of a parameter is the segment, the rest the place on it.
        public Point3d PointAt(double t)
        {
            if (items.Count == 0) return Point3d.Origin;
            int i = (int)Math.Floor(t);
            if (t < 0) return First;
            if (i >= items.Count - 1) return Last;
            return SegmentAt(i).PointAt(t - i);
        }
        public Vector3d TangentAt(double t) { if (SegmentCount == 0) return Vector3d.Zero; return SegmentAt(RhinoMath.Clamp((int)Math.Floor(t), 0, SegmentCount - 1)).UnitTangent; }
        public double ClosestParameter(Point3d p)
        {
            double best = 0, least = double.MaxValue;
            for (int i = 0; i < SegmentCount; i++)
            {
                Line s = SegmentAt(i);
                double t = RhinoMath.Clamp(s.ClosestParameter(p), 0.0, 1.0), d = s.PointAt(t).DistanceTo(p);
                if (d < least) { least = d; best = i + t; }
            }
            return best;
        }
        public Point3d ClosestPoint(Point3d p) { return PointAt(ClosestParameter(p)); }
        // The middle of the points; the first of a closed polyline counts once.
        public Point3d CenterPoint()
        {
            if (items.Count == 0) return Point3d.Unset;
            if (SegmentCount == 0) return First;
            Point3d sum = Point3d.Origin;
            double weight = 0;
            foreach (Line s in GetSegments()) { sum += s.PointAt(0.5) * s.Length; weight += s.Length; }
            return weight > 0 ? sum / weight : First;
        }
        public Polyline Duplicate() { return new Polyline(items); }
        public Polyline Trim(Interval domain)
        {
            Polyline made = new Polyline();
            double a = domain.Min, b = domain.Max;
            made.Add(PointAt(a));
            for (int i = (int)Math.Floor(a) + 1; i < b && i < items.Count; i++) made.Add(items[i]);
            made.Add(PointAt(b));
            return made;
        }
        public int DeleteShortSegments(double tolerance)
        {
            int before = items.Count;
            for (int i = 1; i < items.Count;)
            {
                if (items[i].DistanceTo(items[i - 1]) > tolerance) { i++; continue; }
                if (i == items.Count - 1 && i > 1) items.RemoveAt(i - 1); else items.RemoveAt(i);
            }
            return before - items.Count;
        }
        public bool Smooth(double amount)
        {
            int n = items.Count;
            if (n < 3) return false;
            List<Point3d> old = new List<Point3d>(items);
            bool closed = IsClosed;
            for (int i = closed ? 0 : 1; i < n - 1; i++)
            {
                Point3d mean = (old[i == 0 ? n - 2 : i - 1] + old[i + 1]) * 0.5;
                items[i] = old[i] + (mean - old[i]) * amount;
            }
            if (closed) items[n - 1] = items[0];
            return true;
        }
        public NurbsCurve ToNurbsCurve() { return ToPolylineCurve().ToNurbsCurve(); }
        public PolylineCurve ToPolylineCurve() { return new PolylineCurve(items); }
        public static Polyline CreateInscribedPolygon(Circle circle, int sides)
        {
            if (sides < 3) return null;
            Polyline made = new Polyline();
            for (int i = 0; i < sides; i++) made.Add(circle.PointAt(i * 2 * Math.PI / sides));
            made.Add(made[0]);
            return made;
        }
        public static Polyline CreateCircumscribedPolygon(Circle circle, int sides) { if (sides < 3) return null; circle.Radius /= Math.Cos(Math.PI / sides); return CreateInscribedPolygon(circle, sides); }
    }
}
