"""Questions to surfaces, Breps and meshes."""

import scriptcontext
from katydid.geometry import CLASSES, static_call
from katydid.values import Vector3d

from .coerce import (coerce3dpoint, coercebrep, coercecurve, coercegeometry, coercemesh, coerceplane, coercesurface)
from .support import all_added, is_many, tolerance


def _uv(parameter):
    return float(parameter[0]), float(parameter[1])


def SurfaceDomain(surface_id, direction):
    """[start, end] in u (0) or v (1)."""
    if direction not in (0, 1):
        raise ValueError("direction is 0 or 1")
    domain = coercesurface(surface_id, True).Domain(direction)
    return [domain.Min, domain.Max]


def SurfaceParameter(surface_id, parameter):
    """The surface's own parameters of two from 0 to 1: [u, v]."""
    surface = coercesurface(surface_id, True)
    return [surface.Domain(i).ParameterAt(float(parameter[i])) for i in (0, 1)]


def SurfaceNormalizedParameter(surface_id, parameter):
    surface = coercesurface(surface_id, True)
    return tuple(surface.Domain(i).NormalizedParameterAt(float(parameter[i])) for i in (0, 1))


def EvaluateSurface(surface_id, u, v):
    point = coercesurface(surface_id, True).PointAt(float(u), float(v))
    return point if point.IsValid else None


def SurfaceNormal(surface_id, uv_parameter):
    return coercesurface(surface_id, True).NormalAt(*_uv(uv_parameter))


def SurfaceFrame(surface_id, uv_parameter):
    found = coercesurface(surface_id, True).FrameAt(*_uv(uv_parameter))
    if isinstance(found, tuple):
        return found[1] if found[0] else None
    return found


def SurfaceClosestPoint(surface_id, test_point):
    """[u, v] of the nearest point; None where there is none."""
    found = coercesurface(surface_id, True).ClosestPoint(coerce3dpoint(test_point, True))
    return [found[1], found[2]] if found and found[0] else None


def BrepClosestPoint(object_id, point):
    """(point, (u, v), (kind, index), normal)."""
    brep, test = coercebrep(object_id, True), coerce3dpoint(point, True)
    near, best = None, None
    for i, face in enumerate(brep.Faces):
        found = face.ClosestPoint(test)
        if found and found[0]:
            at = face.PointAt(found[1], found[2])
            gap = at.DistanceTo(test)
            if best is None or gap < best:
                best, near = gap, (at, (found[1], found[2]), (0x1000003, i), face.NormalAt(found[1], found[2]))
    return near


def SurfaceCurvature(surface_id, parameter):
    """(point, normal, largest curvature, its direction, smallest, its direction, Gaussian, mean)."""
    u, v = _uv(parameter)
    found = coercesurface(surface_id, True).CurvatureAt(u, v)
    if found is None:
        return None
    return (found.Point, found.Normal, found.Kappa(0), found.Direction(0), found.Kappa(1), found.Direction(1),
            found.Gaussian, found.Mean)


def SurfaceDegree(surface_id, direction=2):
    surface = coercesurface(surface_id, True)
    return (surface.Degree(0), surface.Degree(1)) if direction == 2 else surface.Degree(direction)


def SurfacePoints(surface_id, return_all=True):
    nurbs = coercesurface(surface_id, True).ToNurbsSurface()
    return [getattr(point, "Location", point) for point in nurbs.Points]


def SurfacePointCount(surface_id):
    nurbs = coercesurface(surface_id, True).ToNurbsSurface()
    return nurbs.Points.CountU, nurbs.Points.CountV


def _area(thing):
    return static_call("AreaMassProperties", "Compute", thing)


def Area(object_id):
    """Of a closed planar curve, a surface, a Brep, a mesh or a hatch."""
    found = _area(coercegeometry(object_id, True))
    if found is None:
        raise ValueError("the object has no area")
    return found.Area


def SurfaceArea(object_id):
    """(area, error)."""
    found = _area(coercegeometry(object_id, True))
    return (found.Area, getattr(found, "AreaError", 0.0)) if found is not None else None


def SurfaceAreaCentroid(object_id):
    """(centroid, error)."""
    found = _area(coercegeometry(object_id, True))
    return (found.Centroid, getattr(found, "CentroidError", Vector3d.Zero)) if found is not None else None


def SurfaceVolume(object_id):
    """(volume, error) of a solid; None where it is open."""
    found = static_call("VolumeMassProperties", "Compute", coercegeometry(object_id, True))
    return (found.Volume, getattr(found, "VolumeError", 0.0)) if found is not None else None


def SurfaceVolumeCentroid(object_id):
    found = static_call("VolumeMassProperties", "Compute", coercegeometry(object_id, True))
    return (found.Centroid, getattr(found, "CentroidError", Vector3d.Zero)) if found is not None else None


def IsBrep(object_id):
    return isinstance(coercegeometry(object_id), CLASSES["Brep"])


def IsSurface(object_id):
    geometry = coercegeometry(object_id)
    if isinstance(geometry, CLASSES["Brep"]):
        return len(geometry.Faces) == 1
    return isinstance(geometry, CLASSES["Surface"])


def IsPolysurface(object_id):
    geometry = coercegeometry(object_id)
    return isinstance(geometry, CLASSES["Brep"]) and len(geometry.Faces) > 1


def IsPolysurfaceClosed(object_id):
    return bool(coercebrep(object_id, True).IsSolid)


def IsSurfaceClosed(surface_id, direction):
    return bool(coercesurface(surface_id, True).IsClosed(direction))


def IsSurfacePeriodic(surface_id, direction):
    return bool(coercesurface(surface_id, True).IsPeriodic(direction))


def IsSurfacePlanar(surface_id, tolerance=None):
    limit = scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None else tolerance
    return bool(coercesurface(surface_id, True).IsPlanar(limit))


def IsSurfaceSphere(surface_id):
    return bool(coercesurface(surface_id, True).IsSphere())


def IsSurfaceSingular(surface_id, direction):
    return bool(coercesurface(surface_id, True).IsSingular(direction))


def IsPointOnSurface(object_id, point):
    surface, test = coercesurface(object_id, True), coerce3dpoint(point, True)
    found = surface.ClosestPoint(test)
    return bool(found and found[0]) and surface.PointAt(found[1], found[2]).DistanceTo(test) <= tolerance()


def IsPointInSurface(object_id, point, strictly_in=False, tolerance=None):
    limit = 1.490116119385e-8 if tolerance is None else tolerance
    geometry, test = coercegeometry(object_id, True), coerce3dpoint(point, True)
    return bool(geometry.IsPointInside(test, limit, bool(strictly_in)))


def SurfaceSphere(surface_id):
    found, sphere = coercesurface(surface_id, True).TryGetSphere(tolerance())
    return (sphere.EquatorialPlane, sphere.Radius) if found else None


def IntersectBreps(brep1, brep2, tolerance=None):
    """The Guids of the curves."""
    limit = scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None else tolerance
    found = static_call("Intersection", "BrepBrep", coercebrep(brep1, True), coercebrep(brep2, True), limit)
    return all_added(found[1]) if found and found[0] else None


def CurveSurfaceIntersection(curve_id, surface_id, tolerance=-1, angle_tolerance=-1):
    from .curves_ask import event_rows
    limit = scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None or tolerance <= 0 else tolerance
    events = static_call("Intersection", "CurveSurface", coercecurve(curve_id, -1, True), coercesurface(surface_id, True),
                         limit, limit)
    return event_rows(events)


def AddSrfContourCrvs(object_id, points_or_plane, interval=None):
    """Section curves with a plane, or with planes between two points."""
    geometry, plane = coercegeometry(object_id, True), coerceplane(points_or_plane)
    name = "Mesh" if isinstance(geometry, CLASSES["Mesh"]) else "Brep"
    if name == "Brep":
        geometry = coercebrep(object_id, True)
    if plane is not None:
        arguments = (plane,)
    else:
        a, b = [coerce3dpoint(one, True) for one in points_or_plane]
        arguments = (a, b, a.DistanceTo(b) if interval is None else float(interval))
    return all_added(static_call(name, "CreateContourCurves", geometry, *arguments)) or []


# Meshes.
def IsMesh(object_id):
    return coercemesh(object_id) is not None


def MeshVertices(object_id):
    return list(coercemesh(object_id, True).Vertices.ToPoint3dArray())


def MeshFaceVertices(object_id):
    return [tuple(face) for face in coercemesh(object_id, True).Faces]


def MeshFaces(object_id, face_type=True):
    """Corner points, four (or three) for each face in one list."""
    mesh, found = coercemesh(object_id, True), []
    points = mesh.Vertices.ToPoint3dArray()
    for face in mesh.Faces:
        corners = list(face)
        if face_type:
            found += [points[i] for i in corners]
        else:
            found += [points[i] for i in corners[:3]]
            if face.IsQuad:
                found += [points[i] for i in (corners[2], corners[3], corners[0])]
    return found


def MeshVertexCount(object_id):
    return len(coercemesh(object_id, True).Vertices)


def MeshFaceCount(object_id):
    return len(coercemesh(object_id, True).Faces)


def MeshVertexNormals(mesh_id):
    from katydid.values import Vector3d
    return [Vector3d(normal) for normal in coercemesh(mesh_id, True).Normals]


def MeshFaceCenters(mesh_id):
    from katydid.values import Point3d
    mesh, centres = coercemesh(mesh_id, True), []
    points = mesh.Vertices.ToPoint3dArray()
    for face in mesh.Faces:
        corners = list(face)[:3] if face.IsTriangle else list(face)
        total = sum((points[i] - Point3d.Origin for i in corners), Point3d.Origin - Point3d.Origin)
        centres.append(Point3d(total / len(corners)))
    return centres


def MeshArea(object_ids):
    """(count, area, error) of all meshes."""
    meshes = [coercemesh(one, True) for one in (object_ids if is_many(object_ids) else [object_ids])]
    found = [_area(mesh) for mesh in meshes]
    return len(meshes), sum(one.Area for one in found), 0.0


def MeshVolume(object_ids):
    meshes = [coercemesh(one, True) for one in (object_ids if is_many(object_ids) else [object_ids])]
    found = [static_call("VolumeMassProperties", "Compute", mesh) for mesh in meshes]
    return len(meshes), sum(one.Volume for one in found), 0.0


def IsMeshClosed(object_id):
    return bool(coercemesh(object_id, True).IsClosed)


def MeshClosestPoint(object_id, point, maximum_distance=None):
    """(point, face index)."""
    mesh, test = coercemesh(object_id, True), coerce3dpoint(point, True)
    found = mesh.ClosestMeshPoint(test, float(maximum_distance or 0.0))
    return (found.Point, found.FaceIndex) if found is not None else None


def MeshOutline(object_ids, view=None):
    from katydid.values import Plane
    meshes = [coercemesh(one, True) for one in (object_ids if is_many(object_ids) else [object_ids])]
    guids = []
    for mesh in meshes:
        guids += all_added(mesh.GetOutlines(Plane.WorldXY)) or []
    return guids


def DuplicateMeshBorder(mesh_id):
    return all_added(coercemesh(mesh_id, True).GetNakedEdges()) or []

