namespace Grasshopper.Kernel
{
    public enum GH_RuntimeMessageLevel { Blank = 0, Warning = 10, Error = 20, Remark = 255 }
    public interface IGH_Component
    {
        string Name { get; set; }
        string NickName { get; set; }
        string Message { get; set; }
        string Description { get; set; }
        void AddRuntimeMessage(GH_RuntimeMessageLevel level, string text);
    }
    public class GH_Component : IGH_Component
    {
        public List<string> __texts = new List<string>();
        public List<int> __levels = new List<int>();
        public string Name { get; set; }
        public string NickName { get; set; }
        public string Message { get; set; }
        public string Description { get; set; }
        public void AddRuntimeMessage(GH_RuntimeMessageLevel level, string text) { __levels.Add((int)level); __texts.Add(text); }
    }
    public class IGH_PreviewArgs { public Rhino.Display.DisplayPipeline Display { get { return null; } } public System.Drawing.Color WireColour { get { return System.Drawing.Color.Black; } } public int DefaultCurveThickness { get { return 1; } } }
    public class GH_Document { }
}
namespace Grasshopper.Kernel.Types
{
    using Rhino.Geometry;
    public interface IGH_Goo { }
    public class GH_Goo<T> : IGH_Goo
    {
        public T Value;
        public bool IsValid { get { return Value != null; } }
        public override string ToString() { return Value == null ? "" : Value.ToString(); }
    }
    public class GH_Number : GH_Goo<double> { public GH_Number(double value) { Value = value; } }
    public class GH_Integer : GH_Goo<int> { public GH_Integer(int value) { Value = value; } }
    public class GH_Boolean : GH_Goo<bool> { public GH_Boolean(bool value) { Value = value; } }
    public class GH_String : GH_Goo<string> { public GH_String(string value) { Value = value; } }
    public class GH_Colour : GH_Goo<System.Drawing.Color> { public GH_Colour(System.Drawing.Color value) { Value = value; } }
    public class GH_Point : GH_Goo<Point3d> { public GH_Point(Point3d value) { Value = value; } }
    public class GH_Vector : GH_Goo<Vector3d> { public GH_Vector(Vector3d value) { Value = value; } }
    public class GH_Plane : GH_Goo<Plane> { public GH_Plane(Plane value) { Value = value; } }
    public class GH_Interval : GH_Goo<Interval> { public GH_Interval(Interval value) { Value = value; } }
    public class GH_Line : GH_Goo<Line> { public GH_Line(Line value) { Value = value; } }
    public class GH_Circle : GH_Goo<Circle> { public GH_Circle(Circle value) { Value = value; } }
    public class GH_Arc : GH_Goo<Arc> { public GH_Arc(Arc value) { Value = value; } }
    public class GH_Rectangle : GH_Goo<Rectangle3d> { public GH_Rectangle(Rectangle3d value) { Value = value; } }
    public class GH_Box : GH_Goo<Box> { public GH_Box(Box value) { Value = value; } }
    public class GH_Curve : GH_Goo<Curve> { public GH_Curve(Curve value) { Value = value; } }
    public class GH_Surface : GH_Goo<Brep> { public GH_Surface(Brep value) { Value = value; } public GH_Surface(Surface value) { Value = value.ToBrep(); } }
    public class GH_Brep : GH_Goo<Brep> { public GH_Brep(Brep value) { Value = value; } }
    public class GH_Mesh : GH_Goo<Mesh> { public GH_Mesh(Mesh value) { Value = value; } }
    public class GH_ObjectWrapper : GH_Goo<object> { public GH_ObjectWrapper(object value) { Value = value; } }
}
namespace Grasshopper.Kernel.Data
{
    public class GH_Path : IComparable<GH_Path>
    {
        int[] indices;
        public GH_Path() { indices = new int[0]; }
        public GH_Path(int index) { indices = new int[] { index }; }
        public GH_Path(params int[] own) { indices = (int[])own.Clone(); }
        public GH_Path(GH_Path other) { indices = (int[])other.indices.Clone(); }
        public int Length { get { return indices.Length; } }
        public int[] Indices { get { return indices; } set { indices = value; } }
        public bool Valid { get { return indices.Length > 0; } }
        public int this[int i] { get { return indices[i]; } set { indices[i] = value; } }
        public int get_Dimension(int i) { return indices[i]; }
        GH_Path Part(int from, int count) { int[] part = new int[Math.Max(0, count)]; for (int k = 0; k < part.Length; k++) part[k] = indices[from + k]; return new GH_Path(part); }
        public GH_Path AppendElement(int i) { int[] more = new int[indices.Length + 1]; for (int k = 0; k < indices.Length; k++) more[k] = indices[k]; more[indices.Length] = i; return new GH_Path(more); }
        public GH_Path PrependElement(int i) { int[] more = new int[indices.Length + 1]; for (int k = 0; k < indices.Length; k++) more[k + 1] = indices[k]; more[0] = i; return new GH_Path(more); }
        public GH_Path CullElement() { return Part(0, indices.Length - 1); }
        public GH_Path CullFirstElement() { return Part(1, indices.Length - 1); }
        public GH_Path Increment(int index) { return Increment(index, 1); }
        public GH_Path Increment(int index, int offset) { GH_Path made = new GH_Path(this); made.indices[index] += offset; return made; }
        public bool IsCoincident(GH_Path other) { return Equals(other); }
        public int CompareTo(GH_Path o)
        {
            for (int i = 0; i < indices.Length && i < o.indices.Length; i++) if (indices[i] != o.indices[i]) return indices[i] < o.indices[i] ? -1 : 1;
            return indices.Length.CompareTo(o.indices.Length);
        }
        public static bool operator ==(GH_Path a, GH_Path b) { return object.ReferenceEquals(a, null) ? object.ReferenceEquals(b, null) : a.Equals(b); }
        public static bool operator !=(GH_Path a, GH_Path b) { return !(a == b); }
        public override bool Equals(object o)
        {
            GH_Path p = o as GH_Path;
            if (object.ReferenceEquals(p, null) || p.indices.Length != indices.Length) return false;
            for (int i = 0; i < indices.Length; i++) if (indices[i] != p.indices[i]) return false;
            return true;
        }
        public override int GetHashCode() { int h = 17; foreach (int i in indices) h = unchecked(h * 31 + i); return h; }
        public override string ToString() { return "{" + string.Join(";", indices) + "}"; }
        public string ToString(bool brackets) { return brackets ? ToString() : string.Join(";", indices); }
    }
}
namespace Grasshopper
{
    using Grasshopper.Kernel.Data;
    public class DataTree<T>
    {
        List<GH_Path> paths = new List<GH_Path>();
        List<List<T>> branches = new List<List<T>>();
        Dictionary<GH_Path, int> places = null;
        public DataTree() { }
        public DataTree(IEnumerable<T> items) { AddRange(items, new GH_Path(0)); }
        public DataTree(IEnumerable<T> items, GH_Path path) { AddRange(items, path); }
        public DataTree(DataTree<T> other) { MergeTree(other); }
        public int BranchCount { get { return paths.Count; } }
        public IList<GH_Path> Paths { get { return paths; } }
        public List<List<T>> Branches { get { return branches; } }
        public int DataCount { get { int n = 0; foreach (List<T> b in branches) n += b.Count; return n; } }
        public string TopologyDescription { get { string all = ""; for (int i = 0; i < paths.Count; i++) all += paths[i] + " (N = " + branches[i].Count + ")\n"; return all; } }
        public GH_Path Path(int i) { return paths[i]; }
        public List<T> Branch(int i) { return branches[i]; }
        public List<T> Branch(GH_Path p) { int i = Find(p); return i < 0 ? null : branches[i]; }
        public List<T> Branch(params int[] p) { return Branch(new GH_Path(p)); }
        public T this[GH_Path p, int i] { get { return Branch(p)[i]; } set { Branch(p)[i] = value; } }
        public bool PathExists(GH_Path p) { return Find(p) >= 0; }
        public bool PathExists(params int[] p) { return Find(new GH_Path(p)) >= 0; }
        public bool ItemExists(GH_Path p, int i) { List<T> b = Branch(p); return b != null && i >= 0 && i < b.Count; }
        public T ItemAt(GH_Path p, int i) { return Branch(p)[i]; }
        public List<T> AllData() { List<T> all = new List<T>(); foreach (List<T> b in branches) all.AddRange(b); return all; }
        public void Add(T item) { Ensure(paths.Count == 0 ? new GH_Path(0) : paths[paths.Count - 1]).Add(item); }
        public void Add(T item, GH_Path p) { Ensure(p).Add(item); }
        public void AddRange(IEnumerable<T> items) { Ensure(paths.Count == 0 ? new GH_Path(0) : paths[paths.Count - 1]).AddRange(items); }
        public void AddRange(IEnumerable<T> items, GH_Path p) { Ensure(p).AddRange(items); }
        public void Insert(T item, GH_Path p, int i) { Ensure(p).Insert(i, item); }
        public void EnsurePath(GH_Path p) { Ensure(p); }
        public void EnsurePath(params int[] p) { Ensure(new GH_Path(p)); }
        public void RemovePath(GH_Path p) { int i = Find(p); if (i < 0) return; paths.RemoveAt(i); branches.RemoveAt(i); places = null; }
        public void Clear() { paths.Clear(); branches.Clear(); places = null; }
        public void ClearData() { foreach (List<T> b in branches) b.Clear(); }
        public void MergeTree(DataTree<T> other) { for (int i = 0; i < other.paths.Count; i++) Ensure(other.paths[i]).AddRange(other.branches[i]); }
        public void Graft() { Graft(true); }
        public void Graft(bool skipNulls)
        {
            List<GH_Path> oldPaths = paths; List<List<T>> old = branches;
            paths = new List<GH_Path>(); branches = new List<List<T>>(); places = null;
            for (int i = 0; i < old.Count; i++) for (int k = 0; k < old[i].Count; k++) Ensure(oldPaths[i].AppendElement(k)).Add(old[i][k]);
        }
        public void Flatten() { Flatten(new GH_Path(0)); }
        public void Flatten(GH_Path p) { List<T> all = AllData(); Clear(); if (all.Count > 0) AddRange(all, p); }
        public void RenumberPaths() { for (int i = 0; i < paths.Count; i++) paths[i] = new GH_Path(i); places = null; }
        public void SimplifyPaths()
        {
            if (paths.Count == 0) return;
            while (true)
            {
                foreach (GH_Path p in paths) if (p.Length < 2 || p[0] != paths[0][0]) return;
                for (int i = 0; i < paths.Count; i++) paths[i] = paths[i].CullFirstElement();
                places = null;
            }
        }
        // Paths are told apart by a table, which is made when it is first asked.
        int Find(GH_Path p)
        {
            if (places == null) { places = new Dictionary<GH_Path, int>(); for (int i = 0; i < paths.Count; i++) if (!places.ContainsKey(paths[i])) places.Add(paths[i], i); }
            int found;
            return places.TryGetValue(p, out found) ? found : -1;
        }
        List<T> Ensure(GH_Path p)
        {
            int i = Find(p);
            if (i >= 0) return branches[i];
            paths.Add(p);
            places.Add(p, paths.Count - 1);
            List<T> own = new List<T>();
            branches.Add(own);
            return own;
        }
    }
}
public class GH_ScriptInstance
{
    public Grasshopper.Kernel.IGH_Component Component = new Grasshopper.Kernel.GH_Component();
    protected int Iteration = 0;
    public Rhino.RhinoDoc RhinoDocument { get { return Rhino.RhinoDoc.__active; } }
    public void Print(string text) { Console.WriteLine(text); }
    public void Print(string format, params object[] args) { Console.WriteLine(string.Format(format, args)); }
    public void Reflect(object o) { Console.WriteLine(o == null ? "null" : o.GetType().ToString()); }
    public void AddRuntimeMessage(Grasshopper.Kernel.GH_RuntimeMessageLevel level, string text) { Component.AddRuntimeMessage(level, text); }
    public virtual void BeforeRunScript() { }
    public virtual void AfterRunScript() { }
    public virtual Rhino.Geometry.BoundingBox ClippingBox { get { return Rhino.Geometry.BoundingBox.Empty; } }
    public virtual void DrawViewportWires(Grasshopper.Kernel.IGH_PreviewArgs args) { }
    public virtual void DrawViewportMeshes(Grasshopper.Kernel.IGH_PreviewArgs args) { }
}
