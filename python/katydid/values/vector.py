"""Vector3d, Vector2d, Vector3f and Vector2f."""

import math

from .base import DEFAULT_ANGLE_TOLERANCE, SQRT_EPSILON, UNSET, static_value
from .tuples import VectorLike, coordinates, fill

_new = object.__new__


class Vector3d(VectorLike):
    """A direction with a length."""

    __slots__ = ("X", "Y", "Z")
    _fields = ("X", "Y", "Z")

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
        fill(self, arguments)

    @staticmethod
    def _make(x, y, z):
        made = _new(Vector3d)
        _set_x(made, x)
        _set_y(made, y)
        _set_z(made, z)
        return made

    def _parts(self):
        return (self.X, self.Y, self.Z)

    def _copy(self):
        return Vector3d._make(self.X, self.Y, self.Z)

    @staticmethod
    def CrossProduct(a, b):
        ax, ay, az = coordinates(a, 3)
        bx, by, bz = coordinates(b, 3)
        return Vector3d._make(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)

    def Rotate(self, angleRadians, rotationAxis):
        """Turns about an axis through the origin (Rodrigues' formula); False where the axis has no length."""
        axis = Vector3d(rotationAxis)
        if not axis.Unitize():
            return False
        c, s = _turn(angleRadians)
        cross = Vector3d.CrossProduct(axis, self)
        turned = self * c + cross * s + axis * ((axis * self) * (1.0 - c))
        self.X, self.Y, self.Z = turned._parts()
        return True

    def Transform(self, transformation):
        self.X, self.Y, self.Z = transformation._direction(self.X, self.Y, self.Z)

    def IsParallelTo(self, other, angleTolerance=DEFAULT_ANGLE_TOLERANCE):
        """1 parallel, -1 antiparallel, 0 neither."""
        lengths = self.Length * other.Length
        if lengths <= 0.0:
            return 0
        cosine, limit = (self * other) / lengths, math.cos(angleTolerance)
        return 1 if cosine >= limit else -1 if cosine <= -limit else 0

    def IsPerpendicularTo(self, other, angleTolerance=DEFAULT_ANGLE_TOLERANCE):
        lengths = self.Length * other.Length
        return lengths > 0.0 and abs((self * other) / lengths) <= math.sin(angleTolerance)

    def PerpendicularTo(self, *others):
        """Sets this to a perpendicular of a vector, or to the unit normal of three points."""
        if len(others) == 3:
            a, b, c = others
            normal = Vector3d.CrossProduct(b - a, c - a)
            if not normal.Unitize():
                return False
            self.X, self.Y, self.Z = normal._parts()
            return True
        # openNURBS' rule: the two coordinates of largest size change places, one with its sign turned.
        given = coordinates(others[0], 3)
        ax, ay, az = map(abs, given)
        if ay > ax:
            i, j, k = (2, 1, 0) if az > ay else (1, 2, 0) if az >= ax else (1, 0, 2)
        else:
            i, j, k = (2, 0, 1) if az > ax else (0, 2, 1) if az > ay else (0, 1, 2)
        made = [0.0, 0.0, 0.0]
        made[i], made[j] = -given[j], given[i]
        # Adding 0 makes 0 of -0.
        self.X, self.Y, self.Z = (c + 0.0 for c in made)
        return made[i] != 0.0 or made[j] != 0.0

    @staticmethod
    def VectorAngle(a, b, about=None):
        """In radians: 0 to pi, or counter-clockwise in a plane or about a normal, 0 to 2 pi."""
        u, v = Vector3d(a), Vector3d(b)
        if about is not None:
            if hasattr(about, "ZAxis"):
                u, v, normal = _in_plane(u, about), _in_plane(v, about), about.ZAxis
            else:
                normal = Vector3d(about)
        if not (u.Unitize() and v.Unitize()):
            return UNSET
        angle = math.acos(max(-1.0, min(1.0, u * v)))
        if about is not None and Vector3d.CrossProduct(u, v) * normal < 0.0:
            angle = 2.0 * math.pi - angle
        return angle

    @staticmethod
    def AreOrthogonal(x, y, z):
        return max(abs(x * y), abs(y * z), abs(z * x)) <= SQRT_EPSILON and not (x.IsZero or y.IsZero or z.IsZero)

    @staticmethod
    def AreOrthonormal(x, y, z):
        return Vector3d.AreOrthogonal(x, y, z) and x.IsUnitVector and y.IsUnitVector and z.IsUnitVector

    @staticmethod
    def AreRighthanded(x, y, z):
        return Vector3d.AreOrthonormal(x, y, z) and Vector3d.CrossProduct(x, y) * z > 1.0 - SQRT_EPSILON

    XAxis = static_value(lambda cls: cls._make(1.0, 0.0, 0.0))
    YAxis = static_value(lambda cls: cls._make(0.0, 1.0, 0.0))
    ZAxis = static_value(lambda cls: cls._make(0.0, 0.0, 1.0))


_set_x, _set_y, _set_z = (Vector3d.__dict__[name].__set__ for name in "XYZ")


def _turn(angle):
    """Cosine and sine, exact at quarter turns as openNURBS has them."""
    c, s = math.cos(angle), math.sin(angle)
    if abs(s) >= 1.0 - SQRT_EPSILON and abs(c) <= SQRT_EPSILON:
        return 0.0, math.copysign(1.0, s)
    if abs(c) >= 1.0 - SQRT_EPSILON and abs(s) <= SQRT_EPSILON:
        return math.copysign(1.0, c), 0.0
    return c, s


def _in_plane(vector, plane):
    """The part of a vector that lies in a plane."""
    normal = plane.ZAxis
    return vector - normal * (vector * normal)


class Vector2d(VectorLike):
    """A direction in the plane."""

    __slots__ = ("X", "Y")
    _fields = ("X", "Y")

    def __init__(self, *arguments):
        fill(self, arguments)

    def Rotate(self, angleRadians):
        c, s = _turn(angleRadians)
        self.X, self.Y = c * self.X - s * self.Y, s * self.X + c * self.Y
        return True


class Vector3f(VectorLike):
    """A direction in single precision, as mesh normals are."""

    __slots__ = ("X", "Y", "Z")
    _fields = ("X", "Y", "Z")
    _rounded = True

    def __init__(self, *arguments):
        fill(self, arguments)

    @staticmethod
    def CrossProduct(a, b):
        return Vector3f(Vector3d.CrossProduct(a, b))

    def _as_double(self, name, *arguments):
        made = Vector3d(self)
        result = getattr(made, name)(*arguments)
        self.X, self.Y, self.Z = made._parts()
        return result

    def Rotate(self, angleRadians, rotationAxis):
        return self._as_double("Rotate", angleRadians, rotationAxis)

    def PerpendicularTo(self, other):
        return self._as_double("PerpendicularTo", other)

    def Transform(self, transformation):
        return self._as_double("Transform", transformation)

    XAxis = static_value(lambda cls: cls._of(1.0, 0.0, 0.0))
    YAxis = static_value(lambda cls: cls._of(0.0, 1.0, 0.0))
    ZAxis = static_value(lambda cls: cls._of(0.0, 0.0, 1.0))


class Vector2f(VectorLike):
    """A direction in the plane, in single precision."""

    __slots__ = ("X", "Y")
    _fields = ("X", "Y")
    _rounded = True

    def __init__(self, *arguments):
        fill(self, arguments)
