"""The volume that another kernel's solid encloses once the gaps between its faces and its edges are closed.

Open CASCADE sums the faces' shares as seen from a point. Where a face ends beside its edges, as far as their tolerances
allow, the shell is open, and that sum depends on the point. Here everything is taken from its shape: to each face's
share come strips of straight lines from the image of each pcurve to the edge, triangles to the vertices, and what
pcurves leave open between their ends in the parameter plane. The sum is then the same from anywhere, and is what the
edges bound.
"""

from dataclasses import dataclass

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Curve2d
from OCP.BRepGProp import BRepGProp_Domain, BRepGProp_Face, BRepGProp_Vinert
from OCP.BRepTools import BRepTools, BRepTools_WireExplorer
from OCP.GeomAbs import GeomAbs_BSplineCurve
from OCP.gp import gp_Pnt, gp_Pnt2d, gp_Vec, gp_Vec2d
from OCP.TopAbs import TopAbs_FACE, TopAbs_FORWARD, TopAbs_REVERSED, TopAbs_WIRE
from OCP.TopExp import TopExp
from OCP.TopoDS import TopoDS

from test_step import parts

AS_FACE = getattr(TopoDS, "Face_s", None) or TopoDS.Face
AS_WIRE = getattr(TopoDS, "Wire_s", None) or TopoDS.Wire
# The relative error that the other kernel's integrals are asked for, and the parts that each span of a curve is cut in.
ERROR, CUTS = 1e-10, 8
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(6)


def triple(point):
    return np.array((point.X(), point.Y(), point.Z()))


def gauss(breaks, integrand):
    """The integral over an interval, piece by piece between its breaks."""
    total = 0.0
    for low, high in zip(breaks, breaks[1:]):
        half = 0.5 * (high - low)
        total += half * sum(w * integrand(low + half * (x + 1)) for x, w in zip(POINTS, WEIGHTS))
    return total


def cut(low, high, knots):
    """An interval's ends, the knots within it, and places between these."""
    stops = sorted({low, high, *(t for t in knots if low < t < high)})
    return np.concatenate([np.linspace(a, b, CUTS, endpoint=False) for a, b in zip(stops, stops[1:])] + [[high]])


def knots(curve):
    if curve.GetType() != GeomAbs_BSplineCurve:
        return []
    spline = curve.BSpline()
    return [spline.Knot(k) for k in range(1, spline.NbKnots() + 1)]


class Sheet:
    """A face's surface as the other kernel integrates over it: no farther than its bounds in u, and beyond them in v."""

    def __init__(self, face, point):
        self.surface, self.point = BRep_Tool.Surface_s(face), point
        self.domain = BRepTools.UVBounds_s(face)[:2]

    def at(self, u, v):
        """The place from the point that is looked from, and its derivatives."""
        inner = min(max(u, self.domain[0]), self.domain[1])
        place, by_u, by_v = gp_Pnt(), gp_Vec(), gp_Vec()
        self.surface.D1(inner, v, place, by_u, by_v)
        return triple(place) - self.point, triple(by_u) * (inner == u), triple(by_v)

    def share_below(self, u, v):
        """The integral along u, from where the domain begins: what Green's theorem carries round a loop."""

        def density(x):
            place, by_u, by_v = self.at(x, v)
            return place.dot(np.cross(by_u, by_v)) / 3

        return gauss(np.linspace(self.domain[0], max(self.domain[0], min(u, self.domain[1])), 4 * CUTS), density)


@dataclass
class Side:
    """One edge of a loop, in the loop's direction."""

    edge: object
    sheet: Sheet
    face: object

    def __post_init__(self):
        self.flat = BRepAdaptor_Curve2d(self.edge, self.face)
        self.reversed = self.edge.Orientation() == TopAbs_REVERSED
        self.domain = [self.flat.FirstParameter(), self.flat.LastParameter()]
        self.ends = [self.flat.Value(t) for t in self.domain]
        vertices = [TopExp.FirstVertex_s(self.edge, False), TopExp.LastVertex_s(self.edge, False)]
        self.vertices = [triple(BRep_Tool.Pnt_s(vertex)) - self.sheet.point for vertex in vertices]
        if self.reversed:
            self.ends.reverse()
            self.vertices.reverse()

    def strip(self):
        """The share of the strip from the face to the edge, and of the triangles from its ends to the vertices."""
        if BRep_Tool.Degenerated_s(self.edge):
            return 0.0
        curve = BRepAdaptor_Curve(self.edge)

        def across(t):
            place, by_t, flat, slope = gp_Pnt(), gp_Vec(), gp_Pnt2d(), gp_Vec2d()
            curve.D1(t, place, by_t)
            self.flat.D1(t, flat, slope)
            near, by_u, by_v = self.sheet.at(flat.X(), flat.Y())
            along = by_u * slope.X() + by_v * slope.Y()
            over, turn = triple(place) - self.sheet.point - near, triple(by_t) - along
            return gauss((0.0, 1.0), lambda x: (near + x * over).dot(np.cross(over, along + x * turn)) / 3)

        total = gauss(cut(*self.domain, knots(curve) + knots(self.flat)), across)
        total = -total if self.reversed else total
        ends = [triple(curve.Value(t)) - self.sheet.point for t in self.domain]
        if self.reversed:
            ends.reverse()
        for sign, flat, end, vertex in zip((-1, 1), self.ends, ends, self.vertices):
            total += sign * self.sheet.at(flat.X(), flat.Y())[0].dot(np.cross(end, vertex)) / 6
        return total

    def gap_before(self, before):
        """What is open between the end of the side before and the start of this one: in the plane, and to the vertex."""
        a, b = before.ends[1], self.ends[0]
        if a.Distance(b) == 0:
            return 0.0
        du, dv = b.X() - a.X(), b.Y() - a.Y()

        def open_at(x):
            u, v = a.X() + x * du, a.Y() + x * dv
            near, by_u, by_v = self.sheet.at(u, v)
            along, over = by_u * du + by_v * dv, self.vertices[0] - near
            cone = gauss((0.0, 1.0), lambda y: (near + y * over).dot(np.cross(over, along * (1 - y))) / 3)
            return dv * self.sheet.share_below(u, v) + cone

        return gauss((0.0, 1.0), open_at)


def share(face, point):
    """What the other kernel integrates over a face, as seen from a point."""
    sought, whole = BRepGProp_Vinert(), BRepGProp_Face(face)
    whole.Load(face)
    sought.SetLocation(gp_Pnt(*map(float, point)))
    if BRep_Tool.NaturalRestriction_s(face):
        sought.Perform(whole, ERROR)
    else:
        sought.Perform(whole, BRepGProp_Domain(face), ERROR)
    return sought.Mass()


def closed_volume(shape, point):
    """The volume of a solid, its gaps closed; the point that it is seen from makes no difference but for rounding."""
    total, point = 0.0, np.array(point, dtype=float)
    for face in map(AS_FACE, parts(shape, TopAbs_FACE)):
        total += share(face, point)
        forward = AS_FACE(face.Oriented(TopAbs_FORWARD))
        sheet, closing = Sheet(forward, point), 0.0
        for wire in map(AS_WIRE, parts(forward, TopAbs_WIRE)):
            walk, sides = BRepTools_WireExplorer(wire, forward), []
            while walk.More():
                sides.append(Side(walk.Current(), sheet, forward))
                walk.Next()
            for k, side in enumerate(sides):
                closing += side.strip() + side.gap_before(sides[k - 1])
        total += -closing if face.Orientation() == TopAbs_REVERSED else closing
    return abs(total)
