"""Transform: a matrix of four rows and four columns that acts on points as columns."""

import math

from .base import SQRT_EPSILON, UNSET, ZERO_TOLERANCE, Struct, is_number, static_value
from .plane import Plane, to_plane, to_point, to_vector
from .point import Point3d
from .vector import Vector3d, _turn

_IDENTITY = (1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0)


class Transform(Struct):
    """A transformation of space; `a * b` does b first."""

    __slots__ = ("_m",)
    _fields = ("_m",)

    def __init__(self, value=0.0):
        if isinstance(value, Transform):
            self._m = list(value._m)
        else:
            d = float(value)
            self._m = [d, 0.0, 0.0, 0.0, 0.0, d, 0.0, 0.0, 0.0, 0.0, d, 0.0, 0.0, 0.0, 0.0, 1.0 if value else 0.0]

    @classmethod
    def _of(cls, numbers):
        made = object.__new__(cls)
        made._m = [float(number) for number in numbers]
        if len(made._m) != 16:
            raise ValueError("a Transform has 16 numbers")
        return made

    def _parts(self):
        return (tuple(self._m),)

    def _copy(self):
        return Transform._of(self._m)

    def __reduce__(self):
        return (Transform._of, (list(self._m),))

    def __getitem__(self, index):
        row, column = index
        return self._m[4 * row + column]

    def __setitem__(self, index, value):
        row, column = index
        self._m[4 * row + column] = float(value)

    # What acts on coordinates.
    def _point(self, x, y, z):
        m = self._m
        w = m[12] * x + m[13] * y + m[14] * z + m[15]
        w = 1.0 / w if w != 0.0 else 1.0
        if w == 1.0:
            return (m[0] * x + m[1] * y + m[2] * z + m[3], m[4] * x + m[5] * y + m[6] * z + m[7],
                    m[8] * x + m[9] * y + m[10] * z + m[11])
        return (w * (m[0] * x + m[1] * y + m[2] * z + m[3]), w * (m[4] * x + m[5] * y + m[6] * z + m[7]),
                w * (m[8] * x + m[9] * y + m[10] * z + m[11]))

    def _direction(self, x, y, z):
        m = self._m
        return (m[0] * x + m[1] * y + m[2] * z, m[4] * x + m[5] * y + m[6] * z, m[8] * x + m[9] * y + m[10] * z)

    def __mul__(self, other):
        if isinstance(other, Transform):
            a, b = self._m, other._m
            return Transform._of([sum(a[4 * i + k] * b[4 * k + j] for k in range(4))
                                  for i in range(4) for j in range(4)])
        if isinstance(other, Vector3d):
            return Vector3d(*self._direction(*other._parts()))
        if isinstance(other, Point3d):
            return Point3d(*self._point(*other._parts()))
        return NotImplemented

    Multiply = staticmethod(lambda a, b: a * b)

    def TransformList(self, points):
        return [Point3d(*self._point(*to_point(point)._parts())) for point in points]

    def TransformBoundingBox(self, bbox):
        box = bbox._copy()
        box.Transform(self)
        return box

    # Makers.
    @staticmethod
    def Translation(*motion):
        x, y, z = motion if len(motion) == 3 else to_vector(motion[0])._parts()
        return Transform._of((1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1))

    @staticmethod
    def Diagonal(*diagonal):
        x, y, z = diagonal if len(diagonal) == 3 else to_vector(diagonal[0])._parts()
        return Transform._of((x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1))

    @staticmethod
    def Scale(anchor, *factors):
        """(point, factor) or (plane, x, y, z)."""
        plane = to_plane(anchor)
        x, y, z = factors if len(factors) == 3 else (factors[0],) * 3
        if len(factors) == 1:
            plane = Plane(plane._origin, Vector3d.XAxis, Vector3d.YAxis)
        return _in_frame(plane, Transform.Diagonal(x, y, z))

    @staticmethod
    def Rotation(*arguments):
        """(angle, centre), (angle, axis, centre), (sine, cosine, axis, centre), (from, to, centre), or six axes."""
        if len(arguments) == 6:
            start, end = arguments[:3], arguments[3:]
            rows = [[to_vector(v)._parts() for v in axes] for axes in (start, end)]
            numbers = [sum(rows[1][k][i] * rows[0][k][j] for k in range(3)) for i in range(3) for j in range(3)]
            return _of_linear(numbers)
        if is_number(arguments[0]) and len(arguments) == 4:
            return _about(arguments[0], arguments[1], arguments[2], arguments[3])
        if is_number(arguments[0]):
            c, s = _turn(float(arguments[0]))
            axis = arguments[1] if len(arguments) == 3 else Vector3d.ZAxis
            return _about(s, c, axis, arguments[-1])
        start, end = to_vector(arguments[0]), to_vector(arguments[1])
        if not (start.Unitize() and end.Unitize()):
            return Transform.Unset
        axis = Vector3d.CrossProduct(start, end)
        sine, cosine = axis.Length, start * end
        if sine <= SQRT_EPSILON:
            # Parallel directions: no turn, or half a turn about any perpendicular.
            axis, sine, cosine = Vector3d(), 0.0, math.copysign(1.0, cosine)
            axis.PerpendicularTo(start)
        return _about(sine, cosine, axis, arguments[2])

    @staticmethod
    def RotationZYX(yaw, pitch, roll):
        turns = ((yaw, Vector3d.ZAxis), (pitch, Vector3d.YAxis), (roll, Vector3d.XAxis))
        z, y, x = [Transform.Rotation(angle, axis, Point3d.Origin) for angle, axis in turns]
        return z * y * x

    @staticmethod
    def RotationZYZ(alpha, beta, gamma):
        turns = ((alpha, Vector3d.ZAxis), (beta, Vector3d.YAxis), (gamma, Vector3d.ZAxis))
        a, b, c = [Transform.Rotation(angle, axis, Point3d.Origin) for angle, axis in turns]
        return a * b * c

    @staticmethod
    def Mirror(plane, normal=None):
        """In a plane, or in the plane of a point and a normal."""
        if normal is not None:
            plane = Plane(to_point(plane), to_vector(normal))
        return _in_frame(to_plane(plane), Transform.Diagonal(1, 1, -1))

    @staticmethod
    def PlanarProjection(plane):
        return _in_frame(to_plane(plane), Transform.Diagonal(1, 1, 0))

    @staticmethod
    def ProjectAlong(plane, direction):
        """Moves points along a direction into a plane."""
        plane, d = to_plane(plane), to_vector(direction)
        along = d * plane._z
        if abs(along) <= ZERO_TOLERANCE:
            return Transform.Unset
        n, offset = plane._z._parts(), plane._z * plane._origin
        numbers = []
        for i, part in enumerate(d._parts()):
            numbers += [(1.0 if i == j else 0.0) - part * n[j] / along for j in range(3)] + [part * offset / along]
        return Transform._of(numbers + [0, 0, 0, 1])

    @staticmethod
    def Shear(plane, x, y, z):
        frame = to_plane(plane)
        columns = [to_vector(v)._parts() for v in (x, y, z)]
        # The images of the plane's axes, in the plane's own coordinates.
        local = [[Vector3d(*column) * axis for axis in (frame._x, frame._y, frame._z)] for column in columns]
        return _in_frame(frame, _of_linear([local[j][i] for i in range(3) for j in range(3)]))

    @staticmethod
    def PlaneToPlane(plane0, plane1):
        a, b = to_plane(plane0), to_plane(plane1)
        return _to_world(b) * _from_world(a)

    @staticmethod
    def ChangeBasis(*arguments):
        """Coordinates in one frame to coordinates in another: of two planes."""
        if len(arguments) == 2:
            return _from_world(to_plane(arguments[1])) * _to_world(to_plane(arguments[0]))
        if len(arguments) == 6:
            arguments = (Point3d(),) + arguments[:3] + (Point3d(),) + arguments[3:]
        start = _frame_matrix(arguments[0], *arguments[1:4])
        found, end = _frame_matrix(arguments[4], *arguments[5:8]).TryGetInverse()
        return end * start if found else Transform.Unset

    # What it is.
    @property
    def Determinant(self):
        m = self._m
        a, b, c, d = m[0:4], m[4:8], m[8:12], m[12:16]
        return sum((-1) ** j * a[j] * _minor(b, c, d, j) for j in range(4))

    def TryGetInverse(self, *place_holders):
        """(True, inverse), or (False, unset): Gauss-Jordan elimination with pivots."""
        rows = [list(self._m[4 * i:4 * i + 4]) + [float(i == j) for j in range(4)] for i in range(4)]
        largest = max(abs(v) for v in self._m) or 1.0
        for i in range(4):
            pivot = max(range(i, 4), key=lambda r: abs(rows[r][i]))
            if abs(rows[pivot][i]) <= 1e-15 * largest:
                return False, Transform.Unset
            rows[i], rows[pivot] = rows[pivot], rows[i]
            rows[i] = [v / rows[i][i] for v in rows[i]]
            for r in range(4):
                if r != i and rows[r][i]:
                    rows[r] = [v - rows[r][i] * w for v, w in zip(rows[r], rows[i])]
        return True, Transform._of([v for row in rows for v in row[4:]])

    def Transpose(self):
        return Transform._of([self._m[4 * j + i] for i in range(4) for j in range(4)])

    IsValid = property(lambda self: all(-1e300 < v < 1e300 for v in self._m))
    IsIdentity = property(lambda self: all(abs(a - b) <= ZERO_TOLERANCE for a, b in zip(self._m, _IDENTITY)))
    IsZero4x4 = property(lambda self: not any(self._m))
    IsZero = property(lambda self: not any(self._m[:15]))
    IsZeroTransformation = property(lambda self: not any(self._m[:15]) and self._m[15] == 1.0)
    IsAffine = property(lambda self: self._m[12:] == [0.0, 0.0, 0.0, 1.0] and self.IsValid)
    IsLinear = property(lambda self: self.IsAffine and self._m[3] == self._m[7] == self._m[11] == 0.0)

    def IsZeroTransformationWithTolerance(self, zeroTolerance):
        return all(abs(v) <= zeroTolerance for v in self._m[:15]) and abs(self._m[15] - 1.0) <= zeroTolerance

    def _columns(self):
        return [Vector3d(self._m[j], self._m[4 + j], self._m[8 + j]) for j in range(3)]

    @property
    def IsRotation(self):
        return self.IsLinear and Vector3d.AreRighthanded(*self._columns())

    def IsRigid(self, tolerance):
        """1 rotation with a move, -1 with a reflection, 0 neither."""
        return self._similar(tolerance, True)

    def IsSimilarity(self, tolerance):
        """1 keeps orientation, -1 turns it around, 0 no similarity."""
        return self._similar(tolerance, False)

    RigidType = property(lambda self: self.IsRigid(ZERO_TOLERANCE * 1e3))
    SimilarityType = property(lambda self: self.IsSimilarity(ZERO_TOLERANCE * 1e3))

    def _similar(self, tolerance, rigid):
        if not self.IsAffine:
            return 0
        columns = self._columns()
        lengths = [column.Length for column in columns]
        if min(lengths) <= 0.0 or max(lengths) - min(lengths) > tolerance or (rigid and abs(lengths[0] - 1.0) > tolerance):
            return 0
        for column in columns:
            column.Unitize()
        if max(abs(columns[i] * columns[j]) for i, j in ((0, 1), (1, 2), (2, 0))) > max(tolerance, SQRT_EPSILON):
            return 0
        return 1 if self.Determinant > 0.0 else -1

    def DecomposeRigid(self, *tolerance_and_place_holders):
        """(type, translation, rotation): 1 proper, -1 with a reflection, 0 no rigid motion."""
        numbers = [value for value in tolerance_and_place_holders if is_number(value)]
        kind = self.IsRigid(numbers[0] if numbers else ZERO_TOLERANCE * 1e3)
        turn = Transform._of(self._m)
        turn.Linearize()
        return kind, Vector3d(self._m[3], self._m[7], self._m[11]), turn

    def DecomposeSimilarity(self, *tolerance_and_place_holders):
        """(type, translation, dilation, rotation)."""
        numbers = [value for value in tolerance_and_place_holders if is_number(value)]
        kind = self.IsSimilarity(numbers[0] if numbers else ZERO_TOLERANCE * 1e3)
        dilation = kind * self._columns()[0].Length
        turn = Transform._of(self._m)
        turn.Linearize()
        if dilation:
            turn = turn * Transform.Diagonal(1.0 / dilation, 1.0 / dilation, 1.0 / dilation)
        return kind, Vector3d(self._m[3], self._m[7], self._m[11]), dilation, turn

    def DecomposeAffine(self, *place_holders):
        """(True, translation, linear part): first the linear part, then the move."""
        if not self.IsAffine:
            return False, Vector3d.Zero, Transform.Identity
        linear = Transform._of(self._m)
        linear.Linearize()
        return True, Vector3d(self._m[3], self._m[7], self._m[11]), linear

    def GetEulerZYZ(self, *place_holders):
        """Angles of RotationZYZ: (True, alpha, beta, gamma)."""
        if not self.IsRotation:
            return False, 0.0, 0.0, 0.0
        m = self._m
        beta = math.acos(max(-1.0, min(1.0, m[10])))
        if abs(m[10]) >= 1.0 - 1e-12:
            # The two turns are about the same line: gamma is taken as 0.
            return True, math.atan2(-m[1], m[5]), beta, 0.0
        return True, math.atan2(m[6], m[2]), beta, math.atan2(m[9], -m[8])

    def CompareTo(self, other):
        return (self._m > other._m) - (self._m < other._m)

    def GetYawPitchRoll(self, *place_holders):
        """Angles of RotationZYX: (True, yaw, pitch, roll)."""
        if not self.IsRotation:
            return False, 0.0, 0.0, 0.0
        m = self._m
        pitch = math.asin(max(-1.0, min(1.0, -m[8])))
        if abs(m[8]) >= 1.0 - 1e-12:
            # Looking straight up or down: roll is free, and taken as 0.
            return True, math.atan2(-m[1], m[5]), pitch, 0.0
        return True, math.atan2(m[4], m[0]), pitch, math.atan2(m[9], m[10])

    def GetQuaternion(self, *place_holders):
        from .quaternion import Quaternion
        return Quaternion._of_matrix(self)

    def Linearize(self):
        self._m[3] = self._m[7] = self._m[11] = 0.0
        self._m[12:] = [0.0, 0.0, 0.0, 1.0]

    def Affineize(self):
        self._m[12:] = [0.0, 0.0, 0.0, 1.0]

    def ToDoubleArray(self, rowDominant):
        return list(self._m if rowDominant else self.Transpose()._m)

    ToFloatArray = ToDoubleArray

    def ToString(self, *format_and_culture):
        from .base import number_text
        rows = ["R%d=(%s)" % (i, ",".join(map(number_text, self._m[4 * i:4 * i + 4]))) for i in range(4)]
        return ", ".join(rows)

    Identity = static_value(lambda cls: cls._of(_IDENTITY))
    ZeroTransformation = static_value(lambda cls: cls._of((0,) * 15 + (1,)))
    Unset = static_value(lambda cls: cls._of((UNSET,) * 16))


def _cell(index):
    def read(self):
        return self._m[index]

    def write(self, value):
        self._m[index] = float(value)
    return property(read, write)


for _row in range(4):
    for _column in range(4):
        setattr(Transform, "M%d%d" % (_row, _column), _cell(4 * _row + _column))


def _minor(a, b, c, skip):
    """The determinant of three rows without one column."""
    i, j, k = (column for column in range(4) if column != skip)
    return (a[i] * (b[j] * c[k] - b[k] * c[j]) - a[j] * (b[i] * c[k] - b[k] * c[i])
            + a[k] * (b[i] * c[j] - b[j] * c[i]))


def _of_linear(nine):
    a = nine
    return Transform._of((a[0], a[1], a[2], 0, a[3], a[4], a[5], 0, a[6], a[7], a[8], 0, 0, 0, 0, 1))


def _frame_matrix(origin, x, y, z):
    columns = [to_vector(x), to_vector(y), to_vector(z), to_vector(origin)]
    return Transform._of([v for row in zip(*[c._parts() for c in columns]) for v in row] + [0, 0, 0, 1])


def _to_world(plane):
    """From a plane's coordinates to the world's."""
    return _frame_matrix(plane._origin, plane._x, plane._y, plane._z)


def _from_world(plane):
    """From the world's coordinates to a plane's: the axes are orthonormal, so the inverse is the transpose."""
    numbers = []
    for axis in (plane._x, plane._y, plane._z):
        numbers += list(axis._parts()) + [-(axis * plane._origin)]
    return Transform._of(numbers + [0, 0, 0, 1])


def _in_frame(plane, local):
    """A transform given in a plane's coordinates, with exact translations where the axes are the world's."""
    return _to_world(plane) * local * _from_world(plane)


def _about(sine, cosine, axis, centre):
    """A rotation about an axis through a point, by sine and cosine."""
    axis, c = to_vector(axis), to_point(centre)
    if not axis.Unitize():
        return Transform.Unset
    x, y, z = axis._parts()
    t = 1.0 - cosine
    turn = _of_linear((t * x * x + cosine, t * x * y - sine * z, t * x * z + sine * y,
                       t * x * y + sine * z, t * y * y + cosine, t * y * z - sine * x,
                       t * x * z - sine * y, t * y * z + sine * x, t * z * z + cosine))
    moved = turn._direction(*c._parts())
    for row, (a, b) in enumerate(zip(c._parts(), moved)):
        turn._m[4 * row + 3] = a - b
    return turn
