"""10^6 turns of vector arithmetic: a sum, a product with a number, a cross product and a length in each."""

import math


class Vector3d:
    __slots__ = ("X", "Y", "Z")

    def __init__(self, x, y, z):
        self.X, self.Y, self.Z = x, y, z

    @property
    def Length(self):
        return math.sqrt(self.X * self.X + self.Y * self.Y + self.Z * self.Z)

    def __add__(self, b):
        return Vector3d(self.X + b.X, self.Y + b.Y, self.Z + b.Z)

    def __mul__(self, k):
        return Vector3d(self.X * k, self.Y * k, self.Z * k)

    @staticmethod
    def CrossProduct(a, b):
        return Vector3d(a.Y * b.Z - b.Y * a.Z, a.Z * b.X - b.Z * a.X, a.X * b.Y - b.X * a.Y)


def run(n):
    axis = Vector3d(0.6, 0.0, 0.8)
    at = Vector3d(1.0, 2.0, 3.0)
    sum = 0.0
    for i in range(n):
        at = at + Vector3d.CrossProduct(axis, at) * 0.001
        sum += at.Length
    return sum


print(repr(run(1000000)))
