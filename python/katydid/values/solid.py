"""Sphere, Cylinder, Cone and Torus."""

import math

from .base import UNSET, Struct, field, is_set, number, static_value
from .box import BoundingBox
from .circle import Circle
from .line import Line
from .plane import Plane, to_plane, to_point
from .vector import Vector3d


class _Solid(Struct):
    """What the four share: they become geometry by the host's makers, `Brep.CreateFromSphere` and its kin."""

    __slots__ = ()

    def _to(self, cls, *arguments):
        from ..geometry import static_call
        return static_call(cls, "CreateFrom" + type(self).__name__, self, *arguments)

    def ToBrep(self, *arguments):
        return self._to("Brep", *arguments)

    def ToNurbsSurface(self):
        return self._to("NurbsSurface")

    def ToRevSurface(self):
        return self._to("RevSurface")


class Sphere(_Solid):
    """A sphere with its equator's plane."""

    __slots__ = ("_plane", "_radius")
    _fields = ("_plane", "_radius")

    EquatorialPlane = field("_plane", to_plane)
    EquitorialPlane = EquatorialPlane
    Radius = number("_radius")

    def __init__(self, *arguments):
        if len(arguments) == 2:
            self._plane, self._radius = to_plane(arguments[0]), float(arguments[1])
        elif len(arguments) == 1:
            self._plane, self._radius = arguments[0]._plane._copy(), arguments[0]._radius
        else:
            self._plane, self._radius = Plane(), 0.0

    IsValid = property(lambda self: self._plane.IsValid and is_set(self._radius) and self._radius > 0.0)
    Center = property(lambda self: self._plane._origin._copy(),
                      lambda self, value: setattr(self._plane, "Origin", value))
    Diameter = property(lambda self: 2.0 * self._radius, lambda self, value: setattr(self, "_radius", 0.5 * value))
    NorthPole = property(lambda self: self._plane.PointAt(0.0, 0.0, self._radius))
    SouthPole = property(lambda self: self._plane.PointAt(0.0, 0.0, -self._radius))

    @property
    def BoundingBox(self):
        reach = Vector3d(self._radius, self._radius, self._radius)
        return BoundingBox(self._plane._origin - reach, self._plane._origin + reach)

    def NormalAt(self, longitudeRadians, latitudeRadians):
        ring = math.cos(latitudeRadians)
        p = self._plane
        return (p._x * (ring * math.cos(longitudeRadians)) + p._y * (ring * math.sin(longitudeRadians))
                + p._z * math.sin(latitudeRadians))

    def PointAt(self, longitudeRadians, latitudeRadians):
        return self._plane._origin + self.NormalAt(longitudeRadians, latitudeRadians) * self._radius

    def ClosestParameter(self, testPoint, *place_holders):
        u, v, w = self._plane._local(testPoint)
        longitude = math.atan2(v, u) if u or v else 0.0
        if longitude < 0.0:
            longitude += 2.0 * math.pi
        return bool(u or v or w), longitude, math.atan2(w, math.hypot(u, v)) if u or v or w else 0.0

    def ClosestPoint(self, testPoint):
        span = to_point(testPoint) - self._plane._origin
        if not span.Unitize():
            span = self._plane._x
        return self._plane._origin + span * self._radius

    def LatitudeRadians(self, radians):
        ring = self._plane._copy()
        ring.Origin = self._plane.PointAt(0.0, 0.0, self._radius * math.sin(radians))
        return Circle(ring, self._radius * math.cos(radians))

    def LatitudeDegrees(self, degrees):
        return self.LatitudeRadians(math.radians(degrees))

    def LongitudeRadians(self, radians):
        along = self.NormalAt(radians, 0.0)
        return Circle(Plane(self._plane._origin, along, self._plane._z), self._radius)

    def LongitudeDegrees(self, degrees):
        return self.LongitudeRadians(math.radians(degrees))

    def Translate(self, delta):
        return self._plane.Translate(delta)

    def Rotate(self, *arguments):
        return self._plane.Rotate(*arguments)

    def Transform(self, xform):
        round_ = Circle(self._plane, self._radius)
        if not round_.Transform(xform):
            return False
        self._plane, self._radius = round_._plane, round_._radius
        return True

    @staticmethod
    def FitSphereToPoints(points):
        from .fit import sphere_of_points
        return sphere_of_points([to_point(point) for point in points])

    Unset = static_value(lambda cls: cls(Plane.Unset, UNSET))


class Cylinder(_Solid):
    """A cylinder on a circle, between two heights; without heights it has no ends."""

    __slots__ = ("_plane", "_radius", "_h1", "_h2")
    _fields = ("_plane", "_radius", "_h1", "_h2")

    BasePlane = field("_plane", to_plane)
    Radius = number("_radius")
    Height1 = number("_h1")
    Height2 = number("_h2")

    def __init__(self, baseCircle=None, height=0.0):
        self._plane = baseCircle._plane._copy() if baseCircle is not None else Plane.Unset
        self._radius = baseCircle._radius if baseCircle is not None else UNSET
        self._h1, self._h2 = (0.0, float(height)) if height >= 0.0 else (float(height), 0.0)

    IsValid = property(lambda self: self._plane.IsValid and is_set(self._radius) and self._radius > 0.0)
    IsFinite = property(lambda self: self._h1 != self._h2)
    TotalHeight = property(lambda self: self._h2 - self._h1)
    Axis = property(lambda self: self._plane._z._copy())
    Center = property(lambda self: self._plane._origin._copy())

    def CircleAt(self, linearParameter):
        base = self._plane._copy()
        base.Origin = self._plane.PointAt(0.0, 0.0, linearParameter)
        return Circle(base, self._radius)

    def LineAt(self, angularParameter):
        x, y = self._radius * math.cos(angularParameter), self._radius * math.sin(angularParameter)
        return Line(self._plane.PointAt(x, y, self._h1), self._plane.PointAt(x, y, self._h2))

    def Transform(self, xform):
        base, top = self.CircleAt(self._h1), self.CircleAt(self._h2)
        if not (base.Transform(xform) and top.Transform(xform)):
            return False
        height = base.Center.DistanceTo(top.Center)
        self._plane, self._radius, self._h1, self._h2 = base._plane, base._radius, 0.0, height
        return True

    Unset = static_value(lambda cls: cls())


class Cone(_Solid):
    """A cone with its apex at the plane's origin, open along the z axis."""

    __slots__ = ("_plane", "_height", "_radius")
    _fields = ("_plane", "_height", "_radius")

    Plane = field("_plane", to_plane)
    Height = number("_height")
    Radius = number("_radius")

    def __init__(self, plane=None, height=UNSET, radius=UNSET):
        self._plane = to_plane(plane) if plane is not None else Plane.Unset
        self._height, self._radius = float(height), float(radius)

    IsValid = property(lambda self: self._plane.IsValid and self._height != 0.0 and self._radius > 0.0)
    ApexPoint = property(lambda self: self._plane._origin._copy())
    BasePoint = property(lambda self: self._plane.PointAt(0.0, 0.0, self._height))
    Axis = property(lambda self: self._plane._z._copy())

    def AngleInRadians(self):
        return math.atan(self._radius / self._height) if self._height else math.copysign(math.pi / 2, self._radius)

    def AngleInDegrees(self):
        return math.degrees(self.AngleInRadians())

    Unset = static_value(lambda cls: cls())


class Torus(_Solid):
    """A torus about a plane's normal."""

    __slots__ = ("_plane", "_major", "_minor")
    _fields = ("_plane", "_major", "_minor")

    Plane = field("_plane", to_plane)
    MajorRadius = number("_major")
    MinorRadius = number("_minor")

    def __init__(self, basePlane=None, majorRadius=UNSET, minorRadius=UNSET):
        self._plane = to_plane(basePlane) if basePlane is not None else Plane.Unset
        self._major, self._minor = float(majorRadius), float(minorRadius)

    IsValid = property(lambda self: self._plane.IsValid and 0.0 < self._minor < self._major)
    Unset = static_value(lambda cls: cls())
