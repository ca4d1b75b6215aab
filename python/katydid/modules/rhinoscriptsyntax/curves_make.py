"""Points and curves that are added to the document."""

import scriptcontext
from katydid.geometry import construct, static_call
from katydid.values import Arc, Circle, Ellipse, Line, Plane, Point3d, Polyline, Rectangle3d
from katydid.values.enums import CurveKnotStyle

from .coerce import (_plane_or_point, coerce3dpoint, coerce3dpointlist, coerce3dvector, coercecurve, coerceguid,
                     coerceguidlist, coercesurface)
from .support import added, all_added, is_many, radians, tolerance


def AddPoint(point, y=None, z=None):
    if y is not None:
        point = Point3d(float(point), float(y), float(z or 0.0))
    return added(coerce3dpoint(point, True))


def AddPoints(points):
    return [added(point) for point in coerce3dpointlist(points, True)]


def AddPointCloud(points, colors=None):
    return added(construct("PointCloud", coerce3dpointlist(points, True)))


def AddLine(start, end):
    a, b = coerce3dpoint(start, True), coerce3dpoint(end, True)
    if a.DistanceTo(b) == 0.0:
        raise ValueError("Unable to add line to document: its ends are the same point")
    return added(Line(a, b))


def AddPolyline(points, replace_id=None):
    made = Polyline(coerce3dpointlist(points, True))
    if len(made) < 2:
        return None
    if replace_id is not None:
        guid = coerceguid(replace_id, True)
        return guid if scriptcontext.doc.Objects.Replace(guid, made) else None
    return added(made)


def AddRectangle(plane, width, height):
    frame = _plane_or_point(plane)
    return added(Rectangle3d(frame, float(width), float(height)).ToPolyline())


def AddCircle(plane_or_center, radius):
    if not float(radius) > 0.0:
        raise ValueError("a circle's radius is above 0, not %s" % radius)
    return added(Circle(_plane_or_point(plane_or_center), float(radius)))


def AddCircle3Pt(first, second, third):
    made = Circle(*[coerce3dpoint(one, True) for one in (first, second, third)])
    return added(made) if made.IsValid else None


def AddArc(plane, radius, angle_degrees):
    return added(Arc(_plane_or_point(plane), float(radius), radians(angle_degrees)))


def AddArc3Pt(start, end, point_on_arc):
    made = Arc(coerce3dpoint(start, True), coerce3dpoint(point_on_arc, True), coerce3dpoint(end, True))
    return added(made) if made.IsValid else None


def AddArcPtTanPt(start, direction, end):
    made = Arc(coerce3dpoint(start, True), coerce3dvector(direction, True), coerce3dpoint(end, True))
    return added(made) if made.IsValid else None


def AddEllipse(plane, radiusX, radiusY):
    return added(Ellipse(_plane_or_point(plane), float(radiusX), float(radiusY)))


def AddCurve(points, degree=3):
    """A curve by control points."""
    return added(static_call("Curve", "CreateControlPointCurve", coerce3dpointlist(points, True), int(degree)))


def AddInterpCurve(points, degree=3, knotstyle=0, start_tangent=None, end_tangent=None):
    """A curve through points."""
    found, style = coerce3dpointlist(points, True), CurveKnotStyle(int(knotstyle))
    arguments = [found, int(degree), style]
    if start_tangent is not None or end_tangent is not None:
        from katydid.values import Vector3d
        arguments += [coerce3dvector(one, True) if one is not None else Vector3d.Unset
                      for one in (start_tangent, end_tangent)]
    return added(static_call("Curve", "CreateInterpolatedCurve", *arguments))


def AddNurbsCurve(points, knots, degree, weights=None):
    """By control points and knots; the points are rational where weights are given."""
    found = coerce3dpointlist(points, True)
    if len(knots) != len(found) + degree - 1:
        raise ValueError("a curve of degree %d with %d points has %d knots, not %d" % (
            degree, len(found), len(found) + degree - 1, len(knots)))
    made = construct("NurbsCurve", 3, weights is not None, int(degree) + 1, len(found))
    for i, point in enumerate(found):
        if weights is None:
            made.Points.SetPoint(i, point)
        else:
            made.Points.SetPoint(i, point, float(weights[i]))
    for i, knot in enumerate(knots):
        made.Knots[i] = float(knot)
    return added(made)


def AddBlendCurve(curves, parameters, reverses, continuities):
    from katydid.values.enums import BlendContinuity
    a, b = [coercecurve(one, -1, True) for one in curves]
    kinds = [BlendContinuity(int(one)) for one in continuities]
    return added(static_call("Curve", "CreateBlendCurve", a, float(parameters[0]), bool(reverses[0]), kinds[0], b,
                             float(parameters[1]), bool(reverses[1]), kinds[1]))


def AddFilletCurve(curve0id, curve1id, radius=1.0, base_point0=None, base_point1=None):
    """The fillet of two curves, near a point on each."""
    a, b = coercecurve(curve0id, -1, True), coercecurve(curve1id, -1, True)

    def near(curve, base):
        if base is None:
            return curve.PointAtEnd if curve is a else curve.PointAtStart
        return coerce3dpoint(base, True)
    made = static_call("Curve", "CreateFilletCurves", a, near(a, base_point0), b, near(b, base_point1), float(radius),
                       False, False, True, tolerance(), scriptcontext.doc.ModelAngleToleranceRadians)
    guids = all_added(made)
    return guids[0] if guids else None


def AddSpiral(point0, point1, pitch, turns, radius0, radius1=None):
    axis_start, axis_end = coerce3dpoint(point0, True), coerce3dpoint(point1, True)
    along = axis_end - axis_start
    across = Plane(axis_start, along).XAxis
    return added(static_call("NurbsCurve", "CreateSpiral", axis_start, along, axis_start + across, float(pitch),
                             float(turns), float(radius0), float(radius0 if radius1 is None else radius1)))


def OffsetCurve(object_id, direction, distance, normal=None, style=1):
    """To the side of a point, in the curve's plane or that of a normal. A list of Guids."""
    curve = coercecurve(object_id, -1, True)
    side, up = coerce3dpoint(direction, True), coerce3dvector(normal, True) if normal is not None else None
    from katydid.values.enums import CurveOffsetCornerStyle
    if up is None:
        found, plane = curve.TryGetPlane()
        up = plane.ZAxis if found else Plane.WorldXY.ZAxis
    made = curve.Offset(side, up, float(distance), tolerance(), CurveOffsetCornerStyle(int(style)))
    return all_added(made)


def OffsetCurveOnSurface(curve_id, surface_id, distance_or_parameter):
    curve, surface = coercecurve(curve_id, -1, True), coercesurface(surface_id, True)
    return all_added(curve.OffsetOnSurface(surface, distance_or_parameter, tolerance()))


def JoinCurves(object_ids, delete_input=False, tolerance=None):
    ids = object_ids if is_many(object_ids) else [object_ids]
    curves = [coercecurve(one, -1, True) for one in ids]
    limit = 2.1 * scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None else tolerance
    made = static_call("Curve", "JoinCurves", curves, limit)
    if delete_input and made:
        _delete(ids)
    return all_added(made) or []


def ExplodeCurves(curve_ids, delete_input=False):
    ids = curve_ids if is_many(curve_ids) else [curve_ids]
    guids = []
    for one in ids:
        pieces = coercecurve(one, -1, True).DuplicateSegments()
        guids += all_added(pieces) or []
    if delete_input:
        _delete(ids)
    return guids


def _delete(ids):
    for guid in coerceguidlist(ids):
        scriptcontext.doc.Objects.Delete(guid)


def SplitCurve(curve_id, parameter, delete_input=True):
    """The Guids of the pieces."""
    curve = coercecurve(curve_id, -1, True)
    at = [float(one) for one in parameter] if hasattr(parameter, "__iter__") else float(parameter)
    made = all_added(curve.Split(at))
    if made and delete_input:
        _delete([curve_id])
    return made


def TrimCurve(curve_id, interval, delete_input=True):
    """The part between two parameters."""
    made = added(coercecurve(curve_id, -1, True).Trim(float(interval[0]), float(interval[1])))
    if made and delete_input:
        _delete([curve_id])
    return made


def ExtendCurveLength(curve_id, extension_type, side, length):
    """0 by a line, 1 by an arc, 2 smoothly; side 0 the start, 1 the end, 2 both."""
    from katydid.values.enums import CurveEnd, CurveExtensionStyle
    curve = coercecurve(curve_id, -1, True)
    kind = CurveExtensionStyle(int(extension_type))
    end = (CurveEnd.Start, CurveEnd.End, CurveEnd.Both)[int(side)]
    made = curve.Extend(end, float(length), kind)
    return _replaced(curve_id, made)


def RebuildCurve(curve_id, degree=3, point_count=10):
    made = coercecurve(curve_id, -1, True).Rebuild(int(point_count), int(degree), False)
    return _replaced(curve_id, made) is not None


def SimplifyCurve(curve_id, flags=0):
    made = coercecurve(curve_id, -1, True).Simplify(63, tolerance(), scriptcontext.doc.ModelAngleToleranceRadians)
    return made is not None and _replaced(curve_id, made) is not None


def ReverseCurve(curve_id):
    curve = coercecurve(curve_id, -1, True).DuplicateCurve()
    return bool(curve.Reverse() is not False) and _replaced(curve_id, curve) is not None


def CurveSeam(curve_id, parameter):
    curve = coercecurve(curve_id, -1, True).DuplicateCurve()
    return bool(curve.ChangeClosedCurveSeam(float(parameter))) and _replaced(curve_id, curve) is not None


def _replaced(curve_id, made):
    """Puts a new curve under the Guid of the old one."""
    if made is None:
        return None
    guid = coerceguid(curve_id)
    if guid is None:
        return added(made)
    return guid if scriptcontext.doc.Objects.Replace(guid, made) else None


def ConvertCurveToPolyline(curve_id, angle_tolerance=5.0, tolerance=0.01, delete_input=False, min_edge_length=0,
                           max_edge_length=0):
    curve = coercecurve(curve_id, -1, True)
    made = curve.ToPolyline(0, 0, radians(angle_tolerance), 0, 0, tolerance, min_edge_length, max_edge_length, True)
    guid = added(made)
    if guid and delete_input:
        _delete([curve_id])
    return guid


def ProjectCurveToSurface(curve_ids, surface_ids, direction):
    curves = [coercecurve(one, -1, True) for one in (curve_ids if is_many(curve_ids) else [curve_ids])]
    from .coerce import coercebrep
    breps = [coercebrep(one, True) for one in (surface_ids if is_many(surface_ids) else [surface_ids])]
    made = static_call("Curve", "ProjectToBrep", curves, breps, coerce3dvector(direction, True), tolerance())
    return all_added(made) or []


def ProjectCurveToMesh(curve_ids, mesh_ids, direction):
    from .coerce import coercemesh
    curves = [coercecurve(one, -1, True) for one in (curve_ids if is_many(curve_ids) else [curve_ids])]
    meshes = [coercemesh(one, True) for one in (mesh_ids if is_many(mesh_ids) else [mesh_ids])]
    made = static_call("Curve", "ProjectToMesh", curves, meshes, coerce3dvector(direction, True), tolerance())
    return all_added(made) or []


def MeanCurve(curve0, curve1, tolerance=None):
    a, b = coercecurve(curve0, -1, True), coercecurve(curve1, -1, True)
    more = () if tolerance is None else (float(tolerance),)
    return added(static_call("Curve", "CreateMeanCurve", a, b, *more))


def AddTweenCurves(from_curve_id, to_curve_id, number_of_curves=1, method=0, sample_number=10):
    a, b = coercecurve(from_curve_id, -1, True), coercecurve(to_curve_id, -1, True)
    name, more = (("CreateTweenCurves", ()), ("CreateTweenCurvesWithMatching", ()),
                  ("CreateTweenCurvesWithSampling", (int(sample_number),)))[method]
    return all_added(static_call("Curve", name, a, b, int(number_of_curves), *more + (tolerance(),)))


def CurveBooleanUnion(curve_id):
    curves = [coercecurve(one, -1, True) for one in curve_id]
    return all_added(static_call("Curve", "CreateBooleanUnion", curves, tolerance())) or []


def CurveBooleanDifference(curve_id_0, curve_id_1):
    cutters = [coercecurve(one, -1, True) for one in (curve_id_1 if is_many(curve_id_1) else [curve_id_1])]
    return all_added(static_call("Curve", "CreateBooleanDifference", coercecurve(curve_id_0, -1, True), cutters,
                                 tolerance())) or []


def CurveBooleanIntersection(curve_id_0, curve_id_1):
    a, b = coercecurve(curve_id_0, -1, True), coercecurve(curve_id_1, -1, True)
    return all_added(static_call("Curve", "CreateBooleanIntersection", a, b, tolerance())) or []


def AddSubCrv(curve_id, param0, param1):
    return added(coercecurve(curve_id, -1, True).Trim(float(param0), float(param1)))


def AddTextDot(text, point):
    return added(construct("TextDot", str(text), coerce3dpoint(point, True)))
