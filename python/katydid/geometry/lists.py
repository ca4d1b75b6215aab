"""Lists that belong to an object: mesh.Vertices, brep.Faces, curve.Points.

A list has no handle of its own: handed to the host it is its object, so `MeshVertexList.Add` changes the mesh. What was
read is kept until the object changes.
"""

from ..backend import current
from ..values import MeshFace, Point3d, Point3f, Vector3f, to_point
from ..values.base import DotNet, not_supported
from ..values.netlist import NetList
from .call import invoke, shaped
from .host_object import Member


class HostList(DotNet):
    """A list of an object's parts."""

    __slots__ = ("_owner", "_name", "_property")

    def __init__(self, owner, name, prop):
        self._owner, self._name, self._property = owner, name, prop

    def _lower(self):
        return self._owner._lower()

    def _stale(self):
        self._owner._stale()

    def _read(self):
        """All items of the host, in Rhino's types."""
        backend = current()
        if backend.table.has(self._name, "ToArray"):
            return backend.call(self._name + ".ToArray", self._owner)
        owner = type(self._owner)._host_name()
        if not backend.table.has(owner, "get_" + self._property):
            raise not_supported("Rhino.Geometry.%s.%s" % (owner, self._property))
        return backend.call("%s.get_%s" % (owner, self._property), self._owner)

    def _items(self):
        self._owner._settle()
        cache = self._owner._cache
        if cache is None:
            cache = {}
            object.__setattr__(self._owner, "_cache", cache)
        found = cache.get(self._property)
        if found is None:
            found = cache[self._property] = self._convert(list(self._read() or ()))
        return found

    def _convert(self, items):
        return items

    def __len__(self):
        return len(self._items())

    Count = Length = property(__len__)

    def __bool__(self):
        return True

    def __iter__(self):
        return iter([_copy(item) for item in self._items()])

    def __getitem__(self, index):
        found = self._items()
        return NetList(found[index]) if isinstance(index, slice) else _copy(found[index])

    get_Item = __getitem__

    def __setitem__(self, index, value):
        name = self._name + ".set_Item"
        if not current().table.has(self._name, "set_Item"):
            raise not_supported("Rhino.Geometry.Collections.%s.Item (to write)" % self._name)
        current().call(name, self._owner, index, value)
        self._stale()

    def GetEnumerator(self):
        return iter(self)

    def ToArray(self):
        return NetList(self)

    def ToString(self):
        return "Rhino.Geometry.Collections." + self._name

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        table = current().table
        if table.has(self._name, name):
            return Member(self._name, name, [self._name], (self,))
        if table.has(self._name, "get_" + name):
            return shaped(current().call("%s.get_%s" % (self._name, name), self),
                          table.signatures(self._name, "get_" + name))
        raise not_supported("Rhino.Geometry.Collections.%s.%s" % (self._name, name))


def _copy(item):
    return item._copy() if hasattr(type(item), "_copy") else item


class VertexList(HostList):
    """mesh.Vertices: points in single precision. Added points wait in Python until the mesh is asked something."""

    __slots__ = ()

    def _convert(self, items):
        return [Point3f(point) for point in items]

    def Add(self, *point):
        return self._owner._wait(0, Point3d(*point) if len(point) == 3 else to_point(point[0]))

    def AddVertices(self, points):
        for point in points:
            self.Add(point)

    def ToPoint3dArray(self):
        self._owner._settle()
        return NetList(self._read())

    def ToPoint3fArray(self):
        return NetList(self)


class FaceList(HostList):
    """mesh.Faces."""

    __slots__ = ()

    def AddFace(self, *face):
        return self._owner._wait(1, face[0] if isinstance(face[0], MeshFace) else MeshFace(*face))

    def AddFaces(self, faces):
        return NetList(self.AddFace(face) for face in faces)


class NormalList(HostList):
    """Normals: vectors in single precision."""

    __slots__ = ()

    def _convert(self, items):
        return [Vector3f(vector) for vector in items]


class BrepList(HostList):
    """Parts of a Brep, by its own members where the list's are not there."""

    __slots__ = ()

    def ExtractFace(self, index):
        """A copy of one face as a Brep."""
        if current().table.has(self._name, "ExtractFace"):
            return invoke(self._name, "ExtractFace", [self._name], (self, index))
        return self[index].DuplicateFace(False)


_CLASSES = {"MeshVertexList": VertexList, "MeshFaceList": FaceList, "MeshVertexNormalList": NormalList,
            "MeshFaceNormalList": NormalList, "BrepFaceList": BrepList}


def list_of(owner, name, prop):
    """The list of an object."""
    return _CLASSES.get(name, HostList)(owner, name, prop)
