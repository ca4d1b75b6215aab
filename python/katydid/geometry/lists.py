"""Lists that belong to an object: mesh.Vertices, brep.Faces, curve.Points.

A list has no handle of its own: handed to the host it is its object, so `MeshVertexList.Add` changes the mesh. What was
read is kept until the object changes.
"""

from ..backend import current
from ..values import Color, MeshFace, Point3d, Point3f, Point4d, Vector3f, to_point
from ..values.base import DotNet, not_supported
from ..values.netlist import NetList
from .call import invoke, shaped
from .host_object import HostObject, Member


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


class WaitingList(HostList):
    """Vertices or faces of a mesh: what a script adds or sets waits in Python until the mesh is asked something."""

    __slots__ = ()
    #: Where added ones wait; those that were set wait two places behind.
    _place = 0

    def _items(self):
        cache = self._owner._cache
        found = cache.get(self._property) if cache else None
        # What waits stands in what was read already.
        return HostList._items(self) if found is None else found

    def _add(self, item):
        items = self._items()
        self._owner._wait()[self._place].append(item)
        items.extend(self._convert([item]))
        return len(items) - 1

    def _set(self, index, item):
        """Sets one; False where there is none."""
        items = self._items()
        place = index + len(items) if index < 0 else index
        if not 0 <= place < len(items):
            return False
        self._owner._wait()[self._place + 2][place] = item
        items[place] = self._convert([item])[0]
        return True

    def __setitem__(self, index, value):
        if not self._set(int(index), self._one(value)):
            raise IndexError("index is %s, of %d" % (index, len(self)))


class VertexList(WaitingList):
    """mesh.Vertices: points in single precision."""

    __slots__ = ()

    def _convert(self, items):
        return [Point3f(point) for point in items]

    @staticmethod
    def _one(*point):
        return Point3d(*point) if len(point) == 3 else to_point(point[0])

    def Add(self, *point):
        return self._add(self._one(*point))

    def AddVertices(self, points):
        for point in points:
            self.Add(point)

    def SetVertex(self, index, *point):
        return self._set(index, self._one(*point[:3]))

    def ToPoint3dArray(self):
        self._owner._settle()
        return NetList(self._read())

    def ToPoint3fArray(self):
        return NetList(self)


class FaceList(WaitingList):
    """mesh.Faces."""

    __slots__ = ()
    _place = 1

    @staticmethod
    def _one(*face):
        return face[0]._copy() if isinstance(face[0], MeshFace) else MeshFace(*face)

    def AddFace(self, *face):
        return self._add(self._one(*face))

    def AddFaces(self, faces):
        return NetList(self.AddFace(face) for face in faces)

    def SetFace(self, index, *face):
        return self._set(index, self._one(*face))

    GetFace = WaitingList.__getitem__


class ColorList(HostList):
    """mesh.VertexColors: colours that a script adds or sets wait in Python until the mesh is asked something."""

    __slots__ = ()

    def _items(self):
        cache = self._owner._cache
        found = cache.get(self._property) if cache else None
        return HostList._items(self) if found is None else found

    def _wait(self, items):
        object.__setattr__(self._owner, "_colours", items)

    def Add(self, *colour):
        """A colour, or red, green and blue."""
        items = self._items()
        items.append(Color.FromArgb(*colour) if len(colour) == 3 else colour[0])
        self._wait(items)
        return len(items) - 1

    def SetColor(self, index, *colour):
        self[index] = Color.FromArgb(*colour) if len(colour) == 3 else colour[0]
        return True

    def __setitem__(self, index, colour):
        items = self._items()
        items[index] = colour
        self._wait(items)


class NormalList(HostList):
    """Normals: vectors in single precision."""

    __slots__ = ()

    def _convert(self, items):
        return [Vector3f(vector) for vector in items]


class ControlPointList(HostList):
    """curve.Points."""

    __slots__ = ()

    def SetPoint(self, index, *point):
        """By a point, a point and a weight, or three or four numbers."""
        if len(point) == 1 and isinstance(point[0], Point4d):
            # Homogeneous: the point in space is divided by its weight.
            own = point[0]
            point = (Point3d(own.X / own.W, own.Y / own.W, own.Z / own.W), own.W)
        place = Point3d(*point[:3]) if len(point) >= 3 else to_point(point[0])
        weight = point[-1] if len(point) in (2, 4) else None
        done = invoke(self._name, "SetPoint", [self._name], (self, index, place))
        if weight is not None:
            done = bool(done and invoke(self._name, "SetWeight", [self._name], (self, index, float(weight))))
        self._stale()
        return done

    def __setitem__(self, index, value):
        """A control point, or a point: its weight stays as it is."""
        if isinstance(value, HostObject):
            self.SetPoint(index, value.Location, value.Weight)
        else:
            self.SetPoint(index, value)


class KnotList(HostList):
    """curve.Knots, and those of a surface."""

    __slots__ = ()

    def KnotMultiplicity(self, index):
        """How often the knot of an index comes."""
        knots = self._items()
        return sum(knot == knots[index] for knot in knots)


class SurfacePointList(HostList):
    """surface.Points: a grid, v running fastest."""

    __slots__ = ()

    def SetPoint(self, u, v, *point):
        """By a point, a point and a weight, or three or four numbers."""
        if len(point) == 1 and isinstance(point[0], Point4d):
            # Homogeneous: the point in space is divided by its weight.
            own = point[0]
            point = (Point3d(own.X / own.W, own.Y / own.W, own.Z / own.W), own.W)
        place = Point3d(*point[:3]) if len(point) >= 3 else to_point(point[0])
        weight = (float(point[-1]),) if len(point) in (2, 4) else ()
        done = invoke(self._name, "SetPoint", [self._name], (self, u, v, place) + weight)
        self._stale()
        return done

    def SetControlPoint(self, u, v, point):
        return self.SetPoint(u, v, point.Location, point.Weight)


class SurfaceKnotList(KnotList):
    """surface.KnotsU or surface.KnotsV: what the host is asked names the direction."""

    __slots__ = ()

    @property
    def _direction(self):
        return 0 if self._property == "KnotsU" else 1

    def _read(self):
        return current().call("NurbsSurfaceKnotList.ToArray", self._owner, self._direction)

    def _change(self, member, *arguments):
        done = invoke(self._name, member, [self._name], (self, self._direction) + arguments)
        self._stale()
        return done

    def __setitem__(self, index, value):
        self._change("set_Item", int(index), float(value))

    def CreateUniformKnots(self, spacing):
        return self._change("CreateUniformKnots", float(spacing))

    def CreatePeriodicKnots(self, spacing):
        return self._change("CreatePeriodicKnots", float(spacing))

    @property
    def ClampedAtStart(self):
        degree = getattr(self._owner, "OrderU" if self._direction == 0 else "OrderV") - 1
        return self.KnotMultiplicity(0) >= degree

    @property
    def ClampedAtEnd(self):
        degree = getattr(self._owner, "OrderU" if self._direction == 0 else "OrderV") - 1
        return self.KnotMultiplicity(len(self) - 1) >= degree


class BrepList(HostList):
    """Parts of a Brep, by its own members where the list's are not there."""

    __slots__ = ()

    def ExtractFace(self, index):
        """A copy of one face as a Brep."""
        if current().table.has(self._name, "ExtractFace"):
            return invoke(self._name, "ExtractFace", [self._name], (self, index))
        return self[index].DuplicateFace(False)


_CLASSES = {"MeshVertexList": VertexList, "MeshFaceList": FaceList, "MeshVertexNormalList": NormalList,
            "MeshVertexColorList": ColorList,
            "MeshFaceNormalList": NormalList, "BrepFaceList": BrepList, "NurbsCurvePointList": ControlPointList,
            "NurbsCurveKnotList": KnotList, "NurbsSurfaceKnotList": SurfaceKnotList,
            "NurbsSurfacePointList": SurfacePointList}


def list_of(owner, name, prop):
    """The list of an object."""
    return _CLASSES.get(name, HostList)(owner, name, prop)
