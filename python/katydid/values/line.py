"""Line: a segment, which some questions extend without end."""

from .base import UNSET, Struct, field, static_value
from .plane import Plane, to_point, to_vector
from .point import Point3d
from .vector import Vector3d


class Line(Struct):
    """The segment between two points; parameters run from 0 to 1."""

    __slots__ = ("_from", "_to")
    _fields = ("_from", "_to")

    From = field("_from", to_point)
    To = field("_to", to_point)

    def __init__(self, *arguments):
        if len(arguments) == 6:
            start, end = Point3d(*arguments[:3]), Point3d(*arguments[3:])
        elif len(arguments) == 3:
            start, along = to_point(arguments[0]), to_vector(arguments[1])
            along.Unitize()
            end = start + along * float(arguments[2])
        elif len(arguments) == 2:
            start = to_point(arguments[0])
            end = start + arguments[1] if isinstance(arguments[1], Vector3d) else to_point(arguments[1])
        elif len(arguments) == 1 and isinstance(arguments[0], Line):
            start, end = arguments[0]._from._copy(), arguments[0]._to._copy()
        elif not arguments:
            start, end = Point3d(), Point3d()
        else:
            raise TypeError("Line() takes two points, a point and a vector, or six numbers")
        self._from, self._to = start, end

    Direction = property(lambda self: self._to - self._from)
    IsValid = property(lambda self: self._from.IsValid and self._to.IsValid and self._from != self._to)
    BoundingBox = property(lambda self: _box([self._from, self._to]))

    @property
    def UnitTangent(self):
        along = self.Direction
        along.Unitize()
        return along

    @property
    def Length(self):
        return self._from.DistanceTo(self._to)

    @Length.setter
    def Length(self, value):
        along = self.UnitTangent
        if along.IsZero:
            along = Vector3d.ZAxis
        self._to = self._from + along * value

    def PointAt(self, t):
        a, b = self._from, self._to
        # Exact at both ends.
        return Point3d._make(*[p if p == q else (1.0 - t) * p + t * q for p, q in zip(a._parts(), b._parts())])

    def PointAtLength(self, distance):
        return self._from + self.UnitTangent * distance

    def ClosestParameter(self, testPoint):
        along = self.Direction
        square = along.SquareLength
        return ((to_point(testPoint) - self._from) * along) / square if square > 0.0 else 0.0

    def ClosestPoint(self, testPoint, limitToFiniteSegment):
        t = self.ClosestParameter(testPoint)
        return self.PointAt(max(0.0, min(1.0, t)) if limitToFiniteSegment else t)

    def DistanceTo(self, testPoint, limitToFiniteSegment):
        return self.ClosestPoint(testPoint, limitToFiniteSegment).DistanceTo(testPoint)

    def MinimumDistanceTo(self, other):
        """To a point or to another segment."""
        if isinstance(other, Line):
            a, b = segment_feet(self, other)
            return self.PointAt(a).DistanceTo(other.PointAt(b))
        return self.DistanceTo(other, True)

    def MaximumDistanceTo(self, other):
        ends = [other._from, other._to] if isinstance(other, Line) else [to_point(other)]
        return max(a.DistanceTo(b) for a in (self._from, self._to) for b in ends)

    def Flip(self):
        self._from, self._to = self._to, self._from

    def Extend(self, startLength, endLength):
        along = self.UnitTangent
        if along.IsZero:
            return False
        self._from, self._to = self._from - along * startLength, self._to + along * endLength
        return True

    def ExtendThroughBox(self, box, additionalLength=0.0):
        """Extends both ends until a box lies between them."""
        found = [self.ClosestParameter(corner) for corner in box.GetCorners()]
        length = self.Length
        if not found or length <= 0.0:
            return False
        more = additionalLength / length
        low, high = min(found + [0.0]) - more, max(found + [1.0]) + more
        self._from, self._to = self.PointAt(low), self.PointAt(high)
        return True

    def Transform(self, xform):
        for point in (self._from, self._to):
            point.Transform(xform)
        return True

    def TryGetPlane(self, *place_holders):
        """A plane that holds the line: its x axis goes along it."""
        along = self.UnitTangent
        if along.IsZero:
            return False, Plane.Unset
        across = Vector3d()
        across.PerpendicularTo(along)
        return True, Plane(self._from, along, across)

    def ToNurbsCurve(self):
        from ..geometry import as_curve, call
        return call(as_curve(self), "ToNurbsCurve")

    @staticmethod
    def TryFitLineToPoints(points, *place_holders):
        from .fit import line_of_points
        return line_of_points([to_point(point) for point in points])

    def ToString(self, *format_and_culture):
        return "%s,%s" % (self._from, self._to)

    Unset = static_value(lambda cls: cls(*[UNSET] * 6))


class Ray3d(Struct):
    """A point and a direction: a line with one end."""

    __slots__ = ("_position", "_direction")
    _fields = ("_position", "_direction")

    Position = field("_position", to_point)
    Direction = field("_direction", to_vector)

    def __init__(self, position, direction):
        self._position, self._direction = to_point(position), to_vector(direction)

    def PointAt(self, t):
        return self._position + self._direction * t


def _end(slot, name):
    return property(lambda self: getattr(getattr(self, slot), name),
                    lambda self, value: setattr(getattr(self, slot), name, value))


for _axis in "XYZ":
    setattr(Line, "From" + _axis, _end("_from", _axis))
    setattr(Line, "To" + _axis, _end("_to", _axis))


def _box(points):
    from .box import BoundingBox
    return BoundingBox(points)


def infinite_feet(a, b):
    """Parameters of the closest points of two lines without ends, or None where they are parallel."""
    u, v, w = a.Direction, b.Direction, b._from - a._from
    uu, uv, vv, uw, vw = u * u, u * v, v * v, u * w, v * w
    determinant = uu * vv - uv * uv
    if determinant <= 1e-24 * uu * vv or uu <= 0.0 or vv <= 0.0:
        return None
    return (vv * uw - uv * vw) / determinant, (uv * uw - uu * vw) / determinant


def segment_feet(a, b):
    """Parameters of the closest points of two segments (C. Ericson, Real-Time Collision Detection, 5.1.9)."""
    def clamp(t):
        return max(0.0, min(1.0, t))
    best = None
    feet = infinite_feet(a, b)
    tries = []
    if feet is not None and all(0.0 <= t <= 1.0 for t in feet):
        tries.append(feet)
    for s in (0.0, 1.0):
        tries.append((s, clamp(b.ClosestParameter(a.PointAt(s)))))
        tries.append((clamp(a.ClosestParameter(b.PointAt(s))), s))
    for s, t in tries:
        gap = a.PointAt(s).DistanceTo(b.PointAt(t))
        if best is None or gap < best[0]:
            best = (gap, s, t)
    return best[1], best[2]


def to_line(value):
    """A Line of a line, or of a pair of points."""
    if isinstance(value, Line):
        return value._copy()
    if isinstance(value, (tuple, list)) and len(value) == 2:
        return Line(value[0], to_point(value[1]))
    raise TypeError("expected Line, got %s" % type(value).__name__)
