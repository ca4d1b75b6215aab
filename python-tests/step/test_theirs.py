"""Katydid reads what Open CASCADE writes: in each schema and unit as many solids and faces, and the same volume."""

import math
import subprocess

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common, BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_GTransform,
    BRepBuilderAPI_MakeEdge,
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakePolygon,
    BRepBuilderAPI_MakeWire,
    BRepBuilderAPI_NurbsConvert,
    BRepBuilderAPI_Transform,
)
from OCP.BRepFilletAPI import BRepFilletAPI_MakeChamfer, BRepFilletAPI_MakeFillet
from OCP.BRepOffsetAPI import BRepOffsetAPI_MakePipe, BRepOffsetAPI_ThruSections
from OCP.BRepPrimAPI import (
    BRepPrimAPI_MakeBox,
    BRepPrimAPI_MakeCone,
    BRepPrimAPI_MakeCylinder,
    BRepPrimAPI_MakePrism,
    BRepPrimAPI_MakeRevol,
    BRepPrimAPI_MakeSphere,
    BRepPrimAPI_MakeTorus,
    BRepPrimAPI_MakeWedge,
)
from OCP.collections import HArray1_gp_Pnt
from OCP.GeomAPI import GeomAPI_Interpolate
from OCP.gp import gp_Ax1, gp_Ax2, gp_Circ, gp_Dir, gp_Elips, gp_GTrsf, gp_Hypr, gp_Parab, gp_Pnt, gp_Trsf, gp_Vec
from OCP.Interface import Interface_Static
from OCP.STEPControl import STEPControl_AsIs, STEPControl_Writer
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID
from OCP.TopoDS import TopoDS

from program import ROOT, example
from test_step import parts, volume

as_edge = getattr(TopoDS, "Edge_s", None) or TopoDS.Edge
Z = gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))


def place(origin, axis):
    return gp_Ax2(gp_Pnt(*origin), gp_Dir(*axis))


def spline(points, closed=False):
    row = HArray1_gp_Pnt(1, len(points))
    for k, point in enumerate(points):
        row.SetValue(k + 1, gp_Pnt(*point))
    through = GeomAPI_Interpolate(row, closed, 1e-9)
    through.Perform()
    return edge(through.Curve())


def edge(*curve):
    return BRepBuilderAPI_MakeEdge(*curve).Edge()


def line(a, b):
    return edge(gp_Pnt(*a), gp_Pnt(*b))


def wire(*edges):
    maker = BRepBuilderAPI_MakeWire()
    for one in edges:
        maker.Add(one)
    return maker.Wire()


def polygon(*points):
    maker = BRepBuilderAPI_MakePolygon()
    for point in points:
        maker.Add(gp_Pnt(*point))
    maker.Close()
    return maker.Wire()


def circle(origin, axis, radius):
    return wire(edge(gp_Circ(place(origin, axis), radius)))


def face(of):
    return BRepBuilderAPI_MakeFace(of, True).Face()


def prism(of, way):
    return BRepPrimAPI_MakePrism(face(of), gp_Vec(*way)).Shape()


def box(*size):
    return BRepPrimAPI_MakeBox(*size).Shape()


def cylinder(origin, axis, radius, height):
    return BRepPrimAPI_MakeCylinder(place(origin, axis), radius, height).Shape()


def ball(origin, radius):
    return BRepPrimAPI_MakeSphere(gp_Pnt(*origin), radius).Shape()


def cone(*radii, height=12, angle=2 * math.pi):
    return BRepPrimAPI_MakeCone(*radii, height, angle).Shape()


def torus(*more):
    return BRepPrimAPI_MakeTorus(10.0, 3.0, *more).Shape()


def cut(a, b):
    return BRepAlgoAPI_Cut(a, b).Shape()


def fuse(a, b):
    return BRepAlgoAPI_Fuse(a, b).Shape()


def common(a, b):
    return BRepAlgoAPI_Common(a, b).Shape()


def edges(shape):
    found = []
    for one in parts(shape, TopAbs_EDGE):
        if not any(one.IsSame(other) for other in found):
            found.append(one)
    return found


def broken(maker, shape, size, count=None):
    work = maker(shape)
    for one in edges(shape)[:count]:
        work.Add(size, as_edge(one))
    return work.Shape()


def filleted(shape, radius, count=None):
    return broken(BRepFilletAPI_MakeFillet, shape, radius, count)


def loft(*wires, ruled=False):
    work = BRepOffsetAPI_ThruSections(True, ruled, 1e-6)
    for one in wires:
        work.AddWire(one)
    work.Build()
    return work.Shape()


def moved(shape):
    turn, shift = gp_Trsf(), gp_Trsf()
    turn.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 1)), 0.7)
    shift.SetTranslation(gp_Vec(30, -20, 10))
    return BRepBuilderAPI_Transform(shape, shift.Multiplied(turn), True).Shape()


def mirrored(shape):
    mirror = gp_Trsf()
    mirror.SetMirror(gp_Ax2(gp_Pnt(50, 0, 0), gp_Dir(1, 0.2, 0)))
    return BRepBuilderAPI_Transform(shape, mirror, True).Shape()


def sheared(shape):
    shear = gp_GTrsf()
    shear.SetValue(1, 1, 2.0)
    shear.SetValue(2, 3, 0.3)
    return BRepBuilderAPI_GTransform(shape, shear, True).Shape()


def as_splines(shape):
    return BRepBuilderAPI_NurbsConvert(shape).Shape()


def crossed():
    return fuse(cylinder((0, 0, -10), (0, 0, 1), 4, 20), cylinder((-10, 0, 0), (1, 0, 0), 3, 20))


def drilled():
    return cut(box(10, 20, 30), cylinder((5, 10, -5), (0, 0, 1), 3, 50))


def vase():
    profile = spline([(0, 0, 0), (4, 0, 1), (6, 0, 4), (3, 0, 8), (4, 0, 12)])
    outline = wire(profile, line((4, 0, 12), (0, 0, 12)), line((0, 0, 12), (0, 0, 0)))
    return BRepPrimAPI_MakeRevol(face(outline), Z).Shape()


def ring(*angle):
    profile = wire(spline([(8, 0, 0), (10, 0, 2), (9, 0, 5), (7, 0, 3)], True))
    return BRepPrimAPI_MakeRevol(face(profile), Z, *angle).Shape()


def pipe():
    rail = wire(spline([(0, 0, 0), (5, 3, 5), (0, 6, 10), (4, 2, 15)]))
    return BRepOffsetAPI_MakePipe(rail, face(circle((0, 0, 0), (0.5, 0.3, 0.5), 1))).Shape()


def parabola():
    return prism(wire(edge(gp_Parab(place((0, 0, 0), (0, 0, 1)), 2), -4.0, 4.0), line((2, -4, 0), (2, 4, 0))), (1, 0, 5))


def hyperbola():
    x, y = 2 * math.cosh(1), 1.5 * math.sinh(1)
    branch = edge(gp_Hypr(place((0, 0, 0), (0, 0, 1)), 2, 1.5), -1.0, 1.0)
    return prism(wire(branch, line((x, -y, 0), (x, y, 0))), (0, 0, 5))


SQUARE = polygon((0, 0, 0), (5, 0, 0), (5, 5, 0), (0, 5, 0))
SHAPES = {
    "box": lambda: box(3, 4, 5),
    "cylinder": lambda: cylinder((1, 2, 3), (1, 1, 0), 2, 9),
    "cone": lambda: cone(5, 0),
    "frustum": lambda: cone(5, 2),
    "part of a cone": lambda: cone(5, 2, angle=2.5),
    "ball": lambda: ball((1, 2, 3), 4),
    "dome": lambda: BRepPrimAPI_MakeSphere(5.0, 0.0, math.pi / 2).Shape(),
    "zone of a ball": lambda: BRepPrimAPI_MakeSphere(5.0, -0.4, 0.9, 2.0).Shape(),
    "torus": torus,
    "part of a torus": lambda: torus(2.0),
    "patch of a torus": lambda: torus(0.3, 2.5, 2.0),
    "wedge": lambda: BRepPrimAPI_MakeWedge(5.0, 6.0, 7.0, 2.0).Shape(),
    "fillets": lambda: filleted(box(10, 20, 30), 2),
    "fillets at a corner": lambda: filleted(box(10, 20, 30), 3, 3),
    "fillets of a cylinder": lambda: filleted(cylinder((0, 0, 0), (0, 0, 1), 5, 10), 1),
    "fillets of a cross": lambda: filleted(crossed(), 0.5),
    "chamfers": lambda: broken(BRepFilletAPI_MakeChamfer, box(10, 20, 30), 2),
    "drilled": lambda: cut(drilled(), ball((10, 20, 30), 6)),
    "crossed": crossed,
    "two cylinders": lambda: common(
        cylinder((0, 0, -10), (0, 0, 1), 4, 20), cylinder((-10, 0, 0), (1, 0, 0), 4, 20)
    ),
    "hollow": lambda: cut(box(10, 20, 30), ball((5, 10, 15), 3)),
    "twice hollow": lambda: cut(
        cut(box(10, 20, 30), ball((5, 5, 15), 3)), cylinder((5, 14, 10), (0, 0, 1), 2, 8)
    ),
    "two pieces": lambda: cut(box(10, 20, 30), BRepPrimAPI_MakeBox(gp_Pnt(-1, 8, -1), gp_Pnt(11, 12, 31)).Shape()),
    "cone cut": lambda: cut(cone(5, 0), BRepPrimAPI_MakeBox(gp_Pnt(1, -9, -1), gp_Pnt(9, 9, 20)).Shape()),
    "torus cut": lambda: cut(torus(), BRepPrimAPI_MakeBox(gp_Pnt(0, -20, -9), gp_Pnt(20, 20, 1)).Shape()),
    "ball drilled": lambda: cut(ball((0, 0, 0), 5), cylinder((2, 0, -9), (0, 0, 1), 1.5, 20)),
    "window of a ball": lambda: common(ball((0, 0, 0), 4), cylinder((2, 0, -9), (0, 0, 1), 2, 20)),
    "ball and torus": lambda: fuse(ball((0, 0, 0), 9), torus()),
    "vase": vase,
    "ring": ring,
    "part of a ring": lambda: ring(1.7),
    "pipe": pipe,
    "loft": lambda: loft(
        circle((0, 0, 0), (0, 0, 1), 5), circle((1, 0, 5), (0, 0.1, 1), 3), circle((0, 2, 10), (0, 0, 1), 4)
    ),
    "ruled loft": lambda: loft(SQUARE, polygon((1, 1, 6), (4, 2, 6), (4, 4, 6), (1, 4, 6)), ruled=True),
    "oblique prism": lambda: prism(wire(edge(gp_Elips(place((0, 0, 0), (0, 0, 1)), 6, 3))), (1, 2, 9)),
    "parabola": parabola,
    "hyperbola": hyperbola,
    "mirrored": lambda: mirrored(filleted(box(10, 20, 30), 2)),
    "moved": lambda: moved(crossed()),
    "ball of splines": lambda: as_splines(ball((0, 0, 0), 5)),
    "torus of splines": lambda: as_splines(torus()),
    "cone of splines": lambda: as_splines(cone(5, 0)),
    "drilled, of splines": lambda: as_splines(drilled()),
    "fillets of splines": lambda: as_splines(filleted(box(10, 20, 30), 2)),
    "ellipsoid": lambda: sheared(ball((0, 0, 0), 5)),
    "sheared torus": lambda: sheared(torus()),
    "sheared and drilled": lambda: sheared(drilled()),
}
FORMS = [("AP214CD", "MM"), ("AP203", "INCH"), ("AP214IS", "M"), ("AP242DIS", "MM")]


def read_back(paths):
    done = subprocess.run([example("read_steps"), "--measure", *paths], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    return [line.split("\t") for line in done.stdout.splitlines()]


@pytest.fixture(scope="module")
def found(tmp_path_factory):
    folder, wanted = tmp_path_factory.mktemp("theirs"), {}
    for name, make in SHAPES.items():
        shape = make()
        for schema, unit in FORMS:
            Interface_Static.SetCVal_s("write.step.schema", schema)
            Interface_Static.SetCVal_s("write.step.unit", unit)
            writer = STEPControl_Writer()
            writer.Transfer(shape, STEPControl_AsIs)
            path = str(folder / f"{name}-{schema}-{unit}.step")
            writer.Write(path)
            wanted[path] = (len(parts(shape, TopAbs_SOLID)), len(parts(shape, TopAbs_FACE)), abs(volume(shape)))
    Interface_Static.SetCVal_s("write.step.unit", "MM")
    return wanted, read_back(wanted)


def test_what_open_cascade_writes_is_read(found):
    wanted, rows = found
    assert len(wanted) == len(SHAPES) * len(FORMS)
    wrong = [" ".join(row) for row in rows if len(row) < 4 and not row[0].endswith("0 invalid breps")]
    for path, (solids, faces, amount) in wanted.items():
        mine = [row for row in rows if row[0] == path and len(row) == 4]
        total = sum(float(row[3]) for row in mine if row[2] == "closed")
        same = len(mine) == solids and sum(int(row[1]) for row in mine) == faces
        if not same or abs(total / amount - 1.0) > 1e-6:
            wrong.append(f"{path}: {solids} solids, {faces} faces, {amount} there, {mine} here")
    assert not wrong, "\n".join(wrong)
