"""Quaternion: a + bi + cj + dk."""

import math

from .base import ZERO_TOLERANCE, Struct, is_number, is_set, number, static_value
from .plane import Plane, to_plane, to_vector
from .point import Point3d
from .vector import Vector3d


class Quaternion(Struct):
    """A rotation when its length is 1."""

    __slots__ = ("_a", "_b", "_c", "_d")
    _fields = ("_a", "_b", "_c", "_d")

    A = number("_a")
    B = number("_b")
    C = number("_c")
    D = number("_d")

    def __init__(self, a=0.0, b=0.0, c=0.0, d=0.0):
        self.Set(a, b, c, d)

    def Set(self, a, b, c, d):
        self._a, self._b, self._c, self._d = float(a), float(b), float(c), float(d)

    IsValid = property(lambda self: all(map(is_set, self._parts())))
    IsZero = property(lambda self: not any(self._parts()))
    IsScalar = property(lambda self: not any(self._parts()[1:]))
    IsVector = property(lambda self: self._a == 0.0 and any(self._parts()[1:]))
    LengthSquared = property(lambda self: sum(part * part for part in self._parts()))
    Length = property(lambda self: math.sqrt(self.LengthSquared))
    Conjugate = property(lambda self: Quaternion(self._a, -self._b, -self._c, -self._d))
    Scalar = property(lambda self: self._a)
    Vector = property(lambda self: Vector3d(self._b, self._c, self._d))

    @property
    def Inverse(self):
        square = self.LengthSquared
        return self.Conjugate / square if square > 0.0 else Quaternion.Zero

    def Invert(self):
        square = self.LengthSquared
        if square <= 0.0:
            return False
        self.Set(*self.Inverse._parts())
        return True

    def Unitize(self):
        length = self.Length
        if length <= ZERO_TOLERANCE:
            return False
        self.Set(*(self / length)._parts())
        return True

    def __add__(self, other):
        return Quaternion(*[a + b for a, b in zip(self._parts(), other._parts())])

    def __sub__(self, other):
        return Quaternion(*[a - b for a, b in zip(self._parts(), other._parts())])

    def __neg__(self):
        return self * -1.0

    def __mul__(self, other):
        if is_number(other):
            return Quaternion(*[part * other for part in self._parts()])
        (a, b, c, d), (e, f, g, h) = self._parts(), other._parts()
        return Quaternion(a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g,
                          a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e)

    __rmul__ = __mul__

    def __truediv__(self, other):
        return Quaternion(*[part / other for part in self._parts()])

    def DistanceTo(self, q):
        return (q - self).Length

    @staticmethod
    def Distance(p, q):
        return (q - p).Length

    @staticmethod
    def Product(p, q):
        return p * q

    @staticmethod
    def CrossProduct(p, q):
        cross = Vector3d.CrossProduct(p.Vector, q.Vector)
        return Quaternion(0.0, cross.X, cross.Y, cross.Z)

    def Rotate(self, v):
        """q v q*, for the unit quaternion in this direction."""
        turned = self * Quaternion(0.0, *to_vector(v)._parts()) * self.Inverse
        return turned.Vector

    @staticmethod
    def Rotation(first, second):
        """(angle, axis), or (plane, plane)."""
        made = Quaternion()
        made.SetRotation(first, second)
        return made

    def SetRotation(self, first, second):
        if is_number(first):
            axis = to_vector(second)
            axis.Unitize()
            s = math.sin(0.5 * first)
            self.Set(math.cos(0.5 * first), s * axis.X, s * axis.Y, s * axis.Z)
            return
        from .transform import Transform
        _, made = Quaternion._of_matrix(Transform.PlaneToPlane(_at_zero(first), _at_zero(second)))
        self.Set(*made._parts())

    @staticmethod
    def _of_matrix(xform):
        """(True, quaternion) of a rotation's matrix (S. Shepperd, 1978: the largest of four square roots)."""
        m = xform
        columns = m._columns()
        if not Vector3d.AreRighthanded(*columns):
            return False, Quaternion.Zero
        trace = m.M00 + m.M11 + m.M22
        sizes = (trace, m.M00, m.M11, m.M22)
        largest = sizes.index(max(sizes))
        if largest == 0:
            s = 2.0 * math.sqrt(1.0 + trace)
            made = Quaternion(0.25 * s, (m.M21 - m.M12) / s, (m.M02 - m.M20) / s, (m.M10 - m.M01) / s)
        elif largest == 1:
            s = 2.0 * math.sqrt(1.0 + m.M00 - m.M11 - m.M22)
            made = Quaternion((m.M21 - m.M12) / s, 0.25 * s, (m.M01 + m.M10) / s, (m.M02 + m.M20) / s)
        elif largest == 2:
            s = 2.0 * math.sqrt(1.0 + m.M11 - m.M00 - m.M22)
            made = Quaternion((m.M02 - m.M20) / s, (m.M01 + m.M10) / s, 0.25 * s, (m.M12 + m.M21) / s)
        else:
            s = 2.0 * math.sqrt(1.0 + m.M22 - m.M00 - m.M11)
            made = Quaternion((m.M10 - m.M01) / s, (m.M02 + m.M20) / s, (m.M12 + m.M21) / s, 0.25 * s)
        return True, made

    def _matrix(self):
        """The rotation about the origin, of this quaternion made a unit."""
        from .transform import Transform
        unit = Quaternion(*self._parts())
        if not unit.Unitize():
            return Transform.Unset
        images = [unit.Rotate(axis) for axis in (Vector3d.XAxis, Vector3d.YAxis, Vector3d.ZAxis)]
        rows = zip(*[image._parts() for image in images])
        return Transform._of([n for row in rows for n in list(row) + [0.0]] + [0.0, 0.0, 0.0, 1.0])

    def GetRotation(self, *place_holders):
        """(True, angle, axis); with a Plane or Transform as a place holder (True, plane) or (True, transform)."""
        from .transform import Transform
        unit = Quaternion(*self._parts())
        if not unit.Unitize():
            return False, 0.0, Vector3d.Zero
        kind = place_holders[0] if place_holders else None
        if kind is Transform or isinstance(kind, Transform):
            return True, unit._matrix()
        if kind is Plane or isinstance(kind, Plane):
            return True, Plane(Point3d.Origin, unit.Rotate(Vector3d.XAxis), unit.Rotate(Vector3d.YAxis))
        axis = unit.Vector
        sine = axis.Length
        axis.Unitize()
        return True, 2.0 * math.atan2(sine, unit._a), axis

    def MatrixForm(self):
        """The matrix of multiplication from the left."""
        from .transform import Transform
        a, b, c, d = self._parts()
        return Transform._of((a, -b, -c, -d, b, a, -d, c, c, d, a, -b, d, -c, b, a))

    def GetYawPitchRoll(self, *place_holders):
        return self._matrix().GetYawPitchRoll()

    @staticmethod
    def CreateFromRotationZYX(yaw, pitch, roll):
        turns = ((yaw, Vector3d.ZAxis), (pitch, Vector3d.YAxis), (roll, Vector3d.XAxis))
        z, y, x = [Quaternion.Rotation(angle, axis) for angle, axis in turns]
        return z * y * x

    @staticmethod
    def CreateFromRotationZYZ(alpha, beta, gamma):
        turns = ((alpha, Vector3d.ZAxis), (beta, Vector3d.YAxis), (gamma, Vector3d.ZAxis))
        a, b, c = [Quaternion.Rotation(angle, axis) for angle, axis in turns]
        return a * b * c

    @staticmethod
    def Lerp(a, b, t):
        return a * (1.0 - t) + b * t

    @staticmethod
    def Slerp(a, b, t):
        """Along the shorter great circle (K. Shoemake, 1985)."""
        a, b = a / a.Length, b / b.Length
        cosine = sum(p * q for p, q in zip(a._parts(), b._parts()))
        if cosine < 0.0:
            b, cosine = b * -1.0, -cosine
        angle = math.acos(min(1.0, cosine))
        if angle < 1e-9:
            made = Quaternion.Lerp(a, b, t)
        else:
            made = (a * math.sin((1.0 - t) * angle) + b * math.sin(t * angle)) * (1.0 / math.sin(angle))
        made.Unitize()
        return made

    @staticmethod
    def RotateTowards(a, b, maxRadians):
        p, q = a / a.Length, b / b.Length
        angle = 2.0 * math.acos(min(1.0, abs(sum(x * y for x, y in zip(p._parts(), q._parts())))))
        return Quaternion(*b._parts()) if angle <= maxRadians else Quaternion.Slerp(a, b, maxRadians / angle)

    Zero = static_value(lambda cls: cls())
    Identity = static_value(lambda cls: cls(1.0))
    I = static_value(lambda cls: cls(0.0, 1.0))  # noqa: E741
    J = static_value(lambda cls: cls(0.0, 0.0, 1.0))
    K = static_value(lambda cls: cls(0.0, 0.0, 0.0, 1.0))


def _at_zero(plane):
    moved = to_plane(plane)
    moved.Origin = Point3d.Origin
    return moved
