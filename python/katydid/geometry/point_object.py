"""Point: a location as geometry. It needs no host, so that documents of points cost no calls."""

from ..values.box import BoundingBox
from ..values.plane import to_point
from ..values.point import Point3d
from .classes import CLASSES, GeometryBase


class Point(GeometryBase):
    """A point object; `Location` is its Point3d."""

    __slots__ = ("_location",)

    def __init__(self, location=None):
        object.__setattr__(self, "_number", 0)
        object.__setattr__(self, "_kind", "Point")
        object.__setattr__(self, "_location", Point3d() if location is None else to_point(location))

    @classmethod
    def _of(cls, number, kind):
        made = object.__new__(cls)
        object.__setattr__(made, "_number", number)
        object.__setattr__(made, "_kind", kind)
        # Asked for when it is read.
        object.__setattr__(made, "_location", None)
        return made

    def _get_location(self):
        if self._location is None:
            from .. import codec
            from ..backend import current
            found = current().call("Point.get_Location", codec.Reference(self._number, self._kind))
            object.__setattr__(self, "_location", found)
        return self._location._copy()

    def _set_location(self, value):
        object.__setattr__(self, "_location", to_point(value))

    Location = property(_get_location, _set_location)
    X = property(lambda self: self.Location.X)
    Y = property(lambda self: self.Location.Y)
    Z = property(lambda self: self.Location.Z)

    def __setattr__(self, name, value):
        object.__setattr__(self, name, value)

    def _lower(self):
        return self.Location

    def _twin(self):
        return Point(self.Location)

    IsValid = property(lambda self: self.Location.IsValid)

    def Transform(self, xform):
        moved = self.Location
        moved.Transform(xform)
        self.Location = moved
        return True

    def Translate(self, *motion):
        from ..values.transform import Transform
        return self.Transform(Transform.Translation(*motion))

    def GetBoundingBox(self, *accurate):
        return BoundingBox(self.Location, self.Location)

    @property
    def ObjectType(self):
        from ..values.enums import ObjectType
        return ObjectType.Point


CLASSES["Point"] = Point
