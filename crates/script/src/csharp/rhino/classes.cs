// Members that the table has in another form. `//: Class` begins those of a class; `raw_X` is the table's member X,
// and no other X of that class is declared.
//: GeometryBase
  internal extern int raw_get_ObjectType();
  public Rhino.DocObjects.ObjectType ObjectType { get { return (Rhino.DocObjects.ObjectType)raw_get_ObjectType(); } }
  public override string ToString() { return "Rhino.Geometry." + GetType().Name; }
  public bool Rotate(double angle, Vector3d axis) { return Rotate(angle, axis, Point3d.Origin); }
  public void Dispose() { }
  internal extern string[] raw_GetUserStrings();
  public System.Collections.Specialized.NameValueCollection GetUserStrings()
  {
      System.Collections.Specialized.NameValueCollection made = new System.Collections.Specialized.NameValueCollection();
      string[] all = raw_GetUserStrings();
      for (int i = 0; all != null && i + 1 < all.Length; i += 2) made.Set(all[i], all[i + 1]);
      return made;
  }
//: Curve
  internal extern bool raw_TryGetPolyline(out Point3d[] points);
  public bool TryGetPolyline(out Polyline polyline) { Point3d[] points; bool found = raw_TryGetPolyline(out points); polyline = found && points != null ? new Polyline(points) : null; return found; }
  internal extern Interval raw_get_Domain();
  internal extern void raw_set_Domain(Interval domain);
  public Interval Domain { get { return raw_get_Domain(); } set { raw_set_Domain(value); } }
  public Point3d PointAtMid { get { return PointAtNormalizedLength(0.5); } }
  public Curve DuplicateCurve() { return (Curve)Duplicate(); }
  public bool Reverse() { return raw_Reverse(); }
  internal extern bool raw_Reverse();
  internal extern int raw_ClosedCurveOrientation();
  internal extern int raw_ClosedCurveOrientation(Plane plane);
  internal extern int raw_ClosedCurveOrientation(Vector3d up);
  public CurveOrientation ClosedCurveOrientation() { return (CurveOrientation)(raw_ClosedCurveOrientation()); }
  public CurveOrientation ClosedCurveOrientation(Plane plane) { return (CurveOrientation)(raw_ClosedCurveOrientation(plane)); }
  public CurveOrientation ClosedCurveOrientation(Vector3d up) { return (CurveOrientation)(raw_ClosedCurveOrientation(up)); }
//: LineCurve
  public LineCurve(Line line, double t0, double t1) : this(line) { Domain = new Interval(t0, t1); }
//: NurbsCurve
  internal extern GeometryBase raw_get_Points();
  public Rhino.Geometry.Collections.NurbsCurvePointList Points { get { return new Rhino.Geometry.Collections.NurbsCurvePointList(this); } }
  internal extern double[] raw_get_Knots();
  public Rhino.Geometry.Collections.NurbsCurveKnotList Knots { get { return new Rhino.Geometry.Collections.NurbsCurveKnotList(this); } }
//: NurbsSurface
  internal extern GeometryBase raw_get_Points();
  public Rhino.Geometry.Collections.NurbsSurfacePointList Points { get { return new Rhino.Geometry.Collections.NurbsSurfacePointList(this); } }
  internal extern double[] raw_get_KnotsU();
  internal extern double[] raw_get_KnotsV();
  public Rhino.Geometry.Collections.NurbsSurfaceKnotList KnotsU { get { return new Rhino.Geometry.Collections.NurbsSurfaceKnotList(this, 0); } }
  public Rhino.Geometry.Collections.NurbsSurfaceKnotList KnotsV { get { return new Rhino.Geometry.Collections.NurbsSurfaceKnotList(this, 1); } }
//: PointCloud
  internal extern PointCloudItem raw_get_Item(int index);
  public PointCloudItem this[int i] { get { return raw_get_Item(i); } }
  public IEnumerator<PointCloudItem> GetEnumerator() { for (int i = 0; i < Count; i++) yield return raw_get_Item(i); }
//: PointCloudItem
  public extern Point3d Location { get; }
  public extern double X { get; }
  public extern double Y { get; }
  public extern double Z { get; }
  public extern Vector3d Normal { get; }
  public extern System.Drawing.Color Color { get; }
  public extern double PointValue { get; }
  public extern bool Hidden { get; }
  public extern int Index { get; }
//: ControlPoint
  public extern Point3d Location { get; }
  public extern double Weight { get; }
  public extern double X { get; }
  public extern double Y { get; }
  public extern double Z { get; }
//: SubD
  internal extern SubDVertex[] raw_get_Vertices();
  internal extern SubDEdge[] raw_get_Edges();
  internal extern SubDFace[] raw_get_Faces();
  public Rhino.Geometry.Collections.SubDVertexList Vertices { get { return new Rhino.Geometry.Collections.SubDVertexList(this, raw_get_Vertices()); } }
  public Rhino.Geometry.Collections.SubDEdgeList Edges { get { return new Rhino.Geometry.Collections.SubDEdgeList(this, raw_get_Edges()); } }
  public Rhino.Geometry.Collections.SubDFaceList Faces { get { return new Rhino.Geometry.Collections.SubDFaceList(this, raw_get_Faces()); } }
//: PolylineCurve
  internal extern Point3d[] raw_ToPolyline();
  public Polyline ToPolyline() { return new Polyline(raw_ToPolyline()); }
  public PolylineCurve(Polyline points) : this(points.ToArray()) { }
//: Brep
  internal extern BrepFace[] raw_get_Faces();
  internal extern BrepEdge[] raw_get_Edges();
  internal extern BrepVertex[] raw_get_Vertices();
  internal extern BrepLoop[] raw_get_Loops();
  internal extern Surface[] raw_get_Surfaces();
  public Rhino.Geometry.Collections.BrepFaceList Faces { get { return new Rhino.Geometry.Collections.BrepFaceList(this, raw_get_Faces()); } }
  public Rhino.Geometry.Collections.BrepEdgeList Edges { get { return new Rhino.Geometry.Collections.BrepEdgeList(this, raw_get_Edges()); } }
  public Rhino.Geometry.Collections.BrepVertexList Vertices { get { return new Rhino.Geometry.Collections.BrepVertexList(this, raw_get_Vertices()); } }
  public Rhino.Geometry.Collections.BrepLoopList Loops { get { return new Rhino.Geometry.Collections.BrepLoopList(this, raw_get_Loops()); } }
  public Rhino.Geometry.Collections.BrepSurfaceList Surfaces { get { return new Rhino.Geometry.Collections.BrepSurfaceList(this, raw_get_Surfaces()); } }
  public Rhino.Geometry.Collections.BrepTrimList Trims { get { return new Rhino.Geometry.Collections.BrepTrimList(this, raw_get_Trims()); } }
  internal extern BrepTrim[] raw_get_Trims();
  internal extern Brep __ExtractFace(int i);
  internal extern int __FaceCount();
  internal extern bool __HasFace(int i);
  internal extern BrepFace raw_Face(int index);
  internal extern BrepEdge raw_Edge(int index);
  public BrepFace Face(int index) { return raw_Face(index); }
  public static Brep CreateFromBox(BoundingBox box) { return CreateFromBox(new Box(box)); }
//: BrepFace
  internal extern Brep raw_get_Brep();
  public Brep Brep { get { return raw_get_Brep(); } }
//: BrepEdge
  internal extern Brep raw_get_Brep();
  public Brep Brep { get { return raw_get_Brep(); } }
//: Mesh
  internal extern GeometryBase raw_get_Vertices();
  internal extern GeometryBase raw_get_Faces();
  internal extern GeometryBase raw_get_Normals();
  internal extern GeometryBase raw_get_FaceNormals();
  internal extern GeometryBase raw_get_VertexColors();
  internal extern GeometryBase raw_get_TopologyEdges();
  public Rhino.Geometry.Collections.MeshVertexList Vertices { get { return new Rhino.Geometry.Collections.MeshVertexList(this); } }
  public Rhino.Geometry.Collections.MeshFaceList Faces { get { return new Rhino.Geometry.Collections.MeshFaceList(this); } }
  public Rhino.Geometry.Collections.MeshVertexNormalList Normals { get { return new Rhino.Geometry.Collections.MeshVertexNormalList(this); } }
  public Rhino.Geometry.Collections.MeshFaceNormalList FaceNormals { get { return new Rhino.Geometry.Collections.MeshFaceNormalList(this); } }
  public Rhino.Geometry.Collections.MeshVertexColorList VertexColors { get { return new Rhino.Geometry.Collections.MeshVertexColorList(this); } }
  public Rhino.Geometry.Collections.MeshTopologyEdgeList TopologyEdges { get { return new Rhino.Geometry.Collections.MeshTopologyEdgeList(this); } }
  internal extern int raw_get_ObjectType();
  public Mesh DuplicateMesh() { return (Mesh)Duplicate(); }
//: Intersection
  internal static extern IntersectionEvent[] raw_CurveCurve(Curve a, Curve b, double tolerance, double overlapTolerance);
  internal static extern IntersectionEvent[] raw_CurveLine(Curve a, Line b, double tolerance, double overlapTolerance);
  internal static extern IntersectionEvent[] raw_CurvePlane(Curve a, Plane b, double tolerance);
  internal static extern IntersectionEvent[] raw_CurveSelf(Curve a, double tolerance);
  internal static extern IntersectionEvent[] raw_CurveSurface(Curve a, Surface b, double tolerance, double overlapTolerance);
  public static CurveIntersections CurveCurve(Curve a, Curve b, double tolerance, double overlapTolerance) { return CurveIntersections.Of(raw_CurveCurve(a, b, tolerance, overlapTolerance)); }
  public static CurveIntersections CurveLine(Curve a, Line b, double tolerance, double overlapTolerance) { return CurveIntersections.Of(raw_CurveLine(a, b, tolerance, overlapTolerance)); }
  public static CurveIntersections CurvePlane(Curve a, Plane b, double tolerance) { return CurveIntersections.Of(raw_CurvePlane(a, b, tolerance)); }
  public static CurveIntersections CurveSelf(Curve a, double tolerance) { return CurveIntersections.Of(raw_CurveSelf(a, tolerance)); }
  public static CurveIntersections CurveSurface(Curve a, Surface b, double tolerance, double overlapTolerance) { return CurveIntersections.Of(raw_CurveSurface(a, b, tolerance, overlapTolerance)); }
  internal static extern Point3d[][] raw_MeshPlane(Mesh mesh, Plane plane);
  public static Polyline[] MeshPlane(Mesh mesh, Plane plane) { return Polylines(raw_MeshPlane(mesh, plane)); }
  internal static extern Point3d[][] raw_MeshMeshAccurate(Mesh a, Mesh b, double tolerance);
  public static Polyline[] MeshMeshAccurate(Mesh a, Mesh b, double tolerance) { return Polylines(raw_MeshMeshAccurate(a, b, tolerance)); }
  static Polyline[] Polylines(Point3d[][] all)
  {
      if (all == null) return null;
      Polyline[] made = new Polyline[all.Length];
      for (int i = 0; i < all.Length; i++) made[i] = new Polyline(all[i]);
      return made;
  }
  public static bool LineLine(Line a, Line b, out double s, out double t)
  {
      Vector3d u = a.Direction, v = b.Direction, w = a.From - b.From;
      double uu = u * u, uv = u * v, vv = v * v, d = uu * vv - uv * uv;
      s = 0; t = 0;
      if (!(d > RhinoMath.SqrtEpsilon * RhinoMath.SqrtEpsilon * uu * vv)) return false;
      s = (uv * (v * w) - vv * (u * w)) / d;
      t = (uu * (v * w) - uv * (u * w)) / d;
      return true;
  }
  public static bool LineLine(Line a, Line b, out double s, out double t, double tolerance, bool finiteSegments)
  {
      if (!LineLine(a, b, out s, out t)) return false;
      if (finiteSegments) { s = RhinoMath.Clamp(s, 0.0, 1.0); t = RhinoMath.Clamp(b.ClosestParameter(a.PointAt(s)), 0.0, 1.0); s = RhinoMath.Clamp(a.ClosestParameter(b.PointAt(t)), 0.0, 1.0); }
      return !(tolerance > 0) || a.PointAt(s).DistanceTo(b.PointAt(t)) <= tolerance;
  }
  public static bool LinePlane(Line line, Plane plane, out double t)
  {
      double d = line.Direction * plane.ZAxis;
      t = d == 0 ? 0 : -plane.DistanceTo(line.From) / d;
      return d != 0;
  }
  public static bool PlanePlane(Plane a, Plane b, out Line line)
  {
      Vector3d d = Vector3d.CrossProduct(a.ZAxis, b.ZAxis);
      line = Line.Unset;
      double q = d * d;
      if (!(q > RhinoMath.ZeroTolerance * RhinoMath.ZeroTolerance)) return false;
      Vector3d u = Vector3d.CrossProduct(d, a.ZAxis);
      Point3d p = a.Origin + u * (-b.DistanceTo(a.Origin) / (u * b.ZAxis));
      d.Unitize();
      line = new Line(p, p + d);
      return true;
  }
