"""Functions of rhinoscriptsyntax, each against a closed form: what it gives, and of which kind.

Needs the program: KATYDID names it. Without it these tests say that they did not run.
"""

import math

import pytest
from hosts import Members, WorkerProcess, errors, program

pytestmark = pytest.mark.skipif(program() is None, reason="KATYDID names no program: nothing was run")

PI = math.pi

#: What the expressions speak of.
SETUP = """
import math
import rhinoscriptsyntax as rs
import Rhino.Geometry as rg
def line(): return rs.AddLine((0, 0, 0), (10, 0, 0))
def circle(r=2): return rs.AddCircle((0, 0, 0), r)
def arc(): return rs.AddArc(rs.WorldXYPlane(), 2, 90)
def square(s=2): return rs.AddPolyline([(0, 0, 0), (s, 0, 0), (s, s, 0), (0, s, 0), (0, 0, 0)])
def bent(): return rs.AddPolyline([(0, 0, 0), (4, 0, 0), (4, 3, 0)])
def box(s=2): return rs.AddBox([(0, 0, 0), (s, 0, 0), (s, s, 0), (0, s, 0), (0, 0, s), (s, 0, s), (s, s, s), (0, s, s)])
def flat(): return rs.AddPlaneSurface(rs.WorldXYPlane(), 4, 2)
def ball(r=2): return rs.AddSphere((0, 0, 0), r)
def mesh(): return rs.AddMesh([(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0)], [(0, 1, 2, 3)])
def P(p): return None if p is None else [float(x) for x in p]
def PP(ps): return [P(p) for p in ps]
def C(c): return [P(rs.CurveStartPoint(c)), P(rs.CurveEndPoint(c))]
def isid(x): return type(x).__name__ == "Guid"
"""

#: An expression (lines before it prepare it) and what it gives.
TABLE = [
    # Curves: made
    ("rs.CurveLength(rs.AddArcPtTanPt((0, 0, 0), (0, 1, 0), (2, 0, 0)))", PI),
    ("P(rs.CircleCenterPoint(rs.AddCircle3Pt((1, 0, 0), (0, 1, 0), (-1, 0, 0))))", [0, 0, 0]),
    ("rs.CurveArea(rs.AddEllipse(rs.WorldXYPlane(), 3, 2))[0]", 6 * PI),
    ("rs.CurveLength(rs.AddSubCrv(line(), 2, 5))", 3.0),
    ("C(rs.AddSpiral((0, 0, 0), (0, 0, 10), 2, 3, 1, 1))[0]", [1, 0, 0]),
    ("a = rs.AddLine((0, 0, 0), (5, 0, 0))\nb = rs.AddLine((0, 0, 0), (0, 5, 0))\n"
     "rs.CurveLength(rs.AddFilletCurve(a, b, 1))", PI / 2),
    ("isid(rs.AddBlendCurve((rs.AddLine((0, 0, 0), (1, 0, 0)), rs.AddLine((3, 1, 0), (4, 1, 0))), (1.0, 0.0), (False, True), "
     "(2, 2)))", True),
    ("c = rs.AddTweenCurves(rs.AddLine((0, 0, 0), (4, 0, 0)), rs.AddLine((0, 3, 0), (4, 3, 0)), 2)\n"
     "[len(c), sorted(P(rs.CurveStartPoint(x))[1] for x in c)]", [2, [1, 2]]),
    ("[isid(x) for x in rs.AddPoints([(0, 0, 0), (1, 0, 0)])]", [True, True]),
    ("c = rs.MeanCurve(rs.AddLine((0, 0, 0), (4, 0, 0)), rs.AddLine((0, 2, 0), (4, 2, 0)))\nC(c)", [[0, 1, 0], [4, 1, 0]]),
    ("sum(rs.CurveLength(c) for c in rs.IntersectBreps(ball(), rs.AddSphere((2, 0, 0), 2)))", 2 * PI * math.sqrt(3)),
    # Curves: asked
    ("P(rs.ArcCenterPoint(arc()))", [0, 0, 0]),
    ("rs.ArcAngle(arc())", 90.0),
    ("P(rs.ArcMidPoint(arc()))", [math.sqrt(2), math.sqrt(2), 0]),
    ("rs.ArcRadius(arc())", 2.0),
    ("rs.CircleCircumference(circle())", 4 * PI),
    ("rs.CircleRadius(circle(3))", 3.0),
    ("rs.ClosedCurveOrientation(square())", 1),
    ("P(rs.CurveArcLengthPoint(line(), 3))", [3, 0, 0]),
    ("rs.CurveArea(square(3))[0]", 9.0),
    ("[len(rs.CurveBooleanUnion([square(2), rs.AddPolyline([(1, 1, 0), (3, 1, 0), (3, 3, 0), (1, 3, 0), (1, 1, 0)])])), "
     "rs.CurveArea(rs.CurveBooleanUnion([square(2), rs.AddPolyline([(1, 1, 0), (3, 1, 0), (3, 3, 0), (1, 3, 0), (1, 1, 0)])])"
     "[0])[0]]", [1, 7.0]),
    ("rs.CurveArea(rs.CurveBooleanDifference(square(2), rs.AddPolyline([(1, 1, 0), (3, 1, 0), (3, 3, 0), (1, 3, 0), "
     "(1, 1, 0)]))[0])[0]", 3.0),
    ("rs.CurveArea(rs.CurveBooleanIntersection(square(2), rs.AddPolyline([(1, 1, 0), (3, 1, 0), (3, 3, 0), (1, 3, 0), "
     "(1, 1, 0)]))[0])[0]", 1.0),
    ("rs.CurveClosestPoint(line(), (4, 7, 0))", 4.0),
    ("k = rs.CurveCurvature(circle(4), 0.0)\n[P(k[0]), P(k[2]), k[3]]", [[4, 0, 0], [0, 0, 0], 4.0]),
    ("e = rs.CurveCurveIntersection(line(), rs.AddLine((5, -1, 0), (5, 1, 0)))\n[len(e), e[0][0], P(e[0][1]), e[0][5]]",
     [1, 1, [5, 0, 0], 5.0]),
    ("[rs.CurveDegree(line()), rs.CurveDegree(circle())]", [1, 2]),
    ("rs.CurveDirectionsMatch(line(), rs.AddLine((0, 1, 0), (10, 1, 0)))", True),
    ("PP(rs.CurveEditPoints(bent()))", [[0, 0, 0], [4, 0, 0], [4, 3, 0]]),
    ("P(rs.CurveFrame(circle(), 0.0).XAxis)", [0, 1, 0]),
    ("len(rs.CurveKnots(line()))", 2),
    ("P(rs.CurveMidPoint(line()))", [5, 0, 0]),
    ("abs(rs.CurveNormal(circle())[2])", 1.0),
    ("[rs.CurveNormalizedParameter(line(), 5.0), rs.CurveParameter(line(), 0.3)]", [0.5, 3.0]),
    ("P(rs.CurvePerpFrame(line(), 5.0).ZAxis)", [1, 0, 0]),
    ("abs(rs.CurvePlane(circle()).ZAxis.Z)", 1.0),
    ("rs.CurvePointCount(bent())", 3),
    ("PP(rs.CurvePoints(bent()))", [[0, 0, 0], [4, 0, 0], [4, 3, 0]]),
    ("rs.CurveRadius(circle(3), (3, 0, 0))", 3.0),
    ("c = circle()\n[rs.CurveSeam(c, 1.0), rs.IsCurveClosed(c)]", [True, True]),
    ("C(line())", [[0, 0, 0], [10, 0, 0]]),
    ("P(rs.CurveTangent(line(), 1.0))", [1, 0, 0]),
    ("[min(rs.CurveWeights(circle())), max(rs.CurveWeights(circle()))]", [math.sqrt(0.5), 1.0]),
    ("e = rs.CurveSurfaceIntersection(rs.AddLine((1, 1, -1), (1, 1, 1)), flat())\n[len(e), e[0][0], P(e[0][1])]",
     [1, 1, [1, 1, 0]]),
    ("r = rs.CurveBrepIntersect(rs.AddLine((1, 1, -1), (1, 1, 5)), box())\nlen(r)", 2),
    ("PP(rs.DivideCurveEquidistant(line(), 5))", [[0, 0, 0], [5, 0, 0], [10, 0, 0]]),
    ("PP(rs.DivideCurveLength(line(), 4, False, True))", [[0, 0, 0], [4, 0, 0], [8, 0, 0]]),
    ("sorted(rs.CurveLength(c) for c in rs.ExplodeCurves(bent()))", [3.0, 4.0]),
    ("rs.CurveLength(rs.ExtendCurveLength(line(), 0, 1, 5))", 15.0),
    ("[rs.IsArc(arc()), rs.IsArc(line()), rs.IsCircle(circle()), rs.IsEllipse(rs.AddEllipse(rs.WorldXYPlane(), 3, 2))]",
     [True, False, True, True]),
    ("[rs.IsCurveClosable(rs.AddArc(rs.WorldXYPlane(), 2, 359), 0.1), rs.IsCurveClosed(square()), rs.IsCurveInPlane(line(), rs.WorldXYPlane())]",
     [True, True, True]),
    ("[rs.IsCurveLinear(line()), rs.IsCurvePeriodic(line()), rs.IsCurvePlanar(circle()), rs.IsCurveRational(circle())]",
     [True, False, True, True]),
    ("[rs.IsLine(line()), rs.IsLine(bent()), rs.IsPolyline(bent()), rs.IsPolyCurve(bent())]", [True, False, True, False]),
    ("j = rs.JoinCurves([rs.AddLine((0, 0, 0), (1, 0, 0)), rs.AddLine((1, 0, 0), (1, 2, 0))])\n[len(j), rs.CurveLength(j[0])]",
     [1, 3.0]),
    ("[rs.PlanarClosedCurveContainment(circle(1), circle(2)), rs.PlanarClosedCurveContainment(circle(1), "
     "rs.AddCircle((9, 0, 0), 1))]", [2, 0]),
    ("[rs.PointInPlanarClosedCurve(p, square()) for p in ((1, 1, 0), (5, 5, 0), (2, 1, 0))]", [1, 0, 2]),
    ("c = line()\n[rs.RebuildCurve(c, 3, 6), rs.CurvePointCount(c), rs.CurveLength(c)]", [True, 6, 10.0]),
    ("c = line()\n[rs.ReverseCurve(c), P(rs.CurveStartPoint(c))]", [True, [10, 0, 0]]),
    ("rs.SimplifyCurve(bent())", True),
    ("sorted(rs.CurveLength(c) for c in rs.SplitCurve(line(), [3.0]))", [3.0, 7.0]),
    ("rs.CurveLength(rs.TrimCurve(line(), (2, 6)))", 4.0),
    ("rs.IsPolyline(rs.ConvertCurveToPolyline(arc()))", True),
    ("rs.CurveLength(rs.OffsetCurveOnSurface(rs.AddLine((0, 1, 0), (4, 1, 0)), flat(), 0.5)[0])", 4.0),
    ("c = rs.ProjectCurveToSurface([rs.AddLine((1, 1, 5), (3, 1, 5))], [flat()], (0, 0, -1))\n[len(c), rs.CurveLength(c[0])]",
     [1, 2.0]),
    ("c = rs.ProjectCurveToMesh(rs.AddLine((0.5, 1, 5), (1.5, 1, 5)), mesh(), (0, 0, -1))\nsum(rs.CurveLength(x) for x in c)",
     1.0),
    ("p = rs.PlaneCurveIntersection(rs.PlaneFromNormal((4, 0, 0), (1, 0, 0)), line())\n[len(p), P(p[0][1])]",
     [1, [4, 0, 0]]),
    # Surfaces and solids
    ("rs.SurfaceVolume(rs.AddCone(rs.WorldXYPlane(), 6, 2))[0]", 8 * PI),
    ("rs.SurfaceVolume(rs.AddCylinder(rs.WorldXYPlane(), 5, 2))[0]", 20 * PI),
    ("rs.SurfaceVolume(rs.BooleanUnion([box(), rs.MoveObject(box(), (1, 1, 1))])[0])[0]", 15.0),
    ("rs.SurfaceVolume(rs.BooleanDifference(box(), rs.MoveObject(box(), (1, 1, 1)))[0])[0]", 7.0),
    ("rs.SurfaceVolume(rs.BooleanIntersection(box(), rs.MoveObject(box(), (1, 1, 1)))[0])[0]", 1.0),
    ("rs.SurfaceArea(rs.AddTorus(rs.WorldXYPlane(), 5, 1))[0]", 20 * PI * PI),
    ("s = rs.AddEdgeSrf([rs.AddLine((0, 0, 0), (3, 0, 0)), rs.AddLine((3, 0, 0), (3, 2, 0)), rs.AddLine((3, 2, 0), (0, 2, 0)), "
     "rs.AddLine((0, 2, 0), (0, 0, 0))])\nrs.SurfaceArea(s)[0]", 6.0),
    ("rs.SurfaceArea(flat())[0]", 8.0),
    ("rs.SurfaceArea(rs.AddRevSrf(rs.AddLine((2, 0, 0), (2, 0, 5)), ((0, 0, 0), (0, 0, 1))))[0]", 20 * PI),
    ("c = rs.AddSrfContourCrvs(box(), ((0, 0, 0.5), (0, 0, 1.5)), 0.5)\n[len(c), rs.CurveLength(c[0])]", [3, 8.0]),
    ("rs.SurfaceArea(rs.AddSrfPtGrid((2, 2), [(0, 0, 0), (0, 3, 0), (2, 0, 0), (2, 3, 0)], (1, 1)))[0]", 6.0),
    ("rs.SurfaceArea(rs.AddSrfControlPtGrid((2, 2), [(0, 0, 0), (0, 3, 0), (2, 0, 0), (2, 3, 0)], (1, 1)))[0]", 6.0),
    ("s = rs.AddSweep1(rs.AddLine((0, 0, 0), (0, 0, 5)), [rs.AddLine((0, 0, 0), (2, 0, 0))])\nrs.SurfaceArea(s[0])[0]", 10.0),
    ("s = rs.AddSweep2((rs.AddLine((0, 0, 0), (0, 0, 5)), rs.AddLine((2, 0, 0), (2, 0, 5))), "
     "[rs.AddLine((0, 0, 0), (2, 0, 0))])\nrs.SurfaceArea(s[0])[0]", 10.0),
    ("P(rs.BrepClosestPoint(box(), (1, 1, 5))[0])", [1, 1, 2]),
    ("[len(rs.DuplicateEdgeCurves(box())), sum(rs.CurveLength(c) for c in rs.DuplicateEdgeCurves(box()))]", [12, 24.0]),
    ("rs.CurveLength(rs.DuplicateSurfaceBorder(flat())[0])", 12.0),
    ("f = rs.ExplodePolysurfaces(box())\n[len(f), rs.SurfaceArea(f[0])[0]]", [6, 4.0]),
    ("rs.CurveLength(rs.ExtractIsoCurve(flat(), (1, 1), 0)[0])", 4.0),
    ("rs.SurfaceArea(rs.ExtractSurface(box(), 0, True)[0])[0]", 4.0),
    ("rs.SurfaceArea(rs.ExtrudeCurvePoint(rs.AddLine((0, 0, 0), (4, 0, 0)), (2, 3, 0)))[0]", 6.0),
    ("s = flat()\n[rs.FlipSurface(s), rs.FlipSurface(s, True), rs.FlipSurface(s)]", [False, False, True]),
    ("[rs.IsBrep(box()), rs.IsPolysurface(box()), rs.IsPolysurfaceClosed(box()), rs.IsSurface(flat()), rs.IsObjectSolid(box())]",
     [True, True, True, True, True]),
    ("[rs.IsPointInSurface(box(), (1, 1, 1)), rs.IsPointInSurface(box(), (3, 1, 1)), rs.IsPointOnSurface(flat(), (1, 1, 0)), "
     "rs.IsPointOnSurface(flat(), (1, 1, 1))]", [True, False, True, False]),
    ("[rs.IsSurfaceClosed(ball(), 0), rs.IsSurfacePeriodic(flat(), 0), rs.IsSurfacePlanar(flat()), rs.IsSurfaceSphere(ball())]",
     [True, False, True, True]),
    ("[rs.IsSurfaceSingular(ball(), i) for i in range(4)]", [True, False, True, False]),
    ("rs.SurfaceArea(rs.JoinSurfaces(rs.ExplodePolysurfaces(box())))[0]", 24.0),
    ("s = rs.OffsetSurface(flat(), 1)\nrs.SurfaceArea(s)[0]", 8.0),
    ("P(rs.SurfaceAreaCentroid(flat())[0])", [2, 1, 0]),
    ("c = rs.SurfaceCurvature(ball(), (1.0, 0.2))\n[abs(c[6]), abs(c[7])]", [0.25, 0.5]),
    ("rs.SurfaceDegree(flat())", [1, 1]),
    ("P(rs.SurfaceFrame(flat(), (1, 1)).ZAxis)", [0, 0, 1]),
    ("list(rs.SurfaceNormalizedParameter(flat(), (1, 1)))", [0.25, 0.5]),
    ("list(rs.SurfacePointCount(flat()))", [2, 2]),
    ("sorted(PP(rs.SurfacePoints(flat())))", [[0, 0, 0], [0, 2, 0], [4, 0, 0], [4, 2, 0]]),
    ("rs.SurfaceSphere(ball())[1]", 2.0),
    ("rs.SurfaceArea(rs.TrimSurface(flat(), 0, (0, 1), False))[0]", 2.0),
    ("rs.SurfaceArea(rs.AddNetworkSrf([rs.AddLine((0, 0, 0), (3, 0, 0)), rs.AddLine((0, 2, 0), (3, 2, 0)), "
     "rs.AddLine((0, 0, 0), (0, 2, 0)), rs.AddLine((3, 0, 0), (3, 2, 0))]))[0]", 6.0),
    # A patch of a flat curve lies in its plane.
    ("s = rs.AddPatch([circle()], (5, 5))\n[abs(p.Z) < 1e-6 for p in rs.BoundingBox(s)]", [True] * 8),
    # Meshes
    ("[rs.IsMesh(mesh()), rs.IsMeshClosed(mesh()), rs.MeshVertexCount(mesh())]", [True, False, 4]),
    ("PP(rs.MeshFaceCenters(mesh()))", [[1, 1, 0]]),
    ("[list(f) for f in rs.MeshFaceVertices(mesh())]", [[0, 1, 2, 3]]),
    ("len(rs.MeshFaces(mesh()))", 4),
    ("PP(rs.MeshVertices(mesh()))", [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]),
    ("PP(rs.MeshVertexNormals(mesh()))", [[0, 0, 1]] * 4),
    ("P(rs.MeshClosestPoint(mesh(), (1, 1, 5))[0])", [1, 1, 0]),
    ("rs.MeshVertexCount(rs.JoinMeshes([mesh(), mesh()]))", 8),
    ("rs.CurveLength(rs.DuplicateMeshBorder(mesh())[0])", 8.0),
    ("m = rs.AddMesh([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1, 1), (0, 1, 3, 3), (0, 3, 2, 2), (1, 2, 3, 3)])\n"
     "[rs.IsMeshClosed(m), rs.MeshVolume(m)[1]]", [True, 1 / 6.0]),
    # Seen from above the square of 2 has the outline of 8.
    ("rs.CurveLength(rs.MeshOutline(mesh())[0])", 8.0),
    # Objects
    ("o = line()\nrs.ObjectColor(o, (1, 2, 3))\n[rs.ObjectColor(o).R, rs.ObjectColor(o).G, rs.ObjectColor(o).B]", [1, 2, 3]),
    ("[rs.IsPlane(rs.WorldXYPlane()), rs.IsPlane(3)]", [True, False]),
    ("a = [line(), line()]\nrs.DeleteObjects(a)", 2),
    ("[rs.IsPoint(rs.AddPoint(0, 0, 0)), rs.IsPoint(line())]", [True, False]),
    ("[rs.ObjectType(rs.AddPoint(0, 0, 0)), rs.ObjectType(line()), rs.ObjectType(flat()), rs.ObjectType(box()), "
     "rs.ObjectType(mesh())]", [1, 4, 8, 16, 32]),
    ("P(rs.CurveStartPoint(rs.MirrorObject(rs.AddLine((1, 0, 0), (2, 0, 0)), (0, 0, 0), (0, 1, 0))))", [-1, 0, 0]),
    ("len(rs.MirrorObjects([line(), line()], (0, 0, 0), (0, 1, 0)))", 2),
    ("o = rs.OrientObject(rs.AddLine((0, 0, 0), (1, 0, 0)), [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(5, 5, 0), (5, 6, 0), "
     "(4, 5, 0)])\nC(o)", [[5, 5, 0], [5, 6, 0]]),
    ("[rs.CurveLength(x) for x in rs.ScaleObjects([line(), line()], (0, 0, 0), (2, 2, 2))]", [20.0, 20.0]),
    ("P(rs.CurveEndPoint(rs.TransformObject(line(), rs.XformTranslation((0, 0, 4)))))", [10, 0, 4]),
    ("len(rs.TransformObjects([line(), line()], rs.XformTranslation((0, 0, 4)), True))", 2),
    ("o = line()\n[rs.ObjectName(o, 'edge'), rs.ObjectName(o)]", [None, "edge"]),
    ("o = line()\nrs.SetUserText(o, 'k', 'v')\nrs.GetUserText(o, 'k')", "v"),
    ("P(rs.PointClosestObject((1, 1, 0), [line(), rs.AddPoint(9, 9, 9)])[1])", [1, 0, 0]),
    ("o = line()\nrs.ObjectName(o, 'unique')\n[len(rs.ObjectsByName('unique')), o in rs.ObjectsByLayer('Default'), "
     "o in rs.ObjectsByType(4), o in rs.ObjectsByType(1)]", [1, True, True, False]),
    ("[rs.Sleep(1), rs.Print('seen')]", [None, None]),
    # Points and vectors
    ("[rs.Angle((0, 0, 0), (1, 1, 0))[0], rs.Angle2(((0, 0, 0), (1, 0, 0)), ((0, 0, 0), (0, 1, 0)))[0]]", [45.0, 90.0]),
    ("[rs.ArePointsInLine if False else rs.PointsAreCoplanar([(0, 0, 0), (1, 0, 0), (0, 1, 0), (5, 5, 0)])]", [True]),
    ("[P(rs.CreatePoint(1, 2, 3)), P(rs.CreateVector(1, 2, 3)), P(rs.CreatePlane((1, 2, 3)).Origin)]",
     [[1, 2, 3], [1, 2, 3], [1, 2, 3]]),
    ("[rs.CreateInterval(3).T1, rs.CreateXform(rs.XformIdentity()).M00]", [3.0, 1.0]),
    ("rs.CullDuplicateNumbers([1.0, 3.0, 1.0, 2.0])", [1.0, 2.0, 3.0]),
    ("[rs.IsVectorParallelTo((1, 0, 0), (2, 0, 0)), rs.IsVectorParallelTo((1, 0, 0), (-2, 0, 0)), "
     "rs.IsVectorParallelTo((1, 0, 0), (0, 1, 0))]", [1, -1, 0]),
    ("[rs.IsVectorPerpendicularTo((1, 0, 0), (0, 3, 0)), rs.IsVectorTiny((1e-13, 0, 0)), rs.IsVectorZero((0, 0, 0))]",
     [True, True, True]),
    ("l = ((0, 0, 0), (10, 0, 0))\n[rs.LineIsFartherThan(l, 1, (5, 3, 0)), rs.LineMaxDistanceTo(l, (0, 3, 0)), "
     "rs.LineMinDistanceTo(l, (5, 3, 0))]", [True, math.sqrt(109), 3.0]),
    ("P(rs.LineTransform(((0, 0, 0), (1, 0, 0)), rs.XformTranslation((0, 2, 0))).To)", [1, 2, 0]),
    ("abs(rs.LinePlane(((0, 0, 0), (10, 0, 0))).XAxis.X)", 1.0),
    ("[P(rs.PointAdd((1, 2, 3), (1, 1, 1))), P(rs.PointSubtract((1, 2, 3), (1, 1, 1))), P(rs.PointScale((1, 2, 3), 2)), "
     "P(rs.PointDivide((2, 4, 6), 2)), rs.PointCompare((1, 0, 0), (1, 0, 0))]",
     [[2, 3, 4], [0, 1, 2], [2, 4, 6], [1, 2, 3], True]),
    ("b = rs.PointArrayBoundingBox([(0, 5, 0), (2, 1, 3)])\n[P(b[0]), P(b[6])]", [[0, 1, 0], [2, 5, 3]]),
    ("PP(rs.PointArrayTransform([(0, 0, 0), (1, 0, 0)], rs.XformTranslation((0, 0, 1))))", [[0, 0, 1], [1, 0, 1]]),
    ("p = rs.SortPointList([(3, 0, 0), (1, 0, 0), (2, 0, 0)])\n[p[0].DistanceTo(p[1]), p[1].DistanceTo(p[2])]", [1.0, 1.0]),
    ("rs.SimplifyArray([(1, 2, 3), (4, 5, 6)])", [1, 2, 3, 4, 5, 6]),
    ("[rs.ToDegrees(math.pi), rs.ToRadians(180)]", [180.0, PI]),
    ("[rs.VectorCompare((1, 0, 0), (0, 1, 0)), rs.VectorMultiply((1, 2, 0), (3, 1, 0)), "
     "P(rs.VectorTransform((1, 0, 0), rs.XformRotation2(90, (0, 0, 1), (0, 0, 0))))]", [1, 5.0, [0, 1, 0]]),
    ("list(rs.frange(0.0, 1.0, 0.25))", [0.0, 0.25, 0.5, 0.75, 1.0]),
    # Planes and transforms
    ("list(rs.PlaneEquation(rs.MovePlane(rs.WorldXYPlane(), (0, 0, 3))))", [0, 0, 1, -3]),
    ("abs(rs.PlaneFitFromPoints([(0, 0, 1), (1, 0, 1), (0, 1, 1), (1, 1, 1)]).ZAxis.Z)", 1.0),
    ("P(rs.PlaneFromFrame((0, 0, 0), (0, 1, 0), (0, 0, 1)).ZAxis)", [1, 0, 0]),
    ("P(rs.PlaneFromNormal((1, 2, 3), (0, 1, 0)).ZAxis)", [0, 1, 0]),
    ("P(rs.PlaneIntersection(rs.WorldXYPlane(), rs.WorldYZPlane(), rs.WorldZXPlane()))", [0, 0, 0]),
    ("l = rs.PlanePlaneIntersection(rs.WorldXYPlane(), rs.WorldZXPlane())\nabs((l[1] - l[0]).X) > 0 and (l[0].Y, l[0].Z) == (0, 0)",
     True),
    ("P(rs.PlaneTransform(rs.WorldXYPlane(), rs.XformTranslation((1, 2, 3))).Origin)", [1, 2, 3]),
    ("P(rs.WorldYZPlane().ZAxis) + P(rs.WorldZXPlane().ZAxis) + P(rs.ViewCPlane().ZAxis)", [1, 0, 0, 0, 1, 0, 0, 0, 1]),
    ("def t(x, p=(1, 0, 0)):\n    q = rg.Point3d(*p)\n    q.Transform(x)\n    return P(q)\n"
     "[t(rs.XformTranslation((0, 0, 5))), t(rs.XformMirror((0, 0, 0), (1, 0, 0))), t(rs.XformScale(3)), "
     "t(rs.XformRotation2(90, (0, 0, 1), (0, 0, 0))), t(rs.XformPlanarProjection(rs.WorldXYPlane()), (1, 2, 3)), "
     "t(rs.XformRotation3((1, 0, 0), (0, 1, 0), (0, 0, 0)))]",
     [[1, 0, 5], [-1, 0, 0], [3, 0, 0], [0, 1, 0], [1, 2, 0], [0, 1, 0]]),
    ("q = rg.Point3d(1, 0, 0)\nq.Transform(rs.XformRotation1(rs.WorldXYPlane(), rs.WorldYZPlane()))\nP(q)", [0, 1, 0]),
    ("q = rg.Point3d(1, 0, 0)\nq.Transform(rs.XformChangeBasis(rs.MovePlane(rs.WorldXYPlane(), (1, 0, 0)), rs.WorldXYPlane()))\n"
     "P(q)", [2, 0, 0]),
    ("[rs.IsXformIdentity(rs.XformIdentity()), rs.XformCompare(rs.XformIdentity(), rs.XformIdentity()), rs.XformZero().M33, "
     "rs.IsXformSimilarity(rs.XformScale(2)) != 0]", [True, 0, 0.0, True]),
    # Coercion
    ("[P(rs.coerce2dpoint((1, 2))), [P(p) for p in rs.coerce2dpointlist([(1, 2), (3, 4)])]]", [[1, 2], [[1, 2], [3, 4]]]),
    ("PP(rs.coerce3dpointlist([(1, 2, 3), rg.Point3d(4, 5, 6)]))", [[1, 2, 3], [4, 5, 6]]),
    ("[P(rs.coerce3dvector((1, 2, 3))), P(rs.coerceplane([(1, 2, 3)]).Origin if False else rs.coerceplane(rs.WorldXYPlane()).Origin)]",
     [[1, 2, 3], [0, 0, 0]]),
    ("[rs.coercecolor((1, 2, 3)).G, len(rs.coerceguidlist([line(), line()])), rs.coercemesh(mesh()).Vertices.Count, "
     "rs.coercexform(rs.XformIdentity()).M00]", [2, 2, 4, 1.0]),
    ("rs.coercerhinoobject(line()).Geometry.GetLength()", 10.0),
    ("P(rs.coerceboundingbox([(0, 0, 0), (10, 0, 0)]).Max)", [10, 0, 0]),
    # The document
    ("[rs.ContextIsGrasshopper(), rs.ContextIsRhino(), rs.UnitAbsoluteTolerance(), rs.UnitSystem(), rs.UnitSystemName()]",
     [True, False, 0.001, 2, "millimeter"]),
    ("[rs.UnitScale(2, 4), rs.IsLayer('Default'), rs.CurrentLayer(), rs.LayerCount(), rs.LayerNames()]",
     [1000.0, True, "Default", 1, ["Default"]]),
    ("b = rs.BoundingBox(box())\n[len(b), P(b[0]), P(b[6])]", [8, [0, 0, 0], [2, 2, 2]]),
    ("o = line()\n[rs.ObjectLayer(o), isid(rs.FirstObject()), isid(rs.LastObject()), len(rs.AllObjects()) > 0]",
     ["Default", True, True, True]),
    # Nothing is shown, so nothing is hidden, locked or picked.
    ("[rs.HideObject(line()), rs.HideObjects([line()]), rs.ShowObject(line()), rs.ShowObjects([line()]), rs.LockObject(line()), "
     "rs.UnlockObject(line()), rs.SelectObject(line()), rs.SelectObjects([line()]), rs.UnselectObject(line()), "
     "rs.UnselectAllObjects(), rs.Redraw(), rs.EnableRedraw(True) in (True, None)]",
     [False, 0, False, 0, False, False, False, 0, False, 0, None, True]),
    # A parabola: half way along it is the mean of the middle point and the middle of the ends.
    ("[list(p) for p in [rs.CurveMidPoint(rs.AddNurbsCurve([(0, 0, 0), (1, 2, 0), (2, 0, 0)], [0, 0, 1, 1], 2))]]", [[1.0, 1.0, 0.0]]),
    ("rs.CurveLength(rs.AddNurbsCurve([(1, 0, 0), (1, 1, 0), (0, 1, 0)], [0, 0, 1, 1], 2, [1, 0.5 ** 0.5, 1]))", math.pi / 2),
    ("[list(p) for p in rs.PointCloudPoints(rs.AddPointCloud([(0, 0, 0), (1, 2, 3)]))]", [[0.0, 0.0, 0.0], [1.0, 2.0, 3.0]]),
    ("rs.coercegeometry(rs.AddTextDot('t', (1, 0, 0))).Text", "t"),
    ("[rs.DocumentName(), rs.DocumentPath(), rs.UnitAngleTolerance() > 0, rs.UnitRelativeTolerance()]",
     [None, None, True, 0.01]),
]

#: What asks a user, whom a script in a definition has not.
ASKING = ["GetBoolean('m', [('a', 'b', 'c')], [True])", "GetObject()", "GetObjects()", "GetPoint()", "GetPoints()", "GetReal()",
          "GetInteger()", "GetString()", "GetColor()", "GetBox()", "GetLine()", "GetRectangle()", "GetCurveObject()",
          "GetSurfaceObject()", "ListBox(['a'])", "OpenFileName()", "SaveFileName()", "BrowseForFolder()"]


#: What the host has not yet, with the member that is named.
MISSING = [
    ("rs.ExtrudeCurveTapered(circle(), 2, (0, 0, 1), (0, 0, 0), 5)", "CreateFromTaperedExtrude"),
]


@pytest.fixture(scope="module")
def worker():
    members = Members(program())
    made = WorkerProcess(members)
    yield made
    made.close()
    members.close()


def same(got, wanted):
    """Whether a value is what is wanted: numbers within a millionth, the rest alike."""
    if isinstance(wanted, (list, tuple)):
        return isinstance(got, (list, tuple)) and len(got) == len(wanted) and all(map(same, got, wanted))
    if isinstance(wanted, float) or isinstance(got, float):
        return isinstance(got, (int, float)) and abs(got - wanted) <= 1e-6 * max(1.0, abs(wanted))
    return type(got) is type(wanted) and got == wanted


def row_id(value):
    return str(value).split("\n")[-1][:60] if isinstance(value, str) else ""


@pytest.mark.parametrize("expression, wanted", TABLE, ids=row_id)
def test_a_function_gives_what_its_formula_says(worker, expression, wanted):
    lines = expression.split("\n")
    # As text, since a list of lists is one object to a component.
    code = SETUP + "\n".join(lines[:-1] + ["a = repr(plain(" + lines[-1] + "))"])
    code = code.replace("def isid", "def plain(v):\n    if isinstance(v, (list, tuple)): return [plain(x) for x in v]\n"
                        "    return int(v) if hasattr(v, 'value__') else v\ndef isid")
    values, result = worker.run(code, key=expression)
    assert not errors(result), errors(result)[0]
    got = eval(values["a"], {"__builtins__": {}})
    assert same(got, wanted), "%r, not %r" % (got, wanted)


@pytest.mark.parametrize("expression, member", MISSING, ids=row_id)
def test_what_the_host_has_not_is_named(worker, expression, member):
    _, result = worker.run(SETUP + "a = " + expression, key=expression)
    assert member in errors(result)[0] and "not supported" in errors(result)[0], errors(result)


@pytest.mark.parametrize("call", ASKING)
def test_what_asks_a_user_says_that_there_is_none(worker, call):
    _, result = worker.run("import rhinoscriptsyntax as rs\na = rs." + call, key=call)
    assert errors(result) and call.partition("(")[0] in errors(result)[0], result


def test_what_shows_a_message_says_it(worker):
    _, result = worker.run("import rhinoscriptsyntax as rs\nrs.MessageBox('m')\nrs.Prompt('p')", key="box")
    assert not errors(result) and ["remark", "m", -1] in result["messages"]


#: What scripts in real definitions call.
USED = """
AddArc AddArc3Pt AddCircle AddCurve AddInterpCurve AddLine AddLoftSrf AddPipe AddPlanarSrf AddPoint
AddPointCloud AddPolyline AddRectangle AddSphere Area CapPlanarHoles CopyObject CopyObjects CreateColor
CurveAreaCentroid CurveDomain CurveLength Distance DivideCurve EnableRedraw EvaluateCurve EvaluatePlane
EvaluateSurface ExtrudeCurve ExtrudeCurveStraight ExtrudeSurface IsCurve LineLineIntersection MeshToNurb
MoveObject MoveObjects MovePlane ObjectsByLayer OffsetCurve PointCoordinates RebuildSurface RotateObject
RotateObjects RotatePlane SplitBrep SurfaceClosestPoint SurfaceDomain SurfaceNormal SurfaceParameter TrimBrep
VectorAdd VectorCrossProduct VectorDivide VectorLength VectorRotate VectorSubtract VectorUnitize WorldXYPlane
coerce3dpoint coercebrep coercecurve coercegeometry coerceline coercesurface
""".split()


def called():
    """The functions that the tests name."""
    import os
    import re
    here = os.path.dirname(os.path.abspath(__file__))
    tests = "".join(open(os.path.join(here, name), encoding="utf-8").read() for name in sorted(os.listdir(here))
                    if name.startswith("test_"))
    return set(re.findall(r"(?:\\n|\b)rs\.(\w+)", tests)) | {call.partition("(")[0] for call in ASKING}


def test_what_real_scripts_call_is_here_and_in_a_test():
    from katydid import rhino
    rhino.install()
    try:
        import rhinoscriptsyntax
        assert not [name for name in USED if not callable(getattr(rhinoscriptsyntax, name, None))]
    finally:
        rhino.uninstall()
    assert not set(USED) - called()


def test_every_function_is_named_in_a_test():
    """None is here that no test calls."""
    import ast
    import os
    here = os.path.dirname(os.path.abspath(__file__))
    folder = os.path.join(os.path.dirname(here), "katydid", "modules", "rhinoscriptsyntax")
    tested, untested = called(), set()
    for name in sorted(os.listdir(folder)):
        if not name.endswith(".py") or name == "support.py":
            continue
        with open(os.path.join(folder, name), encoding="utf-8") as source:
            for node in ast.parse(source.read()).body:
                if isinstance(node, ast.FunctionDef) and node.name[0].isupper() and node.name.strip("_") not in tested:
                    untested.add(node.name)
    assert not untested, " ".join(sorted(untested))


