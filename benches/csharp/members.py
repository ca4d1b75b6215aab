"""10^6 turns over members of points and vectors."""

import math


class Vector3d:
    __slots__ = ("X", "Y", "Z")

    def __init__(self, x, y, z):
        self.X, self.Y, self.Z = x, y, z

    @property
    def Length(self):
        return math.sqrt(self.X * self.X + self.Y * self.Y + self.Z * self.Z)

    def Unitize(self):
        length = self.Length
        if length == 0:
            return False
        self.X /= length
        self.Y /= length
        self.Z /= length
        return True

    def __mul__(self, b):
        if isinstance(b, Vector3d):
            return self.X * b.X + self.Y * b.Y + self.Z * b.Z
        return Vector3d(self.X * b, self.Y * b, self.Z * b)

    @staticmethod
    def CrossProduct(a, b):
        return Vector3d(a.Y * b.Z - b.Y * a.Z, a.Z * b.X - b.Z * a.X, a.X * b.Y - b.X * a.Y)


class Point3d:
    __slots__ = ("X", "Y", "Z")

    def __init__(self, x, y, z):
        self.X, self.Y, self.Z = x, y, z

    def DistanceTo(self, p):
        x, y, z = p.X - self.X, p.Y - self.Y, p.Z - self.Z
        return math.sqrt(x * x + y * y + z * z)

    def __add__(self, b):
        return Point3d(self.X + b.X, self.Y + b.Y, self.Z + b.Z)

    def __sub__(self, b):
        return Vector3d(self.X - b.X, self.Y - b.Y, self.Z - b.Z)


def run(n):
    centre = Point3d(1.0, 2.0, 3.0)
    at = Point3d(4.0, 6.0, 3.0)
    axis = Vector3d(0.6, 0.0, 0.8)
    sum = 0.0
    for i in range(n):
        away = at - centre
        turn = Vector3d.CrossProduct(axis, away)
        turn.Unitize()
        at = at + turn * 0.01
        sum += at.DistanceTo(centre) + turn * away
    return sum


print(repr(run(1000000)))
