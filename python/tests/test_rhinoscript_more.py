"""The functions of rhinoscriptsyntax that real definitions call less often, each against a closed form."""

import math

import pytest
from hosts import Members, WorkerProcess, errors, program
from test_rhinoscript_table import SETUP, row_id, same

pytestmark = pytest.mark.skipif(program() is None, reason="KATYDID names no program: nothing was run")

PI = math.pi

MORE = SETUP + """
def corner(): return rs.AddMesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0)], [(0, 1, 2, 3), (1, 4, 2, 2)])
def cube(s=2, at=0.0):
    p = [(x + at, y + at, z + at) for z in (0, s) for x, y in ((0, 0), (s, 0), (s, s), (0, s))]
    return rs.AddMesh(p, [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])
def oval(): return rs.AddEllipse(rs.WorldXYPlane(), 3, 2)
def drum(): return rs.ExplodePolysurfaces(rs.AddCylinder(rs.WorldXYPlane(), 3, 2, False)) or rs.AddCylinder(rs.WorldXYPlane(), 3, 2, False)
def one(x): return x[0] if isinstance(x, list) else x
def geo(x): return rs.coercegeometry(x)
"""

#: An expression (lines before it prepare it) and what it gives.
TABLE = [
    # Groups
    ("[rs.AddGroup('a'), rs.AddGroup('a'), rs.AddGroup(), rs.GroupCount(), rs.GroupNames(), rs.IsGroup('a'), rs.IsGroup('b')]",
     ["a", None, "Group02", 2, ["a", "Group02"], True, False]),
    ("o = [line(), line()]\nrs.AddGroup('a')\nb = rs.AddGroup('b')\n"
     "[rs.AddObjectsToGroup(o, 'a'), rs.AddObjectToGroup(o[0], 'b'), rs.AddObjectToGroup(o[0], 'b'), rs.ObjectsByGroup('a') == o, "
     "rs.ObjectGroups(o[0]), rs.ObjectTopGroup(o[0]), rs.IsObjectInGroup(o[1]), rs.IsObjectInGroup(o[1], 'b'), "
     "rs.IsGroupEmpty('b')]", [2, True, False, True, ["a", "b"], "b", True, False, False]),
    ("o = [line(), line(), line()]\nrs.AddGroup('a')\nrs.AddGroup('b')\nrs.AddObjectsToGroup(o, 'a')\nrs.AddObjectsToGroup(o, 'b')\n"
     "[rs.RemoveObjectFromGroup(o[0], 'a'), rs.RemoveObjectsFromGroup(o, 'a'), rs.RemoveObjectFromTopGroup(o[0]), "
     "rs.RemoveObjectFromAllGroups(o[1]), rs.ObjectGroups(o[1]), rs.ObjectGroups(o[2]), rs.RenameGroup('b', 'c'), "
     "rs.DeleteGroup('a'), rs.DeleteGroup('a'), rs.GroupNames()]",
     [True, 2, True, True, [], ["b"], "c", True, False, ["c"]]),
    # Hatches: the area inside a circle without a circle within
    ("h = rs.AddHatch(circle(2), 'Hatch2', 1.5, 30)\n[rs.IsHatch(h), rs.IsHatch(line()), rs.HatchPattern(h), rs.HatchScale(h), "
     "rs.HatchRotation(h), rs.Area(h)]", [True, False, "Hatch2", 1.5, 30.0, 4 * PI]),
    ("h = rs.AddHatches([circle(3), circle(1)])\n[len(h), rs.Area(h[0]), len(geo(h[0]).Get3dCurves(False)), "
     "geo(h[0]).ToBrep().GetArea()]", [1, 8 * PI, 1, 8 * PI]),
    ("h = rs.AddHatch(square())\n[rs.HatchPattern(h, 'Grid'), rs.HatchPattern(h), rs.HatchRotation(h, 90), rs.HatchRotation(h), "
     "rs.HatchScale(h, 3), rs.HatchScale(h), geo(h).PatternIndex]", ["Solid", "Grid", 0.0, 90.0, 1.0, 3.0, 5]),
    ("[rs.HatchPatternCount() == len(rs.HatchPatternNames()), rs.IsHatchPattern('solid'), rs.IsHatchPattern('x'), "
     "rs.CurrentHatchPattern(), rs.AddHatch(line())]", [True, True, False, "Solid", None]),
    ("h = rs.AddHatch(square(2))\nrs.MoveObject(h, (5, 0, 1))\nb = rs.BoundingBox(geo(h).ToBrep())\n[P(b[0]), P(b[6])]",
     [[5, 0, 1], [7, 2, 1]]),
    # Texts by key
    ("o = line()\n[rs.SetUserText(o, 'k', 'v'), rs.GetUserText(o, 'k'), rs.GetUserText(o), rs.IsUserText(o), rs.SetUserText(o, 'k'), "
     "rs.GetUserText(o, 'k'), rs.IsUserText(o)]", [True, "v", ["k"], 1, True, None, 0]),
    ("o = line()\n[rs.SetUserText(o, 'k', 5, True), rs.GetUserText(o, 'k', True), rs.GetUserText(o, 'k'), rs.IsUserText(o), "
     "geo(o).GetUserString('k')]", [True, "5", None, 2, "5"]),
    ("[rs.SetDocumentUserText('a', 1), rs.GetDocumentUserText('a'), rs.GetDocumentUserText(), rs.DocumentUserTextCount(), "
     "rs.IsDocumentUserText(), rs.SetDocumentUserText('a'), rs.GetDocumentUserText('a')]",
     [True, "1", ["a"], 1, True, True, None]),
    ("[rs.SetDocumentData('s', 'e', 1), rs.SetDocumentData('s', 'e', 2), rs.GetDocumentData('s', 'e'), rs.GetDocumentData('s'), "
     "rs.GetDocumentData(), rs.DocumentDataCount(), rs.IsDocumentData(), rs.DeleteDocumentData('s'), rs.IsDocumentData()]",
     [None, "1", "2", ["e"], ["s"], 1, True, True, False]),
    # Meshes
    ("m = corner()\n[rs.MeshQuadCount(m), rs.MeshTriangleCount(m), rs.DisjointMeshCount(m), rs.IsMeshManifold(m)]",
     [1, 1, 1, True]),
    ("[[abs(v) for v in P(n)] for n in rs.MeshFaceNormals(mesh())]", [[0, 0, 1]]),
    ("[rs.MeshHasFaceNormals(mesh()), rs.MeshHasVertexNormals(mesh()), rs.MeshHasVertexColors(mesh())]", [True, True, False]),
    ("m = mesh()\nb = rs.MeshVertexColors(m, [(255, 0, 0)] * 4)\n[b, rs.MeshVertexColors(m)[3].R, rs.MeshHasVertexColors(m)]",
     [None, 255, True]),
    ("[rs.MeshVertexFaces(corner(), 1), rs.MeshVertexFaces(corner(), 4)]", [[0, 1], [1]]),
    ("[len(rs.MeshNakedEdgePoints(corner())), len(rs.MeshNakedEdgePoints(cube()))]", [5, 0]),
    # The square's centroid is (0.5, 0.5), the triangle's (4/3, 1/3); their areas are 1 and 1/2.
    ("P(rs.MeshAreaCentroid(corner()))", [(0.5 + 2 / 3.0) / 1.5, (0.5 + 1 / 6.0) / 1.5, 0.0]),
    ("P(rs.MeshVolumeCentroid(cube()))", [1.0, 1.0, 1.0]),
    ("[rs.IsPointOnMesh(mesh(), (1, 1, 0)), rs.IsPointOnMesh(mesh(), (1, 1, 1))]", [True, False]),
    ("m = rs.JoinMeshes([cube(), cube(1, 5.0)])\np = rs.SplitDisjointMesh(m)\n[rs.DisjointMeshCount(m), sorted(rs.MeshVolume(x)[1] for x in p)]",
     [2, [1.0, 8.0]]),
    ("m = mesh()\n[rs.MeshQuadsToTriangles(m), rs.MeshTriangleCount(m), rs.MeshQuadCount(m)]", [True, 2, 0]),
    ("m = rs.AddMesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2, 2), (0, 3, 2, 2)])\nrs.UnifyMeshNormals(m)", 1),
    ("b = rs.BoundingBox(rs.MeshOffset(mesh(), 3))\nabs(b[0][2])", 3.0),
    ("rs.MeshArea(rs.AddPlanarMesh(square(3)))[1]", 9.0),
    # Two cubes of side 2 that share one of side 1
    ("sum(rs.MeshVolume(m)[1] for m in rs.MeshBooleanUnion([cube(), cube(2, 1.0)]))", 15.0),
    ("sum(rs.MeshVolume(m)[1] for m in rs.MeshBooleanDifference(cube(), cube(2, 1.0)))", 7.0),
    ("sum(rs.MeshVolume(m)[1] for m in rs.MeshBooleanIntersection(cube(), cube(2, 1.0)))", 1.0),
    # Six edges of the small cube's faces inside the other cube
    ("sum(rs.CurveLength(rs.AddPolyline(p)) for p in rs.MeshMeshIntersection(cube(), cube(2, 1.0)))", 6.0),
    ("PP(rs.CurveMeshIntersection(rs.AddLine((1, 1, -1), (1, 1, 1)), mesh()))", [[1, 1, 0]]),
    ("[f for p, f in rs.CurveMeshIntersection(rs.AddLine((1.6, 0.2, -1), (1.6, 0.2, 1)), corner(), True)]", [1]),
    # Curves
    ("e = rs.AddEllipse3Pt((1, 0, 0), (4, 0, 0), (1, 2, 0))\n[rs.CurveArea(e)[0], P(rs.EllipseCenterPoint(e))]",
     [6 * PI, [1, 0, 0]]),
    ("sorted(abs(v) for p in PP(rs.EllipseQuadPoints(oval())) for v in p if abs(v) > 1e-9)", [2, 2, 3, 3]),
    ("[rs.CurveDim(line()), rs.CurveKnotCount(line()), rs.CurveKnotCount(circle())]", [3, 2, 10]),
    ("PP(rs.CurveDiscontinuity(bent(), 2))", [[4, 0, 0]]),
    ("PP(rs.CurveContourPoints(line(), (0, 0, 0), (10, 0, 0), 5))", [[0, 0, 0], [5, 0, 0], [10, 0, 0]]),
    ("a = rs.AddLine((0, 3, 0), (9, 3, 0))\nb = rs.AddLine((0, 9, 0), (9, 9, 0))\nf = rs.CurveClosestObject(line(), [b, a])\n"
     "[f[0] == a, P(f[1])[1], P(f[2])[1]]", [True, 3, 0]),
    ("c = circle()\n[rs.ChangeCurveDegree(c, 4), rs.CurveDegree(c), rs.CurveLength(c)]", [True, 4, 4 * PI]),
    ("rs.IsCurveClosed(rs.CloseCurve(rs.AddPolyline([(0, 0, 0), (3, 0, 0), (3, 3, 0), (0, 0.0001, 0)]), 0.01))", True),
    ("c = line()\nr = rs.ExtendCurve(c, 0, 1, rs.AddLine((15, -1, 0), (15, 1, 0)))\n[r == c, rs.CurveLength(c)]", [True, 15.0]),
    ("c = line()\nr = rs.ExtendCurvePoint(c, 1, (12, 0, 0), 0)\n[r == c, rs.CurveLength(c), P(rs.CurveEndPoint(c))]",
     [True, 12.0, [12, 0, 0]]),
    ("abs(rs.CurveLength(rs.FitCurve(circle(), 3, 1e-6)) - 4 * math.pi) < 1e-4", True),
    ("c = bent()\n[rs.SmoothCurve(c, fix=True), P(rs.CurveStartPoint(c)), rs.CurveLength(c) < 7.0]", [True, [0, 0, 0], True]),
    ("f = rs.CurveFilletPoints(rs.AddLine((0, 0, 0), (5, 0, 0)), rs.AddLine((0, 0, 0), (0, 5, 0)), 1)\n"
     "[sorted([P(f[0]), P(f[1])]), P(f[2])]", [[[0, 1, 0], [1, 0, 0]], [1, 1, 0]]),
    ("c = rs.PullCurve(flat(), rs.AddLine((1, 1, 5), (3, 1, 7)))\n[len(c), C(c[0])]", [1, [[1, 1, 0], [3, 1, 0]]]),
    ("PP(rs.ProjectPointToSurface((1, 1, 5), flat(), (0, 0, -1)))", [[1, 1, 0]]),
    ("PP(rs.ProjectPointToMesh([(1, 1, 5), (9, 9, 5)], mesh(), (0, 0, -1)))", [[1, 1, 0]]),
    # Surfaces
    ("t = rs.AddTorus(rs.WorldXYPlane(), 5, 1)\n[rs.IsSphere(ball()), rs.IsSphere(t), rs.IsTorus(t), rs.IsPlaneSurface(flat())]",
     [True, False, True, True]),
    ("d = one(drum())\n[rs.IsCylinder(d), rs.IsCone(d), rs.SurfaceCylinder(d)[1:]]", [True, False, [3.0, 2.0]]),
    ("c = one(rs.AddCone(rs.WorldXYPlane(), 3, 2, False))\n[rs.IsCone(c), abs(rs.SurfaceCone(c)[1]), rs.SurfaceCone(c)[2]]",
     [True, 3.0, 2.0]),
    ("rs.SurfaceTorus(rs.AddTorus(rs.WorldXYPlane(), 5, 1))[1:]", [5.0, 1.0]),
    ("[rs.SurfaceTorus(flat()), rs.SurfaceCone(flat()), rs.SurfaceCylinder(flat())]", [None, None, None]),
    ("[rs.IsSurfaceRational(ball()), rs.IsSurfaceRational(flat()), rs.IsSurfaceTrimmed(rs.AddPlanarSrf(circle())[0]), "
     "rs.IsSurfaceTrimmed(flat())]", [True, False, True, False]),
    ("[rs.SurfaceKnots(flat()), rs.SurfaceKnotCount(flat()), rs.SurfaceWeights(flat())]",
     [[[0.0, 4.0], [0.0, 2.0]], [2, 2], [1.0, 1.0, 1.0, 1.0]]),
    ("[sorted(PP(rs.SurfaceEditPoints(flat()))), rs.SurfaceEditPoints(flat(), True)[3]]",
     [[[0, 0, 0], [0, 2, 0], [4, 0, 0], [4, 2, 0]], [4.0, 2.0]]),
    ("PP(rs.SurfaceEvaluate(flat(), (1, 1), 1))", [[1, 1, 0], [1, 0, 0], [0, 1, 0]]),
    ("s = flat()\n[rs.ChangeSurfaceDegree(s, (3, 2)), rs.SurfaceDegree(s), rs.SurfaceArea(s)[0]]", [True, [3, 2], 8.0]),
    ("s = flat()\n[rs.ExtendSurface(s, (4, 1), 2), rs.SurfaceArea(s)[0]]", [True, 12.0]),
    ("s = flat()\n[rs.ReverseSurface(s, 1), P(rs.SurfaceNormal(s, (-1, 1)))]", [True, [0, 0, -1]]),
    ("rs.CurveLength(rs.ShortPath(flat(), (0, 0, 0), (4, 0, 0)))", 4.0),
    # A cylinder unrolled: half way round and up.
    ("abs(rs.CurveLength(rs.ShortPath(one(drum()), (2, 0, 0), (0, 2, 3))) - math.hypot(math.pi, 3)) < 1e-3", True),
    ("PP(rs.ShootRay([flat()], (0, 1, 2), (1, 0, -1), 1))", [[0, 1, 2], [2, 1, 0]]),
    ("rs.SurfaceArea(rs.AddCutPlane([box()], (0, 1, 0), (2, 1, 0)))[0]", 4.0),
    ("sum(rs.CurveLength(c) for c in rs.AddSrfSectionCrvs(ball(), rs.WorldXYPlane()))", 4 * PI),
    # Transforms
    ("[rs.IsXformZero(rs.XformZero()), rs.IsXformZero(rs.XformIdentity())]", [True, False]),
    ("q = rg.Point3d(1, 2, 3)\nq.Transform(rs.XformRotation4((1, 0, 0), (0, 1, 0), (0, 0, 1), (0, 1, 0), (-1, 0, 0), (0, 0, 1)))\nP(q)",
     [-2, 1, 3]),
    ("q = rg.Point3d(1, 2, 3)\nq.Transform(rs.XformChangeBasis2((2, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, 0), (0, 1, 0), (0, 0, 1)))\nP(q)",
     [2, 2, 3]),
    ("q = rg.Point3d(0, 1, 0)\nq.Transform(rs.XformShear(rs.WorldXYPlane(), (1, 0, 0), (1, 1, 0), (0, 0, 1)))\nP(q)", [1, 1, 0]),
    ("[P(rs.XformWorldToCPlane((3, 2, 1), rs.MovePlane(rs.WorldXYPlane(), (1, 1, 1)))), "
     "P(rs.XformCPlaneToWorld((2, 1, 0), rs.MovePlane(rs.WorldXYPlane(), (1, 1, 1))))]", [[2, 1, 0], [3, 2, 1]]),
    ("r = rs.PlaneSphereIntersection(rs.WorldXYPlane(), rs.MovePlane(rs.WorldXYPlane(), (0, 0, 3)), 5)\n[r[0], r[2]]", [1, 4.0]),
    ("[rs.PlaneSphereIntersection(rs.WorldXYPlane(), rs.MovePlane(rs.WorldXYPlane(), (0, 0, 9)), 5), "
     "rs.PlaneSphereIntersection(rs.WorldXYPlane(), rs.MovePlane(rs.WorldXYPlane(), (0, 0, 5)), 5)[0]]", [None, 0]),
    ("sorted(PP(rs.LineSphereIntersection(((-9, 0, 0), (9, 0, 0)), (0, 0, 0), 2)))", [[-2, 0, 0], [2, 0, 0]]),
    ("[sorted(PP(rs.LineCylinderIntersection(((-9, 0, 1), (9, 0, 1)), rs.WorldXYPlane(), 3, 2))), "
     "rs.LineCylinderIntersection(((-9, 0, 5), (9, 0, 5)), rs.WorldXYPlane(), 3, 2)]", [[[-2, 0, 1], [2, 0, 1]], []]),
    # Colours
    ("[rs.ColorRedValue((1, 2, 3)), rs.ColorGreenValue((1, 2, 3)), rs.ColorBlueValue((1, 2, 3))]", [1, 2, 3]),
    ("[list(rs.ColorRGBToHLS((255, 0, 0))), list(rs.ColorRGBToHLS((0, 0, 255)))]", [[0.0, 120.0, 240.0], [160.0, 120.0, 240.0]]),
    ("c = rs.ColorHLSToRGB((80, 120, 240))\n[c.R, c.G, c.B]", [0, 255, 0]),
    # Objects
    ("c = square(2)\nrs.ShearObject(c, (0, 0, 0), (1, 0, 0), 45)\nsorted([round(x, 9) for x in p] for p in PP(rs.PolylineVertices(c))[:4])",
     [[0, 0, 0], [2, 0, 0], [2, 2, 0], [4, 2, 0]]),
    ("[isid(x) for x in rs.ShearObjects([line()], (0, 0, 0), (1, 0, 0), 45, True)]", [True]),
    ("[rs.ObjectDescription(x) for x in (line(), circle(), box(), ball(), mesh(), rs.AddPoint(0, 0, 0))]",
     ["open curve", "closed curve", "closed polysurface", "surface", "mesh", "point"]),
    ("o = line()\n[rs.IsObjectValid(o), rs.IsObjectInBox(o, [(-1, -1, -1), (11, 1, 1)]), rs.IsObjectInBox(o, [(-1, -1, -1), (5, 1, 1)]), "
     "rs.IsObjectInBox(o, [(-1, -1, -1), (5, 1, 1)], False)]", [True, True, False, True]),
    ("o = line()\n[rs.IsObjectNormal(o), rs.IsObjectHidden(o), rs.IsObjectLocked(o), rs.IsObjectReference(o), rs.IsObjectSelectable(o), "
     "rs.IsObjectSelected(o)]", [True, False, False, False, True, False]),
    ("a, b = line(), line()\nrs.ObjectName(a, 'x')\nrs.ObjectColor(a, (1, 2, 3))\n[rs.ObjectNames(), rs.MatchObjectAttributes([b], a), rs.ObjectName(b), "
     "rs.ObjectsByColor((1, 2, 3)) == [a, b], rs.NextObject(b) == a, rs.NextObject(a)]", [["x"], 1, "x", True, True, None]),
    ("line()\n[len(rs.NormalObjects()), rs.HiddenObjects(), rs.LockedObjects(), rs.SelectedObjects(), rs.InvertSelectedObjects(), "
     "rs.UnselectObjects([]), rs.LockObjects([]), rs.UnlockObjects([]), rs.FlashObject([])]", [1, [], [], [], [], 0, 0, 0, None]),
    ("d = rs.AddTextDot('a', (1, 2, 3))\n[rs.IsTextDot(d), rs.IsTextDot(line()), rs.TextDotText(d, 'b'), rs.TextDotText(d), "
     "P(rs.TextDotPoint(d, (4, 5, 6))), P(rs.TextDotPoint(d)), rs.TextDotHeight(d) > 0, type(rs.TextDotFont(d)).__name__]",
     [True, False, "a", "b", [1, 2, 3], [4, 5, 6], True, "str"]),
    ("c = rs.AddPointCloud([(0, 0, 0), (1, 2, 3)])\n[rs.PointCloudCount(c), rs.PointCloudHasPointColors(c), "
     "rs.PointCloudPointColors(c, [(1, 2, 3), (4, 5, 6)]), rs.PointCloudHasPointColors(c), rs.PointCloudPointColors(c)[1].G]",
     [2, False, None, True, 5]),
]


@pytest.fixture(scope="module")
def worker():
    members = Members(program())
    made = WorkerProcess(members)
    yield made
    made.close()
    members.close()


@pytest.mark.parametrize("expression, wanted", TABLE, ids=row_id)
def test_a_function_gives_what_its_formula_says(worker, expression, wanted):
    lines = expression.split("\n")
    plain = ("def plain(v):\n    if isinstance(v, (list, tuple)): return [plain(x) for x in v]\n"
             "    return int(v) if hasattr(v, 'value__') else v\n")
    code = MORE + plain + "\n".join(lines[:-1] + ["a = repr(plain(" + lines[-1] + "))"])
    values, result = worker.run(code, key=expression)
    assert not errors(result), errors(result)[0]
    got = eval(values["a"], {"__builtins__": {}})
    assert same(got, wanted), "%r, not %r" % (got, wanted)
