"""The object table of a document."""

import copy

from ..values import Arc, Circle, Guid, Line, Plane, Polyline, to_point
from ..values.base import DotNet, not_supported
from ..values.enums import ObjectType
from ..values.netlist import NetList
from ..geometry import HostObject
from ..geometry.user_strings import NameValueCollection
from .geometry_of import geometry_of, is_geometry

_TYPES = {"Point": "Point", "PointCloud": "PointSet", "Brep": "Brep", "Mesh": "Mesh", "SubD": "SubD", "Hatch": "Hatch",
          "TextDot": "TextDot", "TextEntity": "Annotation", "Extrusion": "Extrusion"}


class Attributes(DotNet):
    """Name, layer and colour of an object; they are kept, and nothing is drawn by them."""

    _namespace = "Rhino.DocObjects"

    def __init__(self):
        self.Name, self.LayerIndex, self.Visible, self.ObjectColor = "", 0, True, None
        self.ColorSource = self.PlotColor = self.MaterialIndex = None
        self._texts = {}

    def SetUserString(self, key, value):
        self._texts[key] = value
        return True

    def GetUserString(self, key):
        return self._texts.get(key)

    def GetUserStrings(self):
        return NameValueCollection(self._texts)

    UserStringCount = property(lambda self: len(self._texts))

    def DeleteUserString(self, key):
        return self._texts.pop(key, None) is not None

    def DeleteAllUserStrings(self):
        self._texts.clear()

    def Duplicate(self):
        made = copy.copy(self)
        made._texts = dict(self._texts)
        return made


class DocumentObject(DotNet):
    """An object of a document. What was added as a struct becomes geometry when it is asked for."""

    _namespace = "Rhino.DocObjects"

    def __init__(self, guid, value, attributes=None):
        self.Id, self.value = guid, value
        self.Attributes = attributes or Attributes()
        self._geometry = value if isinstance(value, HostObject) else None

    @property
    def Geometry(self):
        if self._geometry is None:
            self._geometry = geometry_of(self.value)
        return self._geometry

    CurveGeometry = BrepGeometry = MeshGeometry = PointGeometry = Geometry
    Name = property(lambda self: self.Attributes.Name, lambda self, value: setattr(self.Attributes, "Name", value))
    IsDeleted = IsHidden = IsLocked = IsReference = property(lambda self: False)
    IsNormal = property(lambda self: True)

    @property
    def ObjectType(self):
        kind = type(self.Geometry).__name__
        if kind in _TYPES:
            return getattr(ObjectType, _TYPES[kind])
        from ..geometry import CLASSES
        for base in ("Curve", "Surface"):
            if issubclass(type(self.Geometry), CLASSES[base]):
                return getattr(ObjectType, base)
        return getattr(ObjectType, "None")

    def CommitChanges(self):
        self.value = self._geometry if self._geometry is not None else self.value
        return True


class ObjectTable(DotNet):
    """Objects by Guid, in the order in which they were added."""

    _namespace = "Rhino.DocObjects.Tables"

    def __init__(self):
        self._objects = {}

    Count = property(lambda self: len(self._objects))

    def __iter__(self):
        return iter(list(self._objects.values()))

    def __len__(self):
        return len(self._objects)

    def GetEnumerator(self):
        return iter(self)

    def Add(self, geometry, attributes=None):
        """Adds any geometry and gives its Guid; an empty one where it is none."""
        if not is_geometry(geometry):
            if isinstance(geometry, (list, tuple)) and len(geometry) == 3:
                geometry = to_point(geometry)
            else:
                return Guid.Empty
        guid = Guid.NewGuid()
        # What the script changes later must not change the document's object.
        self._objects[guid] = DocumentObject(guid, copy.copy(geometry), attributes)
        return guid

    def AddPoint(self, *point):
        attributes = point[1] if len(point) == 2 else None
        return self.Add(to_point(point if len(point) == 3 else point[0]), attributes)

    def AddLine(self, *line):
        return self.Add(line[0] if isinstance(line[0], Line) else Line(to_point(line[0]), to_point(line[1])))

    def AddPolyline(self, points, attributes=None):
        return self.Add(Polyline(points), attributes)

    def AddCircle(self, circle, attributes=None):
        return self.Add(Circle(circle), attributes)

    def AddArc(self, arc, attributes=None):
        return self.Add(Arc(arc), attributes)

    def AddPoints(self, points, attributes=None):
        return NetList(self.AddPoint(point) for point in points)

    AddCurve = AddBrep = AddMesh = AddSurface = AddSphere = AddEllipse = AddPointCloud = AddTextDot = AddHatch = Add
    AddBox = AddRectangle = AddSubD = AddExtrusion = AddText = Add

    def Find(self, guid):
        if isinstance(guid, DocumentObject):
            guid = guid.Id
        if isinstance(guid, str):
            found, guid = Guid.TryParse(guid)
            if not found:
                return None
        return self._objects.get(guid) if isinstance(guid, Guid) else None

    FindId = FindGeometry = Find

    def TryFindPoint(self, guid, *place_holders):
        found = self.Find(guid)
        if found is None or type(found.Geometry).__name__ != "Point":
            return False, None
        return True, found.Geometry.Location

    def Delete(self, guid, quiet=True):
        if not isinstance(guid, (Guid, DocumentObject, str)):
            return sum(bool(self.Delete(one)) for one in guid)
        found = self.Find(guid)
        return found is not None and self._objects.pop(found.Id, None) is not None

    def Replace(self, guid, geometry):
        found = self.Find(guid)
        if found is None or not is_geometry(geometry):
            return False
        self._objects[found.Id] = DocumentObject(found.Id, copy.copy(geometry), found.Attributes)
        return True

    def Transform(self, guid, xform, deleteOriginal=True):
        """Moves an object, or a copy of it under a new Guid; an empty one where that fails."""
        found = self.Find(guid)
        if found is None:
            return Guid.Empty
        moved = moved_copy(found.value, xform)
        if moved is None:
            return Guid.Empty
        if deleteOriginal:
            self._objects[found.Id] = DocumentObject(found.Id, moved, found.Attributes)
            return found.Id
        return self.Add(moved, found.Attributes.Duplicate())

    def ModifyAttributes(self, guid, attributes, quiet=True):
        found = self.Find(guid)
        if found is not None:
            found.Attributes = attributes
        return found is not None

    def FindByLayer(self, layer):
        """The objects on a layer, by its name or the layer itself: there is one."""
        return list(self) if getattr(layer, "Name", layer) == "Default" else []

    def FindByObjectType(self, kind):
        return [one for one in self if int(one.ObjectType) & int(kind)]

    def GetObjectList(self, *filter_):
        return NetList(self)

    def GetSelectedObjects(self, *flags):
        return []

    def Select(self, *objects):
        """Nothing can be selected without a window."""
        return False

    def UnselectAll(self):
        return 0

    Hide = Show = Lock = Unlock = Select

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        raise not_supported("Rhino.DocObjects.Tables.ObjectTable." + name)


def moved_copy(value, xform):
    """A transformed copy of a stored value; None where the transform has no sense for it.

    Round structs stay what they are under similarities, and become curves under anything else.
    """
    if isinstance(value, HostObject) or not _keeps_shape(value, xform):
        moved = copy.copy(geometry_of(value))
        return moved if moved.Transform(xform) is not False else None
    moved = copy.copy(value)
    moved.Transform(xform)
    return moved


def _keeps_shape(value, xform):
    if type(value).__name__ in ("Point3d", "Point3f", "Line", "Polyline"):
        return xform.IsAffine
    return not isinstance(value, Plane) and hasattr(value, "Transform") and int(xform.IsSimilarity(1e-9)) != 0
