"""Circle, Arc and Ellipse."""

import math

from .base import UNSET, Struct, field, is_number, is_set, number, static_value
from .box import BoundingBox
from .interval import Interval, to_interval
from .plane import Plane, to_plane, to_point, to_vector
from .point import Point3d
from .vector import Vector3d

TAU = 2.0 * math.pi


class _Round(Struct):
    """What circles and arcs share: a plane, a radius, points by angle in radians."""

    __slots__ = ()

    def _get_centre(self):
        return self._plane._origin._copy()

    def _set_centre(self, value):
        self._plane.Origin = value

    Center = property(_get_centre, _set_centre)
    Normal = property(lambda self: self._plane._z._copy())
    Diameter = property(lambda self: 2.0 * self._radius, lambda self, value: setattr(self, "_radius", 0.5 * value))

    def PointAt(self, t):
        return self._plane.PointAt(math.cos(t) * self._radius, math.sin(t) * self._radius)

    def _angle_of(self, point):
        u, v, _ = self._plane._local(point)
        angle = math.atan2(v, u) if u or v else 0.0
        return angle + TAU if angle < 0.0 else angle

    def Transform(self, xform):
        edge = self._plane.PointAt(self._radius, 0.0)
        plane = self._plane._copy()
        if not plane.Transform(xform):
            return False
        centre = Point3d(*xform._point(*self._plane._origin._parts()))
        self._radius = centre.DistanceTo(Point3d(*xform._point(*edge._parts())))
        self._plane = plane
        return True

    def Translate(self, delta):
        return self._plane.Translate(delta)

    def Rotate(self, *arguments):
        return self._plane.Rotate(*arguments)

    def ToNurbsCurve(self, *arguments):
        from ..geometry import as_curve, call
        return call(as_curve(self), "ToNurbsCurve", *arguments)


class Circle(_Round):
    """A circle in a plane; its parameter is the angle from the x axis in radians."""

    __slots__ = ("_plane", "_radius")
    _fields = ("_plane", "_radius")

    Plane = field("_plane", to_plane)
    Radius = number("_radius")

    def __init__(self, *arguments):
        plane, radius = Plane.WorldXY, UNSET
        if len(arguments) == 1 and is_number(arguments[0]):
            radius = arguments[0]
        elif len(arguments) == 1:
            plane, radius = arguments[0]._plane, arguments[0]._radius
        elif len(arguments) == 2:
            plane, radius = to_plane(arguments[0]), arguments[1]
        elif len(arguments) == 3 and is_number(arguments[2]):
            plane, radius = to_plane(arguments[0]), arguments[2]
            plane.Origin = arguments[1]
        elif len(arguments) == 3 and isinstance(arguments[1], Vector3d):
            plane, radius = _tangent_circle(*arguments)
        elif len(arguments) == 3:
            plane, radius = _through_three(*map(to_point, arguments))
        elif arguments:
            raise TypeError("Circle() takes a plane or centre and a radius, or three points")
        self._plane, self._radius = plane._copy(), float(radius)

    IsValid = property(lambda self: self._plane.IsValid and is_set(self._radius) and self._radius > 0.0)
    Circumference = property(lambda self: abs(TAU * self._radius),
                             lambda self, value: setattr(self, "_radius", value / TAU))
    BoundingBox = property(lambda self: _disc_box(self._plane, self._radius, self._radius))

    def TangentAt(self, t):
        along = self.DerivativeAt(1, t)
        along.Unitize()
        return along

    def DerivativeAt(self, derivative, t):
        turned = t + derivative * 0.5 * math.pi
        return self._plane._x * (math.cos(turned) * self._radius) + self._plane._y * (math.sin(turned) * self._radius)

    def ClosestParameter(self, testPoint, *place_holders):
        return True, self._angle_of(testPoint)

    def ClosestPoint(self, testPoint):
        return self.PointAt(self._angle_of(testPoint))

    def IsInPlane(self, plane, tolerance):
        return all(abs(plane.ValueAt(self.PointAt(k * TAU / 3.0))) <= tolerance for k in range(3))

    def Reverse(self):
        """Turns the direction around: y and z axis change sign."""
        self._plane._set(self._plane._origin, self._plane._x, -self._plane._y, -self._plane._z)

    @staticmethod
    def TryFitCircleToPoints(points, *place_holders):
        from .fit import circle_of_points
        return circle_of_points([to_point(point) for point in points])

    Unset = static_value(lambda cls: cls(Plane.Unset, UNSET))


def _through_three(a, b, c):
    """Plane and radius of the circle through three points; unset where they are in line."""
    u, v = b - a, c - a
    normal = Vector3d.CrossProduct(u, v)
    square = normal.SquareLength
    if square <= 1e-24 * max(u.SquareLength * v.SquareLength, 1e-300):
        return Plane.Unset, UNSET
    span = Vector3d.CrossProduct(v * u.SquareLength - u * v.SquareLength, normal) * (-0.5 / square)
    centre = a - span if _farther(a, b, c, a - span, a + span) else a + span
    x = a - centre
    return Plane(centre, x, Vector3d.CrossProduct(normal, x)), centre.DistanceTo(a)


def _farther(a, b, c, one, other):
    """Whether the first of two points is the one that is as far from all three."""
    def spread(point):
        far = [point.DistanceTo(corner) for corner in (a, b, c)]
        return max(far) - min(far)
    return spread(one) <= spread(other)


def _tangent_circle(start, tangent, end):
    """The circle from a point along a tangent through another point."""
    start, end, along = to_point(start), to_point(end), to_vector(tangent)
    along.Unitize()
    chord = end - start
    normal = Vector3d.CrossProduct(along, chord)
    if not normal.Unitize():
        return Plane.Unset, UNSET
    inward = Vector3d.CrossProduct(normal, along)
    radius = chord.SquareLength / (2.0 * (chord * inward))
    centre = start + inward * radius
    x = start - centre
    return Plane(centre, x, along), abs(radius)


def _disc_box(plane, rx, ry):
    """The box of an ellipse: in each coordinate sqrt((rx x)^2 + (ry y)^2) to both sides."""
    reach = Vector3d(*[math.hypot(rx * a, ry * b) for a, b in zip(plane._x._parts(), plane._y._parts())])
    return BoundingBox(plane._origin - reach, plane._origin + reach)


class Arc(_Round):
    """A part of a circle, by an interval of angles."""

    __slots__ = ("_plane", "_radius", "_angle")
    _fields = ("_plane", "_radius", "_angle")

    Plane = field("_plane", to_plane)
    Radius = number("_radius")
    AngleDomain = field("_angle", to_interval)

    def __init__(self, *arguments):
        plane, radius, angle = Plane.Unset, UNSET, Interval(0.0, 0.0)
        if len(arguments) == 1:
            plane, radius = arguments[0]._plane, arguments[0]._radius
            angle = getattr(arguments[0], "_angle", Interval(0.0, TAU))
        elif len(arguments) == 2:
            plane, radius, angle = arguments[0]._plane, arguments[0]._radius, to_interval(arguments[1])
        elif len(arguments) == 4:
            plane, radius, angle = to_plane(arguments[0]), arguments[2], to_interval(arguments[3])
            plane.Origin = arguments[1]
        elif len(arguments) == 3 and is_number(arguments[1]):
            plane, radius, angle = to_plane(arguments[0]), arguments[1], to_interval(arguments[2])
        elif len(arguments) == 3 and isinstance(arguments[1], Vector3d):
            plane, radius = _tangent_circle(*arguments)
            angle = Interval(0.0, Circle(plane, radius)._angle_of(arguments[2])) if is_set(radius) else angle
        elif len(arguments) == 3:
            plane, radius, angle = _arc_through(*map(to_point, arguments))
        self._plane, self._radius, self._angle = plane._copy(), float(radius), angle._copy()

    @property
    def IsValid(self):
        return (self._plane.IsValid and is_set(self._radius) and self._radius > 0.0
                and 0.0 < self._angle.Length <= TAU + 1e-12)

    Angle = property(lambda self: self._angle.Length,
                     lambda self, value: setattr(self._angle, "T1", self._angle.T0 + value))
    AngleDegrees = property(lambda self: math.degrees(self.Angle),
                            lambda self, value: setattr(self, "Angle", math.radians(value)))
    StartAngle = property(lambda self: self._angle.T0, lambda self, value: setattr(self._angle, "T0", value))
    EndAngle = property(lambda self: self._angle.T1, lambda self, value: setattr(self._angle, "T1", value))
    StartAngleDegrees = property(lambda self: math.degrees(self.StartAngle),
                                 lambda self, value: setattr(self, "StartAngle", math.radians(value)))
    EndAngleDegrees = property(lambda self: math.degrees(self.EndAngle),
                               lambda self, value: setattr(self, "EndAngle", math.radians(value)))
    StartPoint = property(lambda self: self.PointAt(self._angle.T0))
    MidPoint = property(lambda self: self.PointAt(self._angle.Mid))
    EndPoint = property(lambda self: self.PointAt(self._angle.T1))
    IsCircle = property(lambda self: abs(abs(self.Angle) - TAU) <= 1e-12)
    Length = property(lambda self: abs(self.Angle * self._radius))
    Circumference = property(lambda self: abs(TAU * self._radius))

    def BoundingBox(self):
        """The box of the ends and of those extremes along the axes that lie on the arc."""
        points = [self.StartPoint, self.EndPoint]
        for a, b in zip(self._plane._x._parts(), self._plane._y._parts()):
            top = math.atan2(b, a)
            for turn in range(-3, 4):
                angle = top + turn * math.pi
                if self._angle.IncludesParameter(angle):
                    points.append(self.PointAt(angle))
        return BoundingBox(points)

    def TangentAt(self, t):
        return self._plane._y * math.cos(t) - self._plane._x * math.sin(t)

    def ClosestParameter(self, testPoint):
        angle = self._angle_of(testPoint)
        low, high = self._angle.Min, self._angle.Max
        while angle < low:
            angle += TAU
        while angle - TAU >= low:
            angle -= TAU
        if angle <= high:
            return angle
        # Beyond the end: the nearer end, by the middle of the gap.
        return high if angle - high <= low + TAU - angle else low

    def ClosestPoint(self, testPoint):
        return self.PointAt(self.ClosestParameter(testPoint))

    def Reverse(self):
        """From end to start: the plane turns over and the angles change sign."""
        self._plane._set(self._plane._origin, self._plane._x, -self._plane._y, -self._plane._z)
        self._angle.Reverse()

    def Trim(self, domain):
        span = to_interval(domain)
        if not span.IsIncreasing or span.Length > TAU + 1e-12:
            return False
        self._angle = span
        return True

    Unset = static_value(lambda cls: cls(Plane.Unset, UNSET, 0.0))


def _arc_through(start, inside, end):
    """Plane, radius and angles of the arc from start over a point to end."""
    plane, radius = _through_three(start, inside, end)
    if not is_set(radius):
        return plane, radius, Interval(0.0, 0.0)
    # The plane's x axis goes to the start, and the three points are counter-clockwise about its normal.
    return plane, radius, Interval(0.0, Circle(plane, radius)._angle_of(end))


class Ellipse(Struct):
    """An ellipse in a plane, by its radii along the axes."""

    __slots__ = ("_plane", "_r1", "_r2")
    _fields = ("_plane", "_r1", "_r2")

    Plane = field("_plane", to_plane)
    Radius1 = number("_r1")
    Radius2 = number("_r2")

    def __init__(self, *arguments):
        plane, r1, r2 = Plane.Unset, 0.0, 0.0
        if len(arguments) == 3 and is_number(arguments[1]):
            plane, r1, r2 = to_plane(arguments[0]), arguments[1], arguments[2]
        elif len(arguments) == 3:
            plane = Plane(*map(to_point, arguments))
            r1, r2 = [plane._origin.DistanceTo(to_point(point)) for point in arguments[1:]]
        elif len(arguments) == 1:
            plane, r1 = arguments[0]._plane, getattr(arguments[0], "_radius", None)
            r1, r2 = (r1, r1) if r1 is not None else (arguments[0]._r1, arguments[0]._r2)
        self._plane, self._r1, self._r2 = plane._copy(), float(r1), float(r2)

    IsValid = property(lambda self: self._plane.IsValid and self._r1 > 0.0 and self._r2 > 0.0)
    Center = property(lambda self: self._plane._origin._copy(),
                      lambda self, value: setattr(self._plane, "Origin", value))
    FocalDistance = property(lambda self: math.sqrt(abs(self._r1 ** 2 - self._r2 ** 2)))
    BoundingBox = property(lambda self: _disc_box(self._plane, self._r1, self._r2))

    def GetFoci(self, *place_holders):
        along = (self._plane._x if self._r1 >= self._r2 else self._plane._y) * self.FocalDistance
        return self._plane._origin + along, self._plane._origin - along

    def ToNurbsCurve(self):
        from ..geometry import as_curve, call
        return call(as_curve(self), "ToNurbsCurve")
