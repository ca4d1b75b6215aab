namespace Rhino.DocObjects { }
namespace System.Collections.Specialized
{
    // Texts by key, in the order in which they were set.
    public class NameValueCollection : IEnumerable
    {
        List<string> keys = new List<string>();
        List<string> texts = new List<string>();
        public int Count { get { return keys.Count; } }
        public string[] AllKeys { get { return keys.ToArray(); } }
        public string this[string key] { get { return Get(key); } set { Set(key, value); } }
        public string this[int i] { get { return texts[i]; } }
        public string GetKey(int i) { return keys[i]; }
        public string Get(int i) { return texts[i]; }
        public string Get(string key) { int i = keys.IndexOf(key); return i < 0 ? null : texts[i]; }
        public void Set(string key, string text) { int i = keys.IndexOf(key); if (i < 0) { keys.Add(key); texts.Add(text); } else texts[i] = text; }
        public IEnumerator GetEnumerator() { for (int i = 0; i < keys.Count; i++) yield return keys[i]; }
    }
}
namespace Rhino.Geometry.Intersect
{
    public class CurveIntersections : IEnumerable<IntersectionEvent>
    {
        IntersectionEvent[] all;
        internal static CurveIntersections Of(IntersectionEvent[] all) { if (all == null) return null; CurveIntersections made = new CurveIntersections(); made.all = all; return made; }
        public int Count { get { return all.Length; } }
        public IntersectionEvent this[int i] { get { return all[i]; } }
        public IEnumerator<IntersectionEvent> GetEnumerator() { for (int i = 0; i < all.Length; i++) yield return all[i]; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
}
namespace Rhino.Geometry
{
    using Rhino.Geometry.Collections;
    [Native] public class SurfaceCurvature
    {
        public extern Point2d UVPoint { get; }
        public extern Point3d Point { get; }
        public extern Vector3d Normal { get; }
        public extern double Gaussian { get; }
        public extern double Mean { get; }
        internal extern double raw_get_Kappa1();
        internal extern double raw_get_Kappa2();
        internal extern Vector3d raw_get_Direction1();
        internal extern Vector3d raw_get_Direction2();
        public double Kappa(int i) { return i == 0 ? raw_get_Kappa1() : raw_get_Kappa2(); }
        public Vector3d Direction(int i) { return i == 0 ? raw_get_Direction1() : raw_get_Direction2(); }
    }
    [Native] public class BrepVertex
    {
        public extern int VertexIndex { get; }
        public extern Point3d Location { get; }
        internal extern int[] raw_get_EdgeIndices();
        public int[] EdgeIndices() { return raw_get_EdgeIndices(); }
    }
    [Native] public class BrepLoop
    {
        public extern int LoopIndex { get; }
        public extern BrepFace Face { get; }
        internal extern Curve raw_get_To3dCurve();
        public Curve To3dCurve() { return raw_get_To3dCurve(); }
    }
    [Native] public class BrepTrim
    {
        public extern Brep Brep { get; }
        public extern int TrimIndex { get; }
        public extern BrepEdge Edge { get; }
        public extern BrepFace Face { get; }
        public extern BrepLoop Loop { get; }
        public extern Interval Domain { get; }
        public extern Point3d PointAtStart { get; }
        public extern Point3d PointAtEnd { get; }
    }
    public class MeshingParameters
    {
        public double RelativeTolerance = 0.0; public double Tolerance = 0.0; public double MinimumEdgeLength = 0.0001; public double MaximumEdgeLength = 0.0;
        public double GridAspectRatio = 6.0; public double GridAngle = 0.0; public double GridAmplification = 1.0; public int GridMinCount = 0; public int GridMaxCount = 0;
        public double RefineAngle = 0.0; public bool JaggedSeams = false; public bool RefineGrid = true; public bool SimplePlanes = false;
        public static MeshingParameters Default { get { return new MeshingParameters(); } }
        public static MeshingParameters FastRenderMesh { get { MeshingParameters m = new MeshingParameters(); m.GridAspectRatio = 0; m.RelativeTolerance = 0.65; m.GridMinCount = 16; m.SimplePlanes = true; m.GridAmplification = 1; m.MinimumEdgeLength = 0.0001; return m; } }
        public static MeshingParameters QualityRenderMesh { get { MeshingParameters m = FastRenderMesh; m.RelativeTolerance = 0.8; m.RefineAngle = 20 * Math.PI / 180; return m; } }
        public static MeshingParameters Coarse { get { return FastRenderMesh; } }
        public static MeshingParameters Smooth { get { return QualityRenderMesh; } }
        public static MeshingParameters Minimal { get { MeshingParameters m = new MeshingParameters(); m.JaggedSeams = true; m.RefineGrid = false; m.SimplePlanes = true; m.GridAspectRatio = 0; return m; } }
    }
}
namespace Rhino.Geometry.Collections
{
    public class BrepFaceList : IEnumerable<BrepFace>
    {
        Brep brep; BrepFace[] all;
        internal BrepFaceList(Brep brep, BrepFace[] all) { this.brep = brep; this.all = all; }
        public int Count { get { return brep.__FaceCount(); } }
        public BrepFace this[int i] { get { return all[i]; } }
        // The numbers of the other faces stay, as in openNURBS, until the Brep is made compact.
        public Brep ExtractFace(int i) { return brep.__ExtractFace(i); }
        public IEnumerator<BrepFace> GetEnumerator() { for (int i = 0; i < all.Length; i++) yield return all[i]; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class BrepEdgeList : IEnumerable<BrepEdge>
    {
        BrepEdge[] all;
        internal BrepEdgeList(Brep brep, BrepEdge[] all) { this.all = all; }
        public int Count { get { return all.Length; } }
        public BrepEdge this[int i] { get { return all[i]; } }
        public IEnumerator<BrepEdge> GetEnumerator() { for (int i = 0; i < all.Length; i++) yield return all[i]; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class BrepVertexList : IEnumerable<BrepVertex>
    {
        BrepVertex[] all;
        internal BrepVertexList(Brep brep, BrepVertex[] all) { this.all = all; }
        public int Count { get { return all.Length; } }
        public BrepVertex this[int i] { get { return all[i]; } }
        public IEnumerator<BrepVertex> GetEnumerator() { for (int i = 0; i < all.Length; i++) yield return all[i]; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class BrepLoopList : IEnumerable<BrepLoop>
    {
        BrepLoop[] all;
        internal BrepLoopList(Brep brep, BrepLoop[] all) { this.all = all; }
        public int Count { get { return all.Length; } }
        public BrepLoop this[int i] { get { return all[i]; } }
        public IEnumerator<BrepLoop> GetEnumerator() { for (int i = 0; i < all.Length; i++) yield return all[i]; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class BrepSurfaceList : IEnumerable<Surface>
    {
        Surface[] all;
        internal BrepSurfaceList(Brep brep, Surface[] all) { this.all = all; }
        public int Count { get { return all.Length; } }
        public Surface this[int i] { get { return all[i]; } }
        public IEnumerator<Surface> GetEnumerator() { for (int i = 0; i < all.Length; i++) yield return all[i]; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
    public class BrepTrimList : IEnumerable<BrepTrim>
    {
        BrepTrim[] all;
        internal BrepTrimList(Brep brep, BrepTrim[] all) { this.all = all; }
        public int Count { get { return all.Length; } }
        public BrepTrim this[int i] { get { return all[i]; } }
        public IEnumerator<BrepTrim> GetEnumerator() { for (int i = 0; i < all.Length; i++) yield return all[i]; }
        IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
    }
}
// What stands below goes into the lists that the table fills.
//: MeshVertexList : IEnumerable<Point3f>
  Mesh owner;
  internal MeshVertexList(Mesh owner) { this.owner = owner; }
  internal extern Point3d raw_get_Item(int index);
  internal extern void raw_set_Item(int index, Point3d vertex);
  internal extern Point3d[] raw_ToArray();
  public Point3f this[int i] { get { return (Point3f)raw_get_Item(i); } set { raw_set_Item(i, value); } }
  public Point3f[] ToPoint3fArray() { Point3d[] all = raw_ToArray(); Point3f[] made = new Point3f[all.Length]; for (int i = 0; i < all.Length; i++) made[i] = (Point3f)all[i]; return made; }
  public int Add(Point3f vertex) { return Add((double)vertex.X, (double)vertex.Y, (double)vertex.Z); }
  public void AddVertices(IEnumerable<Point3f> vertices) { List<Point3d> all = new List<Point3d>(); foreach (Point3f p in vertices) all.Add(p); AddVertices(all); }
  public IEnumerator<Point3f> GetEnumerator() { Point3f[] all = ToPoint3fArray(); for (int i = 0; i < all.Length; i++) yield return all[i]; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
//: MeshFaceList : IEnumerable<MeshFace>
  Mesh owner;
  internal MeshFaceList(Mesh owner) { this.owner = owner; }
  internal extern MeshFace raw_get_Item(int index);
  internal extern bool raw_set_Item(int index, MeshFace face);
  internal extern MeshFace[] raw_ToArray();
  internal extern MeshFace raw_GetFace(int index);
  public MeshFace GetFace(int index) { return raw_GetFace(index); }
  public MeshFace this[int i] { get { return raw_get_Item(i); } set { raw_set_Item(i, value); } }
  public IEnumerator<MeshFace> GetEnumerator() { MeshFace[] all = raw_ToArray(); for (int i = 0; all != null && i < all.Length; i++) yield return all[i]; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
//: MeshVertexNormalList : IEnumerable<Vector3f>
  Mesh owner;
  internal MeshVertexNormalList(Mesh owner) { this.owner = owner; }
  internal extern Vector3d raw_get_Item(int index);
  internal extern Vector3d[] raw_ToArray();
  public Vector3f this[int i] { get { return (Vector3f)raw_get_Item(i); } }
  public IEnumerator<Vector3f> GetEnumerator() { foreach (Vector3d v in raw_ToArray()) yield return (Vector3f)v; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
//: MeshFaceNormalList : IEnumerable<Vector3f>
  Mesh owner;
  internal MeshFaceNormalList(Mesh owner) { this.owner = owner; }
  internal extern Vector3d raw_get_Item(int index);
  internal extern Vector3d[] raw_ToArray();
  public Vector3f this[int i] { get { return (Vector3f)raw_get_Item(i); } }
  public IEnumerator<Vector3f> GetEnumerator() { foreach (Vector3d v in raw_ToArray()) yield return (Vector3f)v; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
//: MeshVertexColorList : IEnumerable<System.Drawing.Color>
  Mesh owner;
  internal MeshVertexColorList(Mesh owner) { this.owner = owner; }
  internal extern System.Drawing.Color raw_get_Item(int index);
  internal extern System.Drawing.Color[] raw_ToArray();
  internal extern bool raw_SetColors(IEnumerable<System.Drawing.Color> colors);
  public bool SetColors(System.Drawing.Color[] colors) { return raw_SetColors(colors); }
  public int Add(System.Drawing.Color color) { List<System.Drawing.Color> all = new List<System.Drawing.Color>(raw_ToArray()); all.Add(color); Pending(all); return all.Count - 1; }
  public int Add(int red, int green, int blue) { return Add(System.Drawing.Color.FromArgb(red, green, blue)); }
  void Pending(List<System.Drawing.Color> all) { raw_SetColors(all); }
  public System.Drawing.Color this[int i] { get { return raw_get_Item(i); } set { System.Drawing.Color[] all = raw_ToArray(); all[i] = value; raw_SetColors(all); } }
  public IEnumerator<System.Drawing.Color> GetEnumerator() { foreach (System.Drawing.Color c in raw_ToArray()) yield return c; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
//: MeshTopologyEdgeList
  Mesh owner;
  internal MeshTopologyEdgeList(Mesh owner) { this.owner = owner; }
//: NurbsCurvePointList
  NurbsCurve owner;
  internal NurbsCurvePointList(NurbsCurve owner) { this.owner = owner; }
//: NurbsSurfacePointList : IEnumerable<ControlPoint>
  NurbsSurface owner;
  internal NurbsSurfacePointList(NurbsSurface owner) { this.owner = owner; }
  internal extern ControlPoint[] raw_ToArray();
  public bool SetControlPoint(int u, int v, ControlPoint cp) { return SetPoint(u, v, cp.Location, cp.Weight); }
  public IEnumerator<ControlPoint> GetEnumerator() { foreach (ControlPoint point in raw_ToArray()) yield return point; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
//: NurbsSurfaceKnotList : IEnumerable<double>
  NurbsSurface owner; int direction;
  internal NurbsSurfaceKnotList(NurbsSurface owner, int direction) { this.owner = owner; this.direction = direction; }
  internal extern double raw_get_Item(int direction, int index);
  internal extern void raw_set_Item(int direction, int index, double value);
  internal extern double[] raw_ToArray(int direction);
  internal extern bool raw_CreateUniformKnots(int direction, double knotSpacing);
  internal extern bool raw_CreatePeriodicKnots(int direction, double knotSpacing);
  public int Count { get { return raw_ToArray(direction).Length; } }
  public double this[int i] { get { return raw_get_Item(direction, i); } set { raw_set_Item(direction, i, value); } }
  public bool CreateUniformKnots(double knotSpacing) { return raw_CreateUniformKnots(direction, knotSpacing); }
  public bool CreatePeriodicKnots(double knotSpacing) { return raw_CreatePeriodicKnots(direction, knotSpacing); }
  public IEnumerator<double> GetEnumerator() { foreach (double knot in raw_ToArray(direction)) yield return knot; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
//: SubDVertexList : IEnumerable<SubDVertex>
  SubD owner; SubDVertex[] all;
  internal SubDVertexList(SubD owner, SubDVertex[] all) { this.owner = owner; this.all = all; }
  public int Count { get { return all.Length; } }
  public IEnumerator<SubDVertex> GetEnumerator() { for (int i = 0; i < all.Length; i++) yield return all[i]; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
//: SubDEdgeList : IEnumerable<SubDEdge>
  SubD owner; SubDEdge[] all;
  internal SubDEdgeList(SubD owner, SubDEdge[] all) { this.owner = owner; this.all = all; }
  public int Count { get { return all.Length; } }
  public IEnumerator<SubDEdge> GetEnumerator() { for (int i = 0; i < all.Length; i++) yield return all[i]; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
//: SubDFaceList : IEnumerable<SubDFace>
  SubD owner; SubDFace[] all;
  internal SubDFaceList(SubD owner, SubDFace[] all) { this.owner = owner; this.all = all; }
  public int Count { get { return all.Length; } }
  public IEnumerator<SubDFace> GetEnumerator() { for (int i = 0; i < all.Length; i++) yield return all[i]; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
//: NurbsCurveKnotList : IEnumerable<double>
  NurbsCurve owner;
  internal NurbsCurveKnotList(NurbsCurve owner) { this.owner = owner; }
  internal extern double raw_get_Item(int index);
  internal extern void raw_set_Item(int index, double value);
  internal extern double[] raw_ToArray();
  public double this[int i] { get { return raw_get_Item(i); } set { raw_set_Item(i, value); } }
  public IEnumerator<double> GetEnumerator() { foreach (double knot in raw_ToArray()) yield return knot; }
  IEnumerator IEnumerable.GetEnumerator() { return GetEnumerator(); }
