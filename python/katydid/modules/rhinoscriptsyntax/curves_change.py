"""Curves that are changed under their Guid, extended and contoured, and ellipses asked for their parts."""

import scriptcontext
from katydid.geometry import CLASSES, as_curve, static_call
from katydid.values import Ellipse, Plane
from katydid.values.enums import Continuity, CurveEnd, CurveExtensionStyle

from .coerce import (coerce3dpoint, coerce3dpointlist, coerce3dvector, coercebrep, coercecurve, coercegeometry,
                     coerceguid, coercesurface)
from .support import added, all_added, is_many, radians, tolerance


def _kept(curve_id, curve):
    """Puts a curve in the place of what a Guid stands for; whether it did."""
    guid = coerceguid(curve_id)
    return curve is not None and guid is not None and scriptcontext.doc.Objects.Replace(guid, curve)


def AddEllipse3Pt(center, second, third):
    """With the first radius to the second point, and the second one towards the third."""
    plane = Plane(coerce3dpoint(center, True), coerce3dpoint(second, True), coerce3dpoint(third, True))
    first = plane.Origin.DistanceTo(coerce3dpoint(second))
    return added(as_curve(Ellipse(plane, first, plane.Origin.DistanceTo(coerce3dpoint(third)))))


def _ellipse(curve_id):
    done, ellipse = coercecurve(curve_id, -1, True).TryGetEllipse()
    if not done:
        raise ValueError("curve is not an ellipse")
    return ellipse


def EllipseCenterPoint(curve_id):
    return _ellipse(curve_id).Plane.Origin


def EllipseQuadPoints(curve_id):
    """The ends of the two axes: of the first, then of the second."""
    own = _ellipse(curve_id)
    x, y = own.Plane.XAxis * own.Radius1, own.Plane.YAxis * own.Radius2
    return (own.Plane.Origin - x, own.Plane.Origin + x, own.Plane.Origin - y, own.Plane.Origin + y)


def CurveDim(curve_id, segment_index=-1):
    return coercecurve(curve_id, segment_index, True).Dimension


def CurveKnotCount(curve_id, segment_index=-1):
    return len(coercecurve(curve_id, segment_index, True).ToNurbsCurve().Knots)


def CurveDiscontinuity(curve_id, style):
    """Points at which a curve is not as smooth as `style` says: 1 C0, 2 C1, 3 C2, 4 G1, 5 G2."""
    curve, kinds = coercecurve(curve_id, -1, True), (1, 2, 3, 4, 5)
    if style not in kinds:
        raise ValueError("style is 1 to 5, not %s" % style)
    domain, found = curve.Domain, []
    at = domain.T0
    while True:
        done, at = curve.GetNextDiscontinuity(Continuity(int(style)), at, domain.T1)
        if not done:
            return found
        found.append(curve.PointAt(at))


def CurveContourPoints(curve_id, start_point, end_point, interval=None):
    """Points in which planes across a line, a distance apart, meet a curve."""
    start, end = coerce3dpoint(start_point, True), coerce3dpoint(end_point, True)
    distance = start.DistanceTo(end)
    step = float(interval) if interval else distance / 50.0
    if not (distance > 0.0 and step > 0.0):
        raise ValueError("start and end points are too close to each other")
    return list(coercecurve(curve_id, -1, True).DivideAsContour(start, end, step))


def CurveClosestObject(curve_id, object_ids):
    """(Guid, point on the object, point on the curve) of the curve or point that is nearest."""
    curve, best = coercecurve(curve_id, -1, True), None
    for one in object_ids if is_many(object_ids) else [object_ids]:
        thing = coercegeometry(one, True)
        if type(thing).__name__ == "Point":
            ends = thing.Location, curve.PointAt(curve.ClosestPoint(thing.Location)[1])
        else:
            done, on_curve, on_object = curve.ClosestPoints(coercecurve(thing, -1, True))
            ends = on_object, on_curve
        distance = ends[0].DistanceTo(ends[1])
        if best is None or distance < best[0]:
            best = distance, coerceguid(one), ends[0], ends[1]
    return None if best is None else best[1:]


def ChangeCurveDegree(object_id, degree):
    """Raises the degree; whether it was done."""
    curve = coercecurve(object_id, -1, True).ToNurbsCurve()
    return bool(curve.IncreaseDegree(int(degree))) and _kept(object_id, curve)


def CloseCurve(curve_id, tolerance=-1.0):
    """A closed copy of a curve whose ends are near each other."""
    from .support import tolerance as usual
    curve = coercecurve(curve_id, -1, True)
    if curve.IsClosed:
        return coerceguid(curve_id)
    made = curve.Duplicate()
    return added(made) if made.MakeClosed(usual() if tolerance < 0 else float(tolerance)) else None


_STYLES = (CurveExtensionStyle.Line, CurveExtensionStyle.Arc, CurveExtensionStyle.Smooth)
_SIDES = (CurveEnd.Start, CurveEnd.End, CurveEnd.Both)


def ExtendCurve(curve_id, extension_type, side, boundary_object_ids):
    """To other objects: `extension_type` 0 by a line, 1 by an arc, 2 smoothly; `side` 0 at the start, 1 at the end, 2 both."""
    curve = coercecurve(curve_id, -1, True)
    many = boundary_object_ids if is_many(boundary_object_ids) else [boundary_object_ids]
    made = curve.Extend(_SIDES[side], _STYLES[extension_type], [coercegeometry(one, True) for one in many])
    return coerceguid(curve_id) if _kept(curve_id, made) else None


def ExtendCurvePoint(curve_id, side, point, extension_type=2):
    """To a point."""
    made = coercecurve(curve_id, -1, True).Extend(_SIDES[side], _STYLES[extension_type], coerce3dpoint(point, True))
    return coerceguid(curve_id) if _kept(curve_id, made) else None


def FitCurve(curve_id, degree=3, distance_tolerance=-1, angle_tolerance=-1):
    """A curve of a degree that fits another within a distance."""
    from .support import angle_tolerance as usual_angle
    within = tolerance() if distance_tolerance is None or distance_tolerance < 0 else float(distance_tolerance)
    turn = usual_angle() if angle_tolerance is None or angle_tolerance < 0 else radians(angle_tolerance)
    return added(coercecurve(curve_id, -1, True).Fit(int(degree), within, turn))


def SmoothCurve(object_id, x_axis=True, y_axis=True, z_axis=True, fix=True, factor=0.2, coordinate_system=0):
    made = coercecurve(object_id, -1, True).Smooth(float(factor), bool(x_axis), bool(y_axis), bool(z_axis), bool(fix),
                                                   int(coordinate_system))
    return _kept(object_id, made)


def CurveFilletPoints(curve_id_0, curve_id_1, radius=1.0, base_point_0=None, base_point_1=None, return_points=True):
    """(end on the first curve, end on the second, centre, normal) of an arc that rounds two lines in a plane."""
    from katydid.values import Vector3d
    first, second = coercecurve(curve_id_0, -1, True), coercecurve(curve_id_1, -1, True)
    # Near the ends that are nearest each other, where no points are given.
    if base_point_0 is None or base_point_1 is None:
        ends = [(a.DistanceTo(b), a, b) for a in (first.PointAtStart, first.PointAtEnd)
                for b in (second.PointAtStart, second.PointAtEnd)]
        near = min(ends, key=lambda row: row[0])
        middle = [curve.PointAt(curve.Domain.Mid) for curve in (first, second)]
        base_point_0, base_point_1 = near[1] + (middle[0] - near[1]) * 0.5, near[2] + (middle[1] - near[2]) * 0.5
    parameters = [curve.ClosestPoint(coerce3dpoint(point, True))[1]
                  for curve, point in ((first, base_point_0), (second, base_point_1))]
    arc = static_call("Curve", "CreateFillet", first, second, float(radius), *parameters)
    if arc is None or (isinstance(arc, tuple) and not arc[0]):
        return None
    arc = arc[-1] if isinstance(arc, tuple) else arc
    if isinstance(arc, CLASSES["Curve"]):
        arc = arc.TryGetArc()[1]
    if not return_points:
        return tuple(parameters)
    return arc.StartPoint, arc.EndPoint, arc.Center, Vector3d(arc.Plane.ZAxis)


def PullCurve(surface_id, curve_id, delete_input=False):
    """A curve at the nearest points of a surface."""
    curve, surface = coercecurve(curve_id, -1, True), coercesurface(surface_id, True)
    face = surface if isinstance(surface, CLASSES["BrepFace"]) else surface.ToBrep().Faces[0]
    made = all_added(curve.PullToBrepFace(face, tolerance())) or []
    if made and delete_input:
        scriptcontext.doc.Objects.Delete(coerceguid(curve_id))
    return made


def ProjectPointToSurface(points, surface_ids, direction):
    """Where points meet surfaces along a direction."""
    many = coerce3dpointlist(points if coerce3dpoint(points) is None else [points], True)
    breps = [coercebrep(one, True) for one in (surface_ids if is_many(surface_ids) else [surface_ids])]
    found = static_call("Intersection", "ProjectPointsToBreps", breps, many, coerce3dvector(direction, True), tolerance())
    return list(found or ())


def ProjectPointToMesh(points, mesh_ids, direction):
    from .coerce import coercemesh
    many = coerce3dpointlist(points if coerce3dpoint(points) is None else [points], True)
    meshes = [coercemesh(one, True) for one in (mesh_ids if is_many(mesh_ids) else [mesh_ids])]
    found = static_call("Intersection", "ProjectPointsToMeshes", meshes, many, coerce3dvector(direction, True), tolerance())
    return list(found or ())
