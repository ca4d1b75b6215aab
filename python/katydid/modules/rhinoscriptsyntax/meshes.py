"""Meshes: what is asked of them, and what is made of them."""

import scriptcontext
from katydid.geometry import construct, static_call
from katydid.values import Vector3d

from .coerce import coerce3dpoint, coercecurve, coerceguid, coercemesh, coercerhinoobject
from .support import added, all_added, is_many, tolerance


def _meshes(ids):
    return [coercemesh(one, True) for one in (ids if is_many(ids) else [ids])]


def _delete(ids):
    for one in ids if is_many(ids) else [ids]:
        guid = coerceguid(one)
        if guid is not None:
            scriptcontext.doc.Objects.Delete(guid)


def MeshQuadCount(object_id):
    return sum(1 for face in coercemesh(object_id, True).Faces if face.IsQuad)


def MeshTriangleCount(object_id):
    return sum(1 for face in coercemesh(object_id, True).Faces if face.IsTriangle)


def MeshFaceNormals(mesh_id):
    return [Vector3d(normal) for normal in coercemesh(mesh_id, True).FaceNormals]


def MeshHasFaceNormals(mesh_id):
    return len(coercemesh(mesh_id, True).FaceNormals) > 0


def MeshHasVertexNormals(mesh_id):
    return len(coercemesh(mesh_id, True).Normals) > 0


def MeshHasVertexColors(mesh_id):
    return len(coercemesh(mesh_id, True).VertexColors) > 0


def MeshVertexColors(mesh_id, colors=0):
    """The colours of the vertices, None without; `colors` sets them, and None clears them."""
    mesh = coercemesh(mesh_id, True)
    before = list(mesh.VertexColors) or None
    if colors is None:
        mesh.VertexColors.Clear()
    elif colors != 0:
        from .coerce import coercecolor
        new = [coercecolor(color, True) for color in colors]
        if len(new) != len(mesh.Vertices):
            raise ValueError("%d colours for %d vertices" % (len(new), len(mesh.Vertices)))
        mesh.VertexColors.SetColors(new)
    if colors != 0:
        found = coercerhinoobject(mesh_id)
        if found is not None:
            found.value = found._geometry = mesh
    return before


def MeshVertexFaces(mesh_id, vertex_index):
    """The numbers of the faces around a vertex."""
    mesh = coercemesh(mesh_id, True)
    index = int(vertex_index)
    if not 0 <= index < len(mesh.Vertices):
        raise IndexError("vertex %d of %d" % (index, len(mesh.Vertices)))
    return [number for number, face in enumerate(mesh.Faces) if index in list(face)] or None


def MeshNakedEdgePoints(object_id):
    """The vertices on edges that bound one face alone."""
    mesh = coercemesh(object_id, True)
    count = {}
    for face in mesh.Faces:
        corners = list(face)[:3] if face.IsTriangle else list(face)
        for a, b in zip(corners, corners[1:] + corners[:1]):
            edge = (min(a, b), max(a, b))
            count[edge] = count.get(edge, 0) + 1
    naked = sorted({corner for edge, faces in count.items() if faces == 1 for corner in edge})
    points = mesh.Vertices.ToPoint3dArray()
    return [points[i] for i in naked]


def _centroid(kind, object_id):
    return static_call(kind, "Compute", coercemesh(object_id, True)).Centroid


def MeshAreaCentroid(object_id):
    return _centroid("AreaMassProperties", object_id)


def MeshVolumeCentroid(object_id):
    return _centroid("VolumeMassProperties", object_id)


def IsMeshManifold(object_id):
    """Whether no edge bounds more than two faces."""
    return bool(coercemesh(object_id, True).IsManifold())


def IsPointOnMesh(object_id, point):
    """Whether a point is within the document's tolerance of a mesh."""
    found = coercemesh(object_id, True).ClosestPoint(coerce3dpoint(point, True))
    return found.DistanceTo(coerce3dpoint(point)) <= tolerance()


def DisjointMeshCount(object_id):
    return int(coercemesh(object_id, True).DisjointMeshCount)


def SplitDisjointMesh(object_id, delete_input=False):
    made = all_added(coercemesh(object_id, True).SplitDisjointPieces()) or []
    if made and delete_input:
        _delete(object_id)
    return made


def _changed(object_id, mesh):
    """Puts a changed mesh back under its Guid."""
    found = coercerhinoobject(object_id, True)
    found.value = found._geometry = mesh
    return True


def UnifyMeshNormals(object_id):
    """How many faces were turned over."""
    mesh = coercemesh(object_id, True)
    count = mesh.UnifyNormals()
    _changed(object_id, mesh)
    return int(count)


def MeshQuadsToTriangles(object_id):
    mesh = coercemesh(object_id, True)
    if not mesh.Faces.ConvertQuadsToTriangles():
        return False
    return _changed(object_id, mesh)


def MeshOffset(mesh_id, distance):
    return added(coercemesh(mesh_id, True).Offset(float(distance)))


def AddPlanarMesh(object_id, delete_input=False):
    """A mesh inside a closed planar curve."""
    from .coerce import coercecurve
    made = static_call("Mesh", "CreateFromPlanarBoundary", coercecurve(object_id, -1, True),
                       _usual_settings(), tolerance())
    guid = added(made)
    if guid and delete_input:
        _delete(object_id)
    return guid


def _usual_settings():
    """The settings of a mesh that nobody chose."""
    from katydid.geometry import MeshingParameters
    return MeshingParameters.Default


def _boolean(member, first, second, delete_input):
    made = static_call("Mesh", member, _meshes(first), *([] if second is None else [_meshes(second)]))
    guids = all_added(made[0] if isinstance(made, tuple) else made) or []
    if guids and delete_input:
        _delete(first)
        if second is not None:
            _delete(second)
    return guids


def MeshBooleanUnion(mesh_ids, delete_input=True):
    return _boolean("CreateBooleanUnion", mesh_ids, None, delete_input)


def MeshBooleanDifference(input0, input1, delete_input=True, tolerance=None):
    return _boolean("CreateBooleanDifference", input0, input1, delete_input)


def MeshBooleanIntersection(input0, input1, delete_input=True):
    return _boolean("CreateBooleanIntersection", input0, input1, delete_input)


def MeshMeshIntersection(mesh1, mesh2, tolerance=None):
    """The points of each polyline in which two meshes meet."""
    from .support import tolerance as usual
    found = static_call("Intersection", "MeshMeshAccurate", coercemesh(mesh1, True), coercemesh(mesh2, True),
                        usual() if tolerance is None else float(tolerance))
    return [list(points) for points in found or ()]


def CurveMeshIntersection(curve_id, mesh_id, return_faces=False):
    """The points in which a curve of straight pieces meets a mesh; with the numbers of the faces where they are asked for."""
    curve = coercecurve(curve_id, -1, True)
    mesh = coercemesh(mesh_id, True)
    done, polyline = curve.TryGetPolyline()
    if not done:
        raise ValueError("only curves of straight pieces are met with meshes")
    made = construct("PolylineCurve", list(polyline))
    points, faces = static_call("Intersection", "MeshPolyline", mesh, made)
    return list(zip(points, faces)) if return_faces else list(points)
