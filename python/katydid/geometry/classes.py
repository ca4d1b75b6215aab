"""The classes of Rhino.Geometry that are held by handle, and which inherits from which."""

from ..backend import current
from .host_object import HostClass, HostObject
from .user_strings import NameValueCollection


class GeometryBase(HostObject):
    """What all geometry is."""

    __slots__ = ()

    def Duplicate(self):
        return self._twin()

    DuplicateShallow = DuplicateGeometry = Clone = Duplicate

    def EnsurePrivateCopy(self):
        pass

    @property
    def HasUserData(self):
        return self.UserStringCount > 0

    def GetUserStrings(self):
        return NameValueCollection(current().call("GeometryBase.GetUserStrings", self))

    #: No object belongs to the document of a model.
    IsDocumentControlled = property(lambda self: False)

    def IsValidWithLog(self, *place_holders):
        """(valid, why not)."""
        valid = self.IsValid
        return valid, "" if valid else "the %s is not valid" % type(self).__name__

    @property
    def Disposed(self):
        return not self._number

    def GetHashCode(self):
        return self._number & 0x7FFFFFFF


class Curve(GeometryBase):
    __slots__ = ()

    def DuplicateCurve(self):
        return self._twin()


class Surface(GeometryBase):
    __slots__ = ()


class Brep(GeometryBase):
    __slots__ = ()

    def DuplicateBrep(self):
        return self._twin()


class Mesh(GeometryBase):
    """A mesh. Vertices and faces that a script adds or sets wait here, and go to the host together when it is asked
    something: a loop over ten thousand costs a few calls. What was read of them is kept up to date meanwhile."""

    __slots__ = ("_waiting", "_colours")

    def __init__(self, *arguments):
        if len(arguments) == 1 and isinstance(arguments[0], Mesh):
            self._adopt(arguments[0]._twin())
        else:
            GeometryBase.__init__(self, *arguments)

    def DuplicateMesh(self):
        return self._twin()

    def _wait(self):
        """What waits: vertices and faces added, then those set, by index."""
        waiting = getattr(self, "_waiting", None)
        if waiting is None:
            waiting = ([], [], {}, {})
            object.__setattr__(self, "_waiting", waiting)
        return waiting

    def _settle(self):
        self._settle_parts()
        colours = getattr(self, "_colours", None)
        if colours is None:
            return
        object.__setattr__(self, "_colours", None)
        backend = current()
        if len(colours) == backend.call("MeshVertexList.get_Count", self):
            backend.call("MeshVertexColorList.SetColors", self, colours)
        else:
            # A colour for each vertex, or none: the rest is still to come.
            object.__setattr__(self, "_colours", colours)

    def _settle_parts(self):
        waiting = getattr(self, "_waiting", None)
        if waiting is None:
            return
        object.__setattr__(self, "_waiting", None)
        # Vertices and faces are known; what follows from them is not.
        kept = {name: items for name, items in (self._cache or {}).items() if name in ("Vertices", "Faces", "VertexColors")}
        backend = current()
        vertices, faces, set_vertices, set_faces = waiting
        object.__setattr__(self, "_cache", None)
        if vertices:
            backend.call("MeshVertexList.AddVertices", self, vertices)
        if set_vertices:
            backend.call("MeshVertexList.SetVertex", self, list(set_vertices), list(set_vertices.values()))
        if faces:
            backend.call("MeshFaceList.AddFaces", self, faces)
        if set_faces:
            backend.call("MeshFaceList.SetFace", self, list(set_faces), list(set_faces.values()))
        object.__setattr__(self, "_cache", kept)

    def _lower(self):
        self._settle()
        return GeometryBase._lower(self)


class PointCloud(GeometryBase):
    """Points with their normals and colours; an index gives a point with all that is said of it."""

    __slots__ = ()

    def __len__(self):
        return self.Count

    def __bool__(self):
        return True

    def __getitem__(self, index):
        if isinstance(index, slice):
            return [self[i] for i in range(*index.indices(len(self)))]
        return current().call("PointCloud.get_Item", self, index + len(self) if index < 0 else index)

    get_Item = __getitem__

    def __iter__(self):
        return (self[i] for i in range(len(self)))

    GetEnumerator = __iter__


_BASES = {
    "LineCurve": Curve, "ArcCurve": Curve, "PolylineCurve": Curve, "NurbsCurve": Curve, "PolyCurve": Curve,
    "CurveProxy": Curve, "PlaneSurface": Surface, "NurbsSurface": Surface, "RevSurface": Surface,
    "SumSurface": Surface, "Extrusion": Surface, "SurfaceProxy": Surface, "SubD": GeometryBase,
    "Point": GeometryBase, "Hatch": GeometryBase, "TextDot": GeometryBase,
    "Light": GeometryBase, "InstanceReferenceGeometry": GeometryBase, "AnnotationBase": GeometryBase,
    "Point3dGrid": GeometryBase, "MorphControl": GeometryBase, "BrepVertex": HostObject, "BrepLoop": HostObject,
    "BrepTrim": HostObject, "SubDVertex": HostObject, "SubDEdge": HostObject, "SubDFace": HostObject,
    "ControlPoint": HostObject, "PointCloudItem": HostObject,
    "MeshingParameters": HostObject, "AreaMassProperties": HostObject, "VolumeMassProperties": HostObject,
    "LengthMassProperties": HostObject, "BezierCurve": HostObject, "BezierSurface": HostObject,
    "SurfaceCurvature": HostObject, "MeshPoint": HostObject, "Matrix": HostObject, "ConicSection": HostObject,
    "SpaceMorph": HostObject, "Unroller": HostObject, "SweepOneRail": HostObject, "SweepTwoRail": HostObject,
    "HiddenLineDrawing": HostObject, "Silhouette": HostObject, "QuadRemeshParameters": HostObject,
    "ReduceMeshParameters": HostObject, "ShrinkWrapParameters": HostObject, "RTree": HostObject,
}

#: By the name in RhinoCommon.
CLASSES = {"GeometryBase": GeometryBase, "Curve": Curve, "Surface": Surface, "Brep": Brep, "Mesh": Mesh,
           "PointCloud": PointCloud}


def _make(name, base):
    CLASSES[name] = HostClass(name, (base,), {
        "__slots__": (), "__module__": "Rhino.Geometry",
        "_is_record": base is HostObject,
        "__doc__": "%s of Rhino.Geometry; its members are those of the host." % name})
    return CLASSES[name]


for _name, _base in _BASES.items():
    _make(_name, _base)
for _name, _base in (("CurveOnSurface", "Curve"), ("BrepEdge", "CurveProxy"),
                     ("BrepFace", "SurfaceProxy"), ("TextEntity", "AnnotationBase"), ("Leader", "AnnotationBase"),
                     ("Dimension", "AnnotationBase"), ("LinearDimension", "Dimension")):
    _make(_name, CLASSES[_base])



def _extrusion(face, *arguments):
    """Of an instance (path, cap), or the static member of Surface (profile, direction)."""
    from .call import invoke
    from .extrude import extruded_face
    if len(arguments) == 2 and isinstance(arguments[1], bool):
        return extruded_face(face, *arguments)
    return invoke("Surface", "CreateExtrusion", ["Surface"], (face,) + arguments)


CLASSES["BrepFace"].CreateExtrusion = _extrusion

#: Classes of static members in other namespaces.
for _name in ("Intersection", "MeshClash", "CurveIntersections", "IntersectionEvent"):
    _make(_name, HostObject)._namespace = "Rhino.Geometry.Intersect"


def of_handle(number, kind):
    """The object for a handle that the host has given. A kind that is not known here is a class of its own name."""
    cls = CLASSES.get(kind)
    if cls is None:
        if not kind.isidentifier() or len(kind) > 100:
            kind = "HostObject"
        cls = _make(kind, HostObject)
    return cls._of(number, kind)
