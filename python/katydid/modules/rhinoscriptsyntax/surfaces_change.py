"""Surfaces: what kind they are, and what changes them under their Guid."""

import scriptcontext
from katydid.geometry import CLASSES, static_call
from katydid.values import Interval, Point2d
from katydid.values.enums import IsoStatus

from .coerce import coerce3dpoint, coerce3dvector, coercebrep, coerceguid, coerceplane, coercesurface
from .support import added, all_added, is_many, tolerance


def _kept(surface_id, surface):
    """Puts a surface in the place of what a Guid stands for; whether it did."""
    guid = coerceguid(surface_id)
    return surface is not None and guid is not None and scriptcontext.doc.Objects.Replace(guid, surface)


def _whole(surface_id):
    """A surface without its trims."""
    surface = coercesurface(surface_id, True)
    return surface.DuplicateSurface() if isinstance(surface, CLASSES["BrepFace"]) else surface


def IsSphere(object_id):
    return bool(coercesurface(object_id, True).IsSphere())


def IsCylinder(object_id):
    return bool(coercesurface(object_id, True).IsCylinder())


def IsCone(object_id):
    return bool(coercesurface(object_id, True).IsCone())


def IsTorus(object_id):
    return bool(coercesurface(object_id, True).IsTorus())


def IsPlaneSurface(object_id):
    return isinstance(_whole(object_id), CLASSES["PlaneSurface"])


def IsSurfaceRational(surface_id):
    return bool(coercesurface(surface_id, True).ToNurbsSurface().IsRational)


def IsSurfaceTrimmed(surface_id):
    """Whether a surface is bounded by more than its own sides."""
    surface = coercesurface(surface_id, True)
    return isinstance(surface, CLASSES["BrepFace"]) and not surface.IsSurface


def SurfaceCylinder(surface_id):
    """(plane, height, radius), None where it is no cylinder."""
    done, found = coercesurface(surface_id, True).TryGetCylinder()
    if not done:
        return None
    circle = found.CircleAt(found.Height1)
    return circle.Plane, found.Height2 - found.Height1, found.Radius


def SurfaceCone(surface_id):
    """(plane, height, radius), None where it is no cone."""
    done, found = coercesurface(surface_id, True).TryGetCone()
    return (found.Plane, found.Height, found.Radius) if done else None


def SurfaceTorus(surface_id):
    """(plane, major radius, minor radius), None where it is no torus."""
    done, found = coercesurface(surface_id, True).TryGetTorus()
    return (found.Plane, found.MajorRadius, found.MinorRadius) if done else None


def SurfaceKnots(surface_id):
    """The knots along u, and those along v."""
    nurbs = coercesurface(surface_id, True).ToNurbsSurface()
    return list(nurbs.KnotsU), list(nurbs.KnotsV)


def SurfaceKnotCount(surface_id):
    return tuple(map(len, SurfaceKnots(surface_id)))


def SurfaceWeights(object_id):
    return [point.Weight for point in coercesurface(object_id, True).ToNurbsSurface().Points]


def SurfaceEditPoints(surface_id, return_parameters=False, return_all=True):
    """The points at the Greville parameters of the control points, or those parameters."""
    surface = coercesurface(surface_id, True)
    nurbs = surface.ToNurbsSurface()
    points = nurbs.Points
    count_u, count_v = points.CountU, points.CountV
    rows = [range(count_u), range(count_v)]
    if not return_all:
        # Without the last ones where the surface is closed: they are the first ones again.
        rows = [range(count - (1 if surface.IsClosed(along) else 0)) for along, count in enumerate((count_u, count_v))]
    found = [points.GetGrevillePoint(i, j) for i in rows[0] for j in rows[1]]
    return [(one.X, one.Y) for one in found] if return_parameters else [surface.PointAt(one.X, one.Y) for one in found]


def SurfaceEvaluate(surface_id, parameter, derivative):
    """The point and the derivatives up to an order."""
    found = coercesurface(surface_id, True).Evaluate(float(parameter[0]), float(parameter[1]), int(derivative))
    return [found[1]] + list(found[2]) if found[0] else None


def ChangeSurfaceDegree(object_id, degree):
    """Raises the degrees along u and v; whether it was done."""
    nurbs = coercesurface(object_id, True).ToNurbsSurface()
    done = [nurbs.IncreaseDegreeU(int(degree[0])), nurbs.IncreaseDegreeV(int(degree[1]))]
    return all(done) and _kept(object_id, nurbs)


def ExtendSurface(surface_id, parameter, length, smooth=True):
    """Beyond the side that is nearest to a parameter."""
    surface = _whole(surface_id)
    side = surface.ClosestSide(float(parameter[0]), float(parameter[1]))
    return _kept(surface_id, surface.Extend(IsoStatus(int(side)), float(length), bool(smooth)))


def ReverseSurface(surface_id, direction):
    """Along u where `direction` has 1, along v where it has 2; 4 exchanges them."""
    surface = _whole(surface_id)
    if direction & 1:
        surface = surface.Reverse(0)
    if direction & 2:
        surface = surface.Reverse(1)
    if direction & 4:
        surface = surface.Transpose()
    return _kept(surface_id, surface)


def ShortPath(surface_id, start_point, end_point):
    """The shortest curve on a surface between two points."""
    surface = coercesurface(surface_id, True)
    ends = []
    for point in (start_point, end_point):
        done, u, v = surface.ClosestPoint(coerce3dpoint(point, True))
        if not done:
            return None
        ends.append(Point2d(u, v))
    return added(surface.ShortPath(ends[0], ends[1], tolerance()))


def ShootRay(surface_ids, start_point, direction, reflections=10):
    """The points of a ray that is thrown back by surfaces; its start first."""
    from katydid.values import Ray3d
    start = coerce3dpoint(start_point, True)
    breps = [coercebrep(one, True) for one in (surface_ids if is_many(surface_ids) else [surface_ids])]
    found = static_call("Intersection", "RayShoot", Ray3d(start, coerce3dvector(direction, True)), breps, int(reflections))
    return [start] + list(found or ())


def AddCutPlane(object_ids, start_point, end_point, normal=None):
    """A plane through two points, upright on the construction plane or along a vector, as large as the objects."""
    from katydid.values import BoundingBox, Plane, Vector3d
    from .objects import BoundingBox_
    many = object_ids if is_many(object_ids) else [object_ids]
    start, end = coerce3dpoint(start_point, True), coerce3dpoint(end_point, True)
    up = Vector3d.ZAxis if normal is None else coerce3dvector(normal, True)
    plane = Plane(start, end - start, up)
    # The corners of the objects' box in coordinates of the plane.
    box = BoundingBox(BoundingBox_(many))
    coordinates = [plane.RemapToPlaneSpace(corner)[1] for corner in box.GetCorners()]
    sides = [Interval(min(getattr(point, name) for point in coordinates), max(getattr(point, name) for point in coordinates))
             for name in ("X", "Y")]
    from katydid.geometry import construct
    return added(construct("PlaneSurface", plane, *sides))


def AddSrfSectionCrvs(object_id, plane):
    """The curves in which a plane cuts a surface."""
    cut = coerceplane(plane, True)
    found = static_call("Intersection", "BrepPlane", coercebrep(object_id, True), cut, tolerance())
    return all_added(found[1] if isinstance(found, tuple) and found[0] else None) or []
