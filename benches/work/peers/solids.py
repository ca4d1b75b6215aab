"""Solids, and curves and surfaces: Open CASCADE, through cadquery-ocp."""

import math

import numpy as np
from OCP import collections
from OCP.BRep import BRep_Tool
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeEdge,
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakePolygon,
    BRepBuilderAPI_MakeWire,
)
from OCP.BRepGProp import BRepGProp
from OCP.BRepLib import BRepLib
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.BRepOffsetAPI import BRepOffsetAPI_MakePipe, BRepOffsetAPI_ThruSections
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder, BRepPrimAPI_MakePrism, BRepPrimAPI_MakeSphere
from OCP.BRepProj import BRepProj_Projection
from OCP.Geom import Geom_BSplineCurve, Geom_BSplineSurface
from OCP.Geom2d import Geom2d_BSplineCurve
from OCP.Geom2dAPI import Geom2dAPI_InterCurveCurve
from OCP.gp import gp_Ax2, gp_Circ, gp_Dir, gp_Pnt, gp_Pnt2d, gp_Vec
from OCP.GProp import GProp_GProps
from OCP.HLRAlgo import HLRAlgo_Projector
from OCP.HLRBRep import HLRBRep_Algo, HLRBRep_HLRToShape
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_VERTEX
from OCP.TopExp import TopExp, TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS

from .points import grid
from .work import Peer, closed

Shapes = collections.IndexedMap_TopoDS_Shape_TopTools_ShapeMapHasher

# Sides of a round pipe in a mesh: as many as Katydid's settings give, so that both make the same faces.
SIDES = 24


def measured(measure, shape):
    """Its length, area or volume, and centroid."""
    properties = GProp_GProps()
    measure(shape, properties)
    return properties.Mass(), properties.CentreOfMass()


def length(shape):
    return measured(BRepGProp.LinearProperties_s, shape)[0]


def area(shape):
    return measured(BRepGProp.SurfaceProperties_s, shape)[0]


def volume(shape):
    return measured(BRepGProp.VolumeProperties_s, shape)[0]


def parts(shape, kind):
    """The different faces, edges or vertices."""
    found = Shapes()
    TopExp.MapShapes_s(shape, kind, found)
    return found


def every(shape, kind):
    """The faces, edges or vertices, as often as they are met."""
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def array(kind, values):
    """Values in an array as Open CASCADE has them, which counts from 1."""
    made = kind(1, len(values))
    for i, value in enumerate(values):
        made.SetValue(i + 1, value)
    return made


def clamped(count):
    """Knots and multiplicities of a clamped uniform cubic."""
    inner = count - 3
    knots = array(collections.Array1_double, [float(i) for i in range(inner + 1)])
    return knots, array(collections.Array1_int, [4, *[1] * (inner - 1), 4])


def wire(edge):
    return BRepBuilderAPI_MakeWire(edge).Wire()


def circle(centre, normal, radius):
    return wire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(centre, normal), radius)).Edge())


def points(n, step):
    return [gp_Pnt(*point) for point in grid(n, step).tolist()]


UP, ALONG_Y = gp_Dir(0, 0, 1), gp_Dir(0, 1, 0)


def octagon_prisms(n):
    angles = [k * math.pi / 4 for k in range(8)]

    def given():
        return [[gp_Pnt(x + math.cos(a), y + math.sin(a), 0) for a in angles] for x, y, _ in grid(n, 3).tolist()]

    def work(polygons):
        solids = []
        for corners in polygons:
            polygon = BRepBuilderAPI_MakePolygon()
            for corner in corners:
                polygon.Add(corner)
            polygon.Close()
            face = BRepBuilderAPI_MakeFace(polygon.Wire(), True).Face()
            solids.append(BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, 2)).Shape())
        return solids

    def answer(solids):
        return {
            "volume": [volume(one) for one in solids],
            "faces": [parts(one, TopAbs_FACE).Extent() for one in solids],
        }

    return Peer(given, work, answer)


def heights(n):
    return [1 + 0.01 * i for i in range(n)]


def box(z):
    return BRepPrimAPI_MakeBox(1.0, 2.0, z).Shape()


def boxes_to_breps(n):
    def work(zs):
        return [[parts(one, kind) for kind in (TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX)] for one in map(box, zs)]

    def answer(result):
        counts = [[found.Extent() for found in one] for one in result]
        faces, edges, vertices = (list(column) for column in zip(*counts))
        # Each box has four edges of each of its sides, whose order is each kernel's own.
        lengths = sorted(length(found.FindKey(i + 1)) for _, found, _ in result for i in range(found.Extent()))
        return {"faces": faces, "edges": edges, "vertices": vertices, "length": lengths}

    return Peer(lambda: heights(n), work, answer)


def areas_and_volumes(n):
    def work(zs):
        result = []
        for z in zs:
            one = box(z)
            result.append((measured(BRepGProp.SurfaceProperties_s, one), measured(BRepGProp.VolumeProperties_s, one)))
        return result

    def answer(result):
        return {
            "area": [surface[0] for surface, _ in result],
            "volume": [solid[0] for _, solid in result],
            "height": [solid[1].Z() for _, solid in result],
        }

    return Peer(lambda: heights(n), work, answer)


def mesh_area(shape):
    """The area of the triangles that a shape was meshed to."""
    total = 0.0
    for face in every(shape, TopAbs_FACE):
        mesh = BRep_Tool.Triangulation_s(TopoDS.Face(face), TopLoc_Location())
        nodes = np.array([mesh.Node(i + 1).Coord() for i in range(mesh.NbNodes())])
        corners = nodes[np.array([mesh.Triangle(i + 1).Get() for i in range(mesh.NbTriangles())]) - 1]
        total += (
            np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2
        )
    return total


def meshed(pipes):
    """Pipes that are made beforehand, and meshed."""

    def work(shapes):
        for shape in shapes:
            BRepMesh_IncrementalMesh(shape, 0.1, False, 2 * math.pi / SIDES)
        return shapes

    return Peer(pipes, work, lambda shapes: {"area": [mesh_area(shape) for shape in shapes], "meshes": [len(shapes)]})


def straight_pipes(n):
    return meshed(lambda: [BRepPrimAPI_MakeCylinder(gp_Ax2(at, UP), 0.5, 10).Shape() for at in points(n, 3)])


def arc(at):
    """An arc of radius 10 and 1.5 radians in an xz plane."""
    return wire(BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(at, gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)), 10), 0.0, 1.5).Edge())


def pipe(spine, start, direction, radius):
    profile = BRepBuilderAPI_MakeFace(circle(start, direction, radius)).Face()
    return BRepOffsetAPI_MakePipe(spine, profile).Shape()


def arc_pipe(at, radius):
    return pipe(arc(at), gp_Pnt(at.X() + 10, at.Y(), at.Z()), UP, radius)


def curved_pipes(n):
    return meshed(lambda: [arc_pipe(at, 0.5) for at in points(n, 30)])


def capped_pipes(n):
    along = gp_Vec(0, math.sqrt(50), math.sqrt(50))

    def straight(at):
        spine = wire(BRepBuilderAPI_MakeEdge(at, at.Translated(along)).Edge())
        return pipe(spine, at, gp_Dir(along), 0.2)

    def work(given):
        arcs, lines = given
        return [arc_pipe(at, 0.2) for at in arcs] + [straight(at) for at in lines]

    return Peer(lambda: (points(n, 30), points(n, 3)), work, lambda solids: {"volume": [volume(one) for one in solids]})


def cap_holes(n):
    knots = array(collections.Array1_double, [float(i) for i in range(41)])
    once = array(collections.Array1_int, [1] * 41)
    k = np.arange(40)
    radius, angle = 1.5 + np.sin(k * k) * 0.4, k * math.pi / 20

    def given():
        x, y = np.cos(angle) * radius, np.sin(angle) * radius
        return [
            array(collections.Array1_gp_Pnt, [gp_Pnt(a + u, b + v, 0) for u, v in zip(x.tolist(), y.tolist())])
            for a, b, _ in grid(n, 5).tolist()
        ]

    def work(polygons):
        solids = []
        for poles in polygons:
            edge = BRepBuilderAPI_MakeEdge(Geom_BSplineCurve(poles, knots, once, 3, True)).Edge()
            face = BRepBuilderAPI_MakeFace(wire(edge), True).Face()
            solids.append(BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, 2)).Shape())
        return solids

    return Peer(given, work, lambda solids: {"volume": [2 * enclosed(poles, knots, once) for poles in given()]})


def enclosed(poles, knots, times):
    """The area within a closed cubic in a horizontal plane: Green's theorem, whose integrals four places a span give
    without an error. Open CASCADE's own area of the face is off by hundredths."""
    curve, total = Geom_BSplineCurve(poles, knots, times, 3, True), 0.0
    places, weights = np.polynomial.legendre.leggauss(4)
    point, tangent = gp_Pnt(), gp_Vec()
    for span in range(len(poles)):
        for place, weight in zip(span + (places + 1) / 2, weights / 2):
            curve.D1(place, point, tangent)
            total += weight * (point.X() * tangent.Y() - point.Y() * tangent.X()) / 2
    return total


def make2d(n):
    def given():
        places = [gp_Pnt(i * 1.5, i % 3, i % 5 * 0.7) for i in range(n)]
        return [BRepPrimAPI_MakeSphere(gp_Ax2(at, UP), 1).Shape() for at in places]

    def work(spheres):
        hidden = HLRBRep_Algo()
        for sphere in spheres:
            hidden.Add(sphere, 0)
        hidden.Projector(HLRAlgo_Projector(gp_Ax2(gp_Pnt(0, 0, 20), UP)))
        hidden.Update()
        hidden.Hide()
        return HLRBRep_HLRToShape(hidden).OutLineVCompound()

    def answer(drawn):
        BRepLib.BuildCurves3d_s(drawn)
        return {"visible": [length(drawn)]}

    return Peer(given, work, answer)


def project_curves(n):
    def given():
        poles = collections.Array2_gp_Pnt(1, 20, 1, 20)
        for i in range(400):
            poles.SetValue(i // 20 + 1, i % 20 + 1, gp_Pnt(i // 20, i % 20, math.sin(i) * 2))
        knots, times = clamped(20)
        surface = Geom_BSplineSurface(poles, knots, knots, times, times, 3, 3)
        face = BRepBuilderAPI_MakeFace(surface, 1e-6).Face()
        places = [gp_Pnt(1 + i % 30 * 0.5, 1 + i // 30 % 30 * 0.5, -20) for i in range(n)]
        return face, [circle(at, UP, 0.8) for at in places]

    def work(given):
        face, circles = given
        result = []
        for one in circles:
            projection = BRepProj_Projection(one, face, UP)
            found = []
            while projection.More():
                found.append(projection.Current())
                projection.Next()
            result.append(found)
        return result

    def answer(result):
        found = [one for wires in result for one in wires]
        return {"count": [len(found)], "length": [length(one) for one in found]}

    return Peer(given, work, answer)


def variable_pipes(n):
    """Radii go over into each other as 3t² − 2t³: its square has the mean 13/35 over a span."""
    spans = sum(a * a + a * (b - a) + (b - a) ** 2 * 13 / 35 for a, b in ((4, 6), (6, 3)))
    whole = 50 * math.pi * spans
    return closed({"volume": [whole] * n, "meshed": [whole] * n})


def lofts(n):
    def work(places):
        shells = []
        for x, y, _ in places:
            sections = BRepOffsetAPI_ThruSections(False, False)
            for k, radius in enumerate((1, 2, 3, 4)):
                sections.AddWire(circle(gp_Pnt(x, y, 2 * k), UP, radius))
            shells.append(sections.Shape())
        return shells

    return Peer(lambda: grid(n, 10).tolist(), work, lambda shells: {"area": [area(one) for one in shells]})


def curve_with_curve(n):
    def given():
        knots, times = clamped(20)

        def wave(i, phase):
            poles = [gp_Pnt2d(k, math.sin(k * 1.3 + phase) * 3 + 10 * i) for k in range(20)]
            return Geom2d_BSplineCurve(array(collections.Array1_gp_Pnt2d, poles), knots, times, 3)

        return [(wave(i, 0), wave(i, 1.9)) for i in range(n)]

    def work(pairs):
        result = []
        for a, b in pairs:
            found = Geom2dAPI_InterCurveCurve(a, b, 1e-9)
            result.append([found.Point(i + 1) for i in range(found.NbPoints())])
        return result

    def answer(result):
        ordered = [point for found in result for point in sorted(found, key=lambda point: point.X())]
        at = [one for point in ordered for one in (point.X(), point.Y(), 0)]
        return {"counts": [len(found) for found in result], "at": at}

    return Peer(given, work, answer)


SOLIDS = {
    "Octagon prisms": octagon_prisms,
    "Boxes to Breps": boxes_to_breps,
    "Areas and volumes of boxes": areas_and_volumes,
    "Mesh Brep, straight pipes": straight_pipes,
    "Mesh Brep, curved pipes": curved_pipes,
    "Make2D of spheres": make2d,
    "Project curves on a Brep": project_curves,
    "Capped pipes": capped_pipes,
    "Cap Holes": cap_holes,
    "Variable pipes": variable_pipes,
    "Lofts": lofts,
    "Curve with curve": curve_with_curve,
}
