"""Rectangle3d."""

from .base import Struct, field, is_number, static_value
from .box import BoundingBox
from .interval import Interval, to_interval
from .plane import Plane, to_plane, to_point
from .vector import Vector3d


class Rectangle3d(Struct):
    """A rectangle in a plane, by an interval along each axis."""

    __slots__ = ("_plane", "_dx", "_dy")
    _fields = ("_plane", "_dx", "_dy")

    Plane = field("_plane", to_plane)
    X = field("_dx", to_interval)
    Y = field("_dy", to_interval)

    def __init__(self, *arguments):
        if not arguments:
            plane, x, y = Plane.Unset, Interval.Unset, Interval.Unset
        elif len(arguments) == 1:
            plane, x, y = arguments[0]._plane, arguments[0]._dx, arguments[0]._dy
        else:
            plane, a, b = arguments
            plane = to_plane(plane)
            if isinstance(a, Interval) or is_number(a):
                x, y = to_interval(a), to_interval(b)
                if is_number(a):
                    x.MakeIncreasing()
                    y.MakeIncreasing()
            else:
                (u0, v0, _), (u1, v1, _) = plane._local(a), plane._local(b)
                x, y = Interval(min(u0, u1), max(u0, u1)), Interval(min(v0, v1), max(v0, v1))
        self._plane, self._dx, self._dy = plane._copy(), x._copy(), y._copy()

    IsValid = property(lambda self: self._plane.IsValid and self._dx.IsValid and self._dy.IsValid)
    Width = property(lambda self: abs(self._dx.Length))
    Height = property(lambda self: abs(self._dy.Length))
    Area = property(lambda self: self.Width * self.Height)
    Circumference = property(lambda self: 2.0 * (self.Width + self.Height))
    Center = property(lambda self: self._plane.PointAt(self._dx.Mid, self._dy.Mid))
    BoundingBox = property(lambda self: BoundingBox([self.Corner(i) for i in range(4)]))

    def Corner(self, index):
        """Corners in order, from the start of both intervals."""
        if not 0 <= index < 4:
            raise IndexError("a rectangle has the corners 0 to 3, not %d" % index)
        x = self._dx.T0 if index in (0, 3) else self._dx.T1
        y = self._dy.T0 if index in (0, 1) else self._dy.T1
        return self._plane.PointAt(x, y)

    def PointAt(self, *parameters):
        """By one parameter along the boundary (0 to 4, a side each), or by two within the rectangle."""
        if len(parameters) == 2:
            return self._plane.PointAt(self._dx.ParameterAt(parameters[0]), self._dy.ParameterAt(parameters[1]))
        t = max(0.0, min(4.0, parameters[0]))
        side = min(int(t), 3)
        a, b = self.Corner(side), self.Corner((side + 1) % 4)
        return a + (b - a) * (t - side)

    def Contains(self, *point):
        """Inside 1, outside 2, on the boundary 3 (PointContainment)."""
        from .enums import PointContainment
        x, y = point if len(point) == 2 else self._plane._local(point[0])[:2]
        if not (self._dx.IncludesParameter(x) and self._dy.IncludesParameter(y)):
            return PointContainment.Outside
        on = x in (self._dx.T0, self._dx.T1) or y in (self._dy.T0, self._dy.T1)
        return PointContainment.Coincident if on else PointContainment.Inside

    def ClosestPoint(self, point, includeInterior=True):
        u, v, _ = self._plane._local(point)
        x, y = max(self._dx.Min, min(self._dx.Max, u)), max(self._dy.Min, min(self._dy.Max, v))
        if not includeInterior and (x, y) == (u, v):
            gaps = ((x - self._dx.Min, self._dx.Min, y), (self._dx.Max - x, self._dx.Max, y),
                    (y - self._dy.Min, x, self._dy.Min), (self._dy.Max - y, x, self._dy.Max))
            _, x, y = min(gaps)
        return self._plane.PointAt(x, y)

    def MakeIncreasing(self):
        self._dx.MakeIncreasing()
        self._dy.MakeIncreasing()

    def RecenterPlane(self, origin):
        """Moves the plane's origin to a point or a corner; the rectangle stays."""
        point = self.Corner(origin) if isinstance(origin, int) else to_point(origin)
        u, v, _ = self._plane._local(point)
        self._plane.Origin = self._plane.PointAt(u, v)
        for span, by in ((self._dx, u), (self._dy, v)):
            span.T0, span.T1 = span.T0 - by, span.T1 - by

    def Transform(self, xform):
        """Moves, turns and scales; each axis is measured after the change."""
        plane = self._plane._copy()
        if not plane.Transform(xform):
            return False
        for span, axis in ((self._dx, self._plane._x), (self._dy, self._plane._y)):
            length = Vector3d(*xform._direction(*axis._parts())).Length
            span.T0, span.T1 = span.T0 * length, span.T1 * length
        self._plane = plane
        return True

    def ToPolyline(self):
        from .polyline import Polyline
        return Polyline([self.Corner(i % 4) for i in range(5)])

    def ToNurbsCurve(self):
        return self.ToPolyline().ToNurbsCurve()

    @staticmethod
    def CreateFromPolyline(polyline, *place_holders):
        """The rectangle of a polyline's first three corners, with the largest deviations where asked."""
        points = [to_point(point) for point in polyline]
        if len(points) < 4:
            return Rectangle3d.Unset
        plane = Plane(points[0], points[1] - points[0], points[3] - points[0])
        made = Rectangle3d(plane, points[0], points[2])
        if not place_holders:
            return made
        gaps = [made.Corner(i).DistanceTo(points[i]) for i in range(4)]
        return made, max(gaps), 0.0

    Unset = static_value(lambda cls: cls(Plane.Unset, Interval.Unset, Interval.Unset))
