"""Point3d, Point2d, Point3f, Point4d and Point2f."""

import math

from .base import NotSupported
from .tuples import PointLike, coordinates, fill
from .vector import Vector2d, Vector2f, Vector3d, Vector3f

_new = object.__new__


class Point3d(PointLike):
    """A point in space."""

    __slots__ = ("X", "Y", "Z")
    _fields = ("X", "Y", "Z")
    _vector = Vector3d

    def __init__(self, *arguments):
        if len(arguments) == 3:
            x, y, z = arguments
            try:
                _set_x(self, float(x))
                _set_y(self, float(y))
                _set_z(self, float(z))
                return
            except (TypeError, ValueError):
                raise TypeError("expected float, got %s" % "/".join(type(a).__name__ for a in arguments))
        if len(arguments) == 1 and type(arguments[0]) is Point4d:
            four = arguments[0]
            weight = four.W if four.W else 1.0
            arguments = (four.X / weight, four.Y / weight, four.Z / weight)
        fill(self, arguments)

    @staticmethod
    def _make(x, y, z):
        """A point of three floats, without checks: for loops that make many."""
        made = _new(Point3d)
        _set_x(made, x)
        _set_y(made, y)
        _set_z(made, z)
        return made

    def _parts(self):
        return (self.X, self.Y, self.Z)

    def _copy(self):
        return Point3d._make(self.X, self.Y, self.Z)

    def __add__(self, other):
        kind = type(other)
        if kind is Vector3d or kind is Point3d:
            return Point3d._make(self.X + other.X, self.Y + other.Y, self.Z + other.Z)
        return PointLike.__add__(self, other)

    def __sub__(self, other):
        kind = type(other)
        if kind is Point3d:
            return Vector3d._make(self.X - other.X, self.Y - other.Y, self.Z - other.Z)
        if kind is Vector3d:
            return Point3d._make(self.X - other.X, self.Y - other.Y, self.Z - other.Z)
        return PointLike.__sub__(self, other)

    def DistanceTo(self, other):
        if type(other) is not Point3d:
            other = Point3d._make(*coordinates(other, 3))
        dx, dy, dz = self.X - other.X, self.Y - other.Y, self.Z - other.Z
        return math.sqrt(dx * dx + dy * dy + dz * dz)

    def Interpolate(self, a, b, t):
        self.X, self.Y, self.Z = a.X + t * (b.X - a.X), a.Y + t * (b.Y - a.Y), a.Z + t * (b.Z - a.Z)

    def Transform(self, xform):
        self.X, self.Y, self.Z = xform._point(self.X, self.Y, self.Z)

    @staticmethod
    def FromPoint3f(point):
        return Point3d(point)

    @staticmethod
    def ArePointsCoplanar(points, tolerance):
        """Whether all points lie within the tolerance of one plane: that of the widest triangle from the first."""
        found = [Point3d(point) for point in points]
        normal = _widest_normal(found)
        return normal is None or all(abs((point - found[0]) * normal) <= tolerance for point in found)

    @staticmethod
    def CullDuplicates(points, tolerance):
        """The points without those within the tolerance of an earlier one; None where there are none."""
        kept = []
        cells = {}
        size = tolerance if tolerance > 0.0 else 0.0
        for point in map(Point3d, points):
            key = tuple(math.floor(c / size) for c in point._parts()) if size else point._parts()
            if size:
                near = ((key[0] + i, key[1] + j, key[2] + k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1))
                if any(point.DistanceTo(other) <= tolerance for cell in near for other in cells.get(cell, ())):
                    continue
            elif key in cells:
                continue
            cells.setdefault(key, []).append(point)
            kept.append(point)
        return kept or None

    @staticmethod
    def SortAndCullPointList(points, minimumDistance):
        raise NotSupported("Rhino.Geometry.Point3d.SortAndCullPointList is not supported by Katydid yet")


_set_x, _set_y, _set_z = (Point3d.__dict__[name].__set__ for name in "XYZ")


def _widest_normal(points):
    """The unit normal of the triangle from the first point that spans most area, or None where all are in line."""
    if len(points) < 3:
        return None
    first = points[0]
    far = max(points, key=first.DistanceTo)
    along = far - first
    best = max((Vector3d.CrossProduct(along, point - first) for point in points), key=lambda n: n.SquareLength)
    return best if best.Unitize() else None


class Point2d(PointLike):
    """A point in the plane, or of a surface's parameters."""

    __slots__ = ("X", "Y")
    _fields = ("X", "Y")
    _vector = Vector2d

    def __init__(self, *arguments):
        fill(self, arguments)

    def Transform(self, xform):
        self.X, self.Y = xform._point(self.X, self.Y, 0.0)[:2]


class Point3f(PointLike):
    """A point in single precision, as meshes hold."""

    __slots__ = ("X", "Y", "Z")
    _fields = ("X", "Y", "Z")
    _rounded = True
    _vector = Vector3f

    def __init__(self, *arguments):
        fill(self, arguments)

    def Transform(self, xform):
        self.X, self.Y, self.Z = xform._point(self.X, self.Y, self.Z)


class Point2f(PointLike):
    """A point of texture coordinates."""

    __slots__ = ("X", "Y")
    _fields = ("X", "Y")
    _rounded = True
    _vector = Vector2f

    def __init__(self, *arguments):
        fill(self, arguments)


class Point4d(PointLike):
    """A control point with its weight (homogeneous coordinates)."""

    __slots__ = ("X", "Y", "Z", "W")
    _fields = ("X", "Y", "Z", "W")

    def __init__(self, *arguments):
        if len(arguments) == 1 and len(arguments[0]) == 3:
            arguments = tuple(coordinates(arguments[0], 3)) + (1.0,)
        fill(self, arguments)


Point4d._vector = Point4d
