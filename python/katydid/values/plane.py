"""Plane: an origin and three axes."""

import math

from .base import UNSET, ZERO_TOLERANCE, Struct, field, is_number, static_value
from .point import Point3d
from .tuples import coordinates
from .vector import Vector3d


def to_point(value):
    """A new Point3d of anything with coordinates."""
    return Point3d._make(*map(float, coordinates(value, 3)))


def to_vector(value):
    """A new Vector3d of anything with coordinates."""
    return Vector3d._make(*map(float, coordinates(value, 3)))


class Plane(Struct):
    """A frame in space: origin, x, y and z axis."""

    __slots__ = ("_origin", "_x", "_y", "_z")
    _fields = ("_origin", "_x", "_y", "_z")

    Origin = field("_origin", to_point)
    XAxis = field("_x", to_vector)
    YAxis = field("_y", to_vector)
    ZAxis = field("_z", to_vector)

    def __init__(self, *arguments):
        if len(arguments) == 4 and is_number(arguments[0]):
            self._from_equation(*map(float, arguments))
        elif not arguments:
            self._set(Point3d(), Vector3d.Zero, Vector3d.Zero, Vector3d.Zero)
        elif len(arguments) == 1:
            other = to_plane(arguments[0])
            self._set(other._origin, other._x, other._y, other._z)
        elif len(arguments) == 2:
            self._from_normal(*arguments)
        elif len(arguments) == 3:
            origin, a, b = arguments
            if not isinstance(a, Vector3d):
                # Three points: the axes go from the origin to the two others.
                a, b = to_point(a) - to_point(origin), to_point(b) - to_point(origin)
            self._from_frame(origin, a, b)
        else:
            raise TypeError("Plane() takes an origin and a normal, two axes or two points")

    @classmethod
    def _of(cls, numbers):
        """A plane of 12 floats, as they are."""
        made = object.__new__(cls)
        made._set(Point3d._make(*numbers[0:3]), Vector3d._make(*numbers[3:6]), Vector3d._make(*numbers[6:9]),
                  Vector3d._make(*numbers[9:12]))
        return made

    def _set(self, origin, x, y, z):
        for slot, value in zip(self._fields, (origin, x, y, z)):
            object.__setattr__(self, slot, value._copy())

    def _numbers(self):
        return self._origin._parts() + self._x._parts() + self._y._parts() + self._z._parts()

    def _from_normal(self, origin, normal):
        z, x = to_vector(normal), Vector3d()
        z.Unitize()
        x.PerpendicularTo(z)
        x.Unitize()
        y = Vector3d.CrossProduct(z, x)
        y.Unitize()
        self._set(to_point(origin), x, y, z)

    def _from_frame(self, origin, x, y):
        x, y = to_vector(x), to_vector(y)
        x.Unitize()
        y = y - x * (x * y)
        y.Unitize()
        z = Vector3d.CrossProduct(x, y)
        z.Unitize()
        self._set(to_point(origin), x, y, z)

    def _from_equation(self, a, b, c, d):
        normal = Vector3d(a, b, c)
        length = normal.Length
        scale = -d / (length * length) if length > 0.0 else 0.0
        self._from_normal(Point3d(normal * scale), normal)

    CreateFromNormal = classmethod(lambda cls, origin, normal: cls(origin, to_vector(normal)))
    CreateFromFrame = classmethod(lambda cls, origin, x, y: cls(origin, to_vector(x), to_vector(y)))
    CreateFromPoints = classmethod(lambda cls, origin, x, y: cls(origin, to_point(x), to_point(y)))

    @classmethod
    def CreateFromNormalYup(cls, origin, normal, yDirection):
        """The y axis is the given direction, made square to the normal."""
        z, y = to_vector(normal), to_vector(yDirection)
        z.Unitize()
        y = y - z * (z * y)
        if not y.Unitize():
            return cls(origin, z)
        return cls(origin, Vector3d.CrossProduct(y, z), y)

    @property
    def Normal(self):
        return self._z._copy()

    OriginX = property(lambda self: self._origin.X, lambda self, value: setattr(self._origin, "X", value))
    OriginY = property(lambda self: self._origin.Y, lambda self, value: setattr(self._origin, "Y", value))
    OriginZ = property(lambda self: self._origin.Z, lambda self, value: setattr(self._origin, "Z", value))

    @property
    def IsValid(self):
        return self._origin.IsValid and Vector3d.AreRighthanded(self._x, self._y, self._z)

    def GetPlaneEquation(self):
        """a, b, c, d of ax + by + cz + d = 0."""
        return [self._z.X, self._z.Y, self._z.Z, -(self._z * self._origin)]

    def UpdateEquation(self):
        return self.IsValid

    def ValueAt(self, p):
        return self._z * (to_point(p) - self._origin)

    def PointAt(self, u, v, w=0.0):
        o, x, y, z = self._origin, self._x, self._y, self._z
        return Point3d._make(o.X + u * x.X + v * y.X + w * z.X, o.Y + u * x.Y + v * y.Y + w * z.Y,
                             o.Z + u * x.Z + v * y.Z + w * z.Z)

    def _local(self, point):
        span = to_point(point) - self._origin
        return span * self._x, span * self._y, span * self._z

    def ClosestParameter(self, testPoint, *place_holders):
        u, v, _ = self._local(testPoint)
        return True, u, v

    def ClosestPoint(self, testPoint):
        u, v, _ = self._local(testPoint)
        return self.PointAt(u, v)

    def RemapToPlaneSpace(self, ptSample, *place_holders):
        return True, Point3d(*self._local(ptSample))

    def DistanceTo(self, testPoint, *place_holders):
        """The signed distance of a point; of a box: (True, least, largest)."""
        if hasattr(testPoint, "GetCorners"):
            found = [self.ValueAt(corner) for corner in testPoint.GetCorners()]
            return True, min(found), max(found)
        return self.ValueAt(testPoint)

    def IsCoplanar(self, plane, tolerance=ZERO_TOLERANCE):
        same = self._z.IsParallelTo(plane._z, 1e-6 if tolerance < 1e-6 else tolerance) != 0
        return same and abs(self.ValueAt(plane._origin)) <= tolerance

    def Flip(self):
        """Turns the normal around: the x and y axes change places."""
        self._set(self._origin, self._y, self._x, -self._z)

    def Translate(self, delta):
        object.__setattr__(self, "_origin", self._origin + to_vector(delta))
        return True

    def Rotate(self, *arguments):
        """(angle, axis[, centre]) or (sine, cosine, axis[, centre]): without a centre about the plane's origin."""
        if is_number(arguments[1]):
            angle, rest = math.atan2(arguments[0], arguments[1]), arguments[2:]
        else:
            angle, rest = arguments[0], arguments[1:]
        axis = to_vector(rest[0])
        for vector in (self._x, self._y, self._z):
            if not vector.Rotate(angle, axis):
                return False
        if len(rest) > 1:
            centre = to_point(rest[1])
            span = self._origin - centre
            span.Rotate(angle, axis)
            object.__setattr__(self, "_origin", centre + span)
        return True

    def Transform(self, xform):
        """Moves the plane: the axes follow and are made square again."""
        origin = Point3d(self._origin)
        origin.Transform(xform)
        x, y = self._x._copy(), self._y._copy()
        x.Transform(xform)
        y.Transform(xform)
        self._from_frame(origin, x, y)
        return self.IsValid

    def ExtendThroughBox(self, box, *place_holders):
        """The intervals in x and y that a box covers, as seen along the normal."""
        from .interval import Interval
        found = [self._local(corner) for corner in box.GetCorners()]
        if not found:
            return False, Interval.Unset, Interval.Unset
        us, vs = [f[0] for f in found], [f[1] for f in found]
        return True, Interval(min(us), max(us)), Interval(min(vs), max(vs))

    @staticmethod
    def FitPlaneToPoints(points, *place_holders):
        """The plane of least squares: (result, plane) with result Success, or with a place holder the deviation too."""
        from .fit import plane_of_points
        return plane_of_points([to_point(point) for point in points], bool(place_holders))

    def ToString(self, *format_and_culture):
        return "Origin=%s XAxis=%s, YAxis=%s, ZAxis=%s" % (self._origin, self._x, self._y, self._z)

    WorldXY = static_value(lambda cls: cls._of((0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)))
    WorldYZ = static_value(lambda cls: cls._of((0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0)))
    WorldZX = static_value(lambda cls: cls._of((0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0)))
    Unset = static_value(lambda cls: cls._of((UNSET,) * 12))


def to_plane(value):
    """A Plane of a plane, a point (parallel to XY), or (origin, x, y) in a sequence."""
    if isinstance(value, Plane):
        return value._copy()
    if isinstance(value, (tuple, list)) and len(value) in (2, 3) and not is_number(value[0]):
        return Plane(*[value[0]] + [to_vector(axis) for axis in value[1:]])
    found = getattr(value, "Plane", None)
    if isinstance(found, Plane):
        return found
    made = Plane.WorldXY
    made.Origin = to_point(value)
    return made
