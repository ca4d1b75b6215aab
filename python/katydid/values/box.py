"""BoundingBox and Box."""

from .base import UNSET, Struct, dual, field, static_value
from .interval import Interval, to_interval
from .plane import Plane, to_plane, to_point
from .point import Point3d
from .vector import Vector3d


def _span(points):
    parts = list(zip(*[point._parts() for point in points]))
    return Point3d(*map(min, parts)), Point3d(*map(max, parts))


class BoundingBox(Struct):
    """A box along the world's axes, from Min to Max."""

    __slots__ = ("_min", "_max")
    _fields = ("_min", "_max")

    Min = field("_min", to_point)
    Max = field("_max", to_point)

    def __init__(self, *arguments):
        if len(arguments) == 6:
            low, high = Point3d(*arguments[:3]), Point3d(*arguments[3:])
        elif len(arguments) == 2 and not hasattr(arguments[1], "_m"):
            low, high = to_point(arguments[0]), to_point(arguments[1])
        elif not arguments:
            low = high = Point3d()
        else:
            points = [to_point(point) for point in arguments[0]]
            if len(arguments) == 2:
                points = arguments[1].TransformList(points)
            low, high = _span(points) if points else (BoundingBox.Empty._min, BoundingBox.Empty._max)
        self._min, self._max = low._copy(), high._copy()

    @property
    def IsValid(self):
        return self._min.IsValid and self._max.IsValid and all(
            a <= b for a, b in zip(self._min._parts(), self._max._parts()))

    Diagonal = property(lambda self: self._max - self._min)
    Center = property(lambda self: Point3d(*[0.5 * (a + b) for a, b in zip(self._min._parts(), self._max._parts())]))

    @property
    def Area(self):
        x, y, z = self.Diagonal._parts()
        return 2.0 * (x * y + y * z + z * x) if self.IsValid else 0.0

    @property
    def Volume(self):
        x, y, z = self.Diagonal._parts()
        return x * y * z if self.IsValid else 0.0

    def Corner(self, minX, minY, minZ):
        return Point3d(*[(low if take else high) for take, low, high in
                         zip((minX, minY, minZ), self._min._parts(), self._max._parts())])

    def GetCorners(self):
        """Eight corners: counter-clockwise below, then above."""
        if not self.IsValid:
            return []
        order = ((1, 1), (0, 1), (0, 0), (1, 0))
        return [self.Corner(x, y, z) for z in (1, 0) for x, y in order]

    def GetEdges(self):
        """Twelve lines: four below, four above, four upright."""
        from .line import Line
        c = self.GetCorners()
        pairs = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
        return [Line(c[a], c[b]) for a, b in pairs] if c else []

    def PointAt(self, tx, ty, tz):
        return Point3d(*[a + t * (b - a) for t, a, b in zip((tx, ty, tz), self._min._parts(), self._max._parts())])

    def Contains(self, other, strict=False):
        points = [other._min, other._max] if isinstance(other, BoundingBox) else [to_point(other)]
        if not self.IsValid:
            return False
        low, high = self._min._parts(), self._max._parts()
        return all((a < c < b) if strict else (a <= c <= b)
                   for point in points for a, b, c in zip(low, high, point._parts()))

    def ClosestPoint(self, point, includeInterior=True):
        parts = to_point(point)._parts()
        low, high = self._min._parts(), self._max._parts()
        near = [min(max(c, a), b) for c, a, b in zip(parts, low, high)]
        if not includeInterior and list(parts) == near:
            gaps = [(min(c - a, b - c), i) for i, (c, a, b) in enumerate(zip(parts, low, high))]
            _, i = min(gaps)
            near[i] = low[i] if parts[i] - low[i] <= high[i] - parts[i] else high[i]
        return Point3d(*near)

    def FurthestPoint(self, point):
        parts = to_point(point)._parts()
        return Point3d(*[a if abs(c - a) > abs(c - b) else b
                         for c, a, b in zip(parts, self._min._parts(), self._max._parts())])

    def Inflate(self, x, y=None, z=None):
        grow = Vector3d(x, x if y is None else y, x if z is None else z)
        self._min, self._max = self._min - grow, self._max + grow

    def IsDegenerate(self, tolerance):
        """0 none, 1 flat in one direction, 2 in two (a line), 3 in all (a point), 4 invalid."""
        if not self.IsValid:
            return 4
        return sum(abs(part) <= tolerance for part in self.Diagonal._parts())

    def MakeValid(self):
        self._min, self._max = _span([self._min, self._max])
        return self.IsValid

    def Transform(self, xform):
        corners = self.GetCorners()
        if not corners:
            return False
        self._min, self._max = _span(xform.TransformList(corners))
        return True

    def _union(self, other):
        made = _united(self, other)
        self._min, self._max = made._min, made._max

    Union = dual(_union, lambda a, b: _united(a, b))

    @staticmethod
    def Intersection(a, b):
        low = Point3d(*map(max, a._min._parts(), b._min._parts()))
        high = Point3d(*map(min, a._max._parts(), b._max._parts()))
        made = BoundingBox(low, high)
        return made if a.IsValid and b.IsValid and made.IsValid else BoundingBox.Unset

    def ToBrep(self):
        from ..geometry import static_call
        return static_call("Brep", "CreateFromBox", self)

    def ToString(self, *format_and_culture):
        return "%s - %s" % (self._min, self._max)

    Empty = static_value(lambda cls: cls(1.0, 0.0, 0.0, -1.0, 0.0, 0.0))
    Unset = static_value(lambda cls: cls(*[UNSET] * 6))


def _united(a, b):
    points = [point for part in (a, b) for point in
              ((part._min, part._max) if isinstance(part, BoundingBox) and part.IsValid else
               () if isinstance(part, BoundingBox) else (to_point(part),))]
    return BoundingBox(*_span(points)) if points else BoundingBox.Empty


class Box(Struct):
    """A box in a plane of its own, by an interval along each axis."""

    __slots__ = ("_plane", "_dx", "_dy", "_dz")
    _fields = ("_plane", "_dx", "_dy", "_dz")

    Plane = field("_plane", to_plane)
    X = field("_dx", to_interval)
    Y = field("_dy", to_interval)
    Z = field("_dz", to_interval)

    def __init__(self, *arguments):
        plane = to_plane(arguments[0]) if len(arguments) > 1 else Plane.WorldXY
        if len(arguments) == 4:
            spans = [to_interval(span) for span in arguments[1:]]
        elif not arguments:
            spans = [Interval.Unset] * 3
        elif len(arguments) == 1 and isinstance(arguments[0], Box):
            plane, spans = arguments[0]._plane, [arguments[0]._dx, arguments[0]._dy, arguments[0]._dz]
        else:
            spans = _spans_in(plane, arguments[-1], len(arguments) == 1)
        self._plane = plane._copy()
        self._dx, self._dy, self._dz = [span._copy() for span in spans]

    @property
    def IsValid(self):
        return self._plane.IsValid and all(span.IsValid for span in (self._dx, self._dy, self._dz))

    def PointAt(self, x, y, z):
        return self._plane.PointAt(self._dx.ParameterAt(x), self._dy.ParameterAt(y), self._dz.ParameterAt(z))

    Center = property(lambda self: self.PointAt(0.5, 0.5, 0.5))

    def _sizes(self):
        return [abs(span.Length) for span in (self._dx, self._dy, self._dz)]

    @property
    def Area(self):
        x, y, z = self._sizes()
        return 2.0 * (x * y + y * z + z * x) if self.IsValid else 0.0

    @property
    def Volume(self):
        x, y, z = self._sizes()
        return x * y * z if self.IsValid else 0.0

    def GetCorners(self):
        order = ((0, 0), (1, 0), (1, 1), (0, 1))
        return [self.PointAt(x, y, z) for z in (0, 1) for x, y in order] if self.IsValid else []

    @property
    def BoundingBox(self):
        corners = self.GetCorners()
        return BoundingBox(corners) if corners else BoundingBox.Empty

    def Contains(self, other, strict=False):
        points = other.GetCorners() if hasattr(other, "GetCorners") else [to_point(other)]
        for point in points:
            local = self._plane._local(point)
            if not all(span.IncludesParameter(c, strict) for span, c in zip((self._dx, self._dy, self._dz), local)):
                return False
        return True

    def _inside(self):
        """This box as one along the axes of its plane."""
        spans = (self._dx, self._dy, self._dz)
        return BoundingBox(Point3d(*[s.Min for s in spans]), Point3d(*[s.Max for s in spans]))

    def ClosestPoint(self, point):
        return self._plane.PointAt(*self._inside().ClosestPoint(Point3d(*self._plane._local(point))))

    def FurthestPoint(self, point):
        return self._plane.PointAt(*self._inside().FurthestPoint(Point3d(*self._plane._local(point))))

    def Inflate(self, x, y=None, z=None):
        self.MakeValid()
        for span, grow in ((self._dx, x), (self._dy, x if y is None else y), (self._dz, x if z is None else z)):
            span.T0, span.T1 = span.T0 - grow, span.T1 + grow

    def MakeValid(self):
        for span in (self._dx, self._dy, self._dz):
            span.MakeIncreasing()
        return self.IsValid

    def RepositionBasePlane(self, origin):
        """Moves the plane's origin and leaves the box where it is."""
        shift = self._plane._local(origin)
        self._plane.Origin = origin
        for span, by in zip((self._dx, self._dy, self._dz), shift):
            span.T0, span.T1 = span.T0 - by, span.T1 - by

    def Union(self, point):
        for span, c in zip((self._dx, self._dy, self._dz), self._plane._local(point)):
            span.Grow(c)

    def Transform(self, xform):
        """Moves, turns and scales the box; each axis is measured after the change."""
        spans = (self._dx, self._dy, self._dz)
        corners = self.GetCorners()
        plane = self._plane._copy()
        if not corners or not plane.Transform(xform):
            return False
        axes = (self._plane._x, self._plane._y, self._plane._z)
        for span, axis in zip(spans, axes):
            image = Vector3d(*xform._direction(*axis._parts()))
            span.T0, span.T1 = span.T0 * image.Length, span.T1 * image.Length
        self._plane = plane
        return True

    def ToBrep(self):
        from ..geometry import static_call
        return static_call("Brep", "CreateFromBox", self)

    def ToExtrusion(self):
        from ..geometry import static_call
        return static_call("Extrusion", "CreateBoxExtrusion", self, True)

    Empty = static_value(lambda cls: cls(BoundingBox.Empty))
    Unset = static_value(lambda cls: cls(Plane.Unset, Interval.Unset, Interval.Unset, Interval.Unset))


def _spans_in(plane, thing, world):
    """The intervals along a plane's axes that points, a box or geometry cover."""
    if isinstance(thing, BoundingBox) and (world or plane == Plane.WorldXY):
        return [Interval(a, b) for a, b in zip(thing._min._parts(), thing._max._parts())]
    if hasattr(thing, "GetBoundingBox"):
        box = thing.GetBoundingBox(plane)
        if isinstance(box, tuple):
            box = box[0]
        return [Interval(a, b) for a, b in zip(box._min._parts(), box._max._parts())]
    points = thing.GetCorners() if hasattr(thing, "GetCorners") else thing
    local = list(zip(*[plane._local(point) for point in points]))
    return [Interval(min(parts), max(parts)) for parts in local] if local else [Interval.Unset] * 3


def to_box(value):
    """A Box of a box of either kind."""
    return value._copy() if isinstance(value, Box) else Box(value)
