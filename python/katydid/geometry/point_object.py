"""Point: a location as geometry. It needs no host, so that documents of points cost no calls."""

from ..values.box import BoundingBox
from ..values.plane import to_point
from ..values.point import Point3d
from .classes import CLASSES, GeometryBase
from .user_strings import NameValueCollection


class Point(GeometryBase):
    """A point object; `Location` is its Point3d."""

    __slots__ = ("_location", "_texts")

    def __init__(self, location=None):
        object.__setattr__(self, "_number", 0)
        object.__setattr__(self, "_kind", "Point")
        object.__setattr__(self, "_location", Point3d() if location is None else to_point(location))
        object.__setattr__(self, "_texts", {})

    @classmethod
    def _of(cls, number, kind):
        made = object.__new__(cls)
        object.__setattr__(made, "_number", number)
        object.__setattr__(made, "_kind", kind)
        # Asked for when it is read.
        object.__setattr__(made, "_location", None)
        object.__setattr__(made, "_texts", None)
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
        """Its location; with texts a point object of the host, which carries them."""
        from .. import codec
        from ..backend import current
        if self._number and self._location is None and self._texts is None:
            # As the host gave it: nobody has asked for anything.
            return codec.Reference(self._number, self._kind)
        if not self._strings():
            return self.Location
        made = current().call("Point.new", self.Location)
        for key, text in self._texts.items():
            current().call("GeometryBase.SetUserString", made, key, text)
        # The host forgets one that nobody holds: it goes into this object, in the place of the one before.
        if self._number:
            current().release(self._number)
        object.__setattr__(self, "_number", made._number)
        object.__setattr__(made, "_number", 0)
        return codec.Reference(self._number, "Point")

    def _twin(self):
        made = Point(self.Location)
        made._strings().update(self._strings())
        return made

    def _strings(self):
        if self._texts is None:
            from .. import codec
            from ..backend import current
            found = current().call("GeometryBase.GetUserStrings", codec.Reference(self._number, self._kind))
            object.__setattr__(self, "_texts", dict(found))
        return self._texts

    def SetUserString(self, key, value):
        if not key:
            return False
        if value is None:
            return self.DeleteUserString(key)
        self._strings()[str(key)] = str(value)
        return True

    def GetUserString(self, key):
        return self._strings().get(key)

    def GetUserStrings(self):
        return NameValueCollection(self._strings())

    UserStringCount = property(lambda self: len(self._strings()))

    def DeleteUserString(self, key):
        return self._strings().pop(key, None) is not None

    def DeleteAllUserStrings(self):
        self._strings().clear()

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
