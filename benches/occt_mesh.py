"""Open CASCADE's times and triangles for the surface that `mesh_speed` meshes, whole and with a hole.

    python benches/occt_mesh.py ../shared/data/kernel-bench/inputs.txt [REPEATS]

With cadquery-ocp (python-tests/step/requirements.txt). The angle is free, so that the chord alone counts, and one
thread works, as in the example.
"""

import statistics
import sys
import time

from OCP.BRep import BRep_Tool
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakeWire
from OCP.BRepLib import BRepLib
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.collections import Array1_double, Array1_int, Array2_gp_Pnt
from OCP.Geom import Geom_BSplineSurface
from OCP.Geom2d import Geom2d_Circle
from OCP.gp import gp_Ax22d, gp_Circ2d, gp_Dir2d, gp_Pnt, gp_Pnt2d
from OCP.TopLoc import TopLoc_Location

ANGLE = 0.5
# The hole: a circle in the parameter plane.
CENTRE, RADIUS = 0.5, 0.25


class Words:
    """The numbers of an inputs file, one after the other."""

    def __init__(self, path):
        with open(path) as file:
            self.words = iter(file.read().split())

    def count(self):
        return int(next(self.words))

    def numbers(self, many):
        return [float(next(self.words)) for _ in range(many)]

    def surface(self, wanted):
        """Degrees, counts, knots and homogeneous points of the surface of that name."""
        for kind in self.words:
            name = next(self.words)
            if kind == "curve":
                degree, points, _ = self.count(), self.count(), self.count()
                self.numbers(points + degree + 1 + 4 * points)
            elif kind == "surf":
                degrees = [self.count(), self.count()]
                counts = [self.count(), self.count()]
                self.count()
                knots = [self.numbers(n + p + 1) for n, p in zip(counts, degrees)]
                points = [self.numbers(4) for _ in range(counts[0] * counts[1])]
                if name == wanted:
                    return degrees, counts, knots, points
            elif kind == "pts":
                self.numbers(3 * self.count())
            else:
                rows, columns = self.count(), self.count()
                self.numbers(rows * columns)
        raise SystemExit(f"no surface {wanted}")


def stepped(knots):
    """The knots that differ, and how often each stands there."""
    values = sorted(set(knots))
    reals = Array1_double(1, len(values))
    counts = Array1_int(1, len(values))
    for place, value in enumerate(values, 1):
        reals.SetValue(place, value)
        counts.SetValue(place, knots.count(value))
    return reals, counts


def theirs(degrees, counts, knots, points):
    poles = Array2_gp_Pnt(1, counts[0], 1, counts[1])
    for place, (x, y, z, _) in enumerate(points):
        row, column = divmod(place, counts[1])
        poles.SetValue(row + 1, column + 1, gp_Pnt(x, y, z))
    (u, in_u), (v, in_v) = map(stepped, knots)
    return Geom_BSplineSurface(poles, u, v, in_u, in_v, *degrees)


def whole(surface):
    return BRepBuilderAPI_MakeFace(surface, 1e-6).Face()


def holed(surface):
    axes = gp_Ax22d(gp_Pnt2d(CENTRE, CENTRE), gp_Dir2d(1, 0), gp_Dir2d(0, 1))
    rim = BRepBuilderAPI_MakeEdge(Geom2d_Circle(gp_Circ2d(axes, RADIUS)), surface).Edge()
    wire = BRepBuilderAPI_MakeWire(rim).Wire()
    wire.Reverse()
    maker = BRepBuilderAPI_MakeFace(surface, 1e-6)
    maker.Add(wire)
    face = maker.Face()
    BRepLib.BuildCurves3d_s(face)
    return face


def main():
    surface = theirs(*Words(sys.argv[1]).surface("tess"))
    repeats = int(sys.argv[2]) if len(sys.argv) > 2 else 3
    for name, make in (("tess", whole), ("trim", holed)):
        for chord in (1e-3, 1e-4):
            times = []
            for _ in range(repeats):
                face = make(surface)
                start = time.perf_counter()
                BRepMesh_IncrementalMesh(face, chord, False, ANGLE, False)
                times.append(time.perf_counter() - start)
            count = BRep_Tool.Triangulation_s(face, TopLoc_Location()).NbTriangles()
            print(f"{name} {chord:g}: {count} triangles, median {1e3 * statistics.median(times):.1f} ms of {repeats}", flush=True)


main()
