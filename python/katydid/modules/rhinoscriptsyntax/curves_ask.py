"""Questions to curves and points."""

import scriptcontext
from katydid.geometry import CLASSES, static_call
from katydid.values import Point3d, Polyline, Vector3d

from .coerce import (_stored, coerce3dpoint, coercebrep, coercecurve, coercegeometry, coerceplane)
from .support import added, degrees, is_many, tolerance


def PointCoordinates(object_id, segment_index=-1):
    """The point of a point object; None where it is none."""
    return coerce3dpoint(object_id)


def CurveDomain(curve_id, segment_index=-1):
    """[start, end]."""
    domain = coercecurve(curve_id, segment_index, True).Domain
    return [domain.Min, domain.Max]


def CurveLength(curve_id, segment_index=-1, sub_domain=None):
    curve = coercecurve(curve_id, segment_index, True)
    if sub_domain:
        from katydid.values import Interval
        return curve.GetLength(Interval(sub_domain[0], sub_domain[1]))
    return curve.GetLength()


def EvaluateCurve(curve_id, t, segment_index=-1):
    return coercecurve(curve_id, segment_index, True).PointAt(float(t))


def CurveTangent(curve_id, parameter, segment_index=-1):
    return coercecurve(curve_id, segment_index, True).TangentAt(float(parameter))


def CurveStartPoint(curve_id, segment_index=-1, point=None):
    return coercecurve(curve_id, segment_index, True).PointAtStart


def CurveEndPoint(curve_id, segment_index=-1):
    return coercecurve(curve_id, segment_index, True).PointAtEnd


def CurveMidPoint(curve_id, segment_index=-1):
    """The point at half the length."""
    curve = coercecurve(curve_id, segment_index, True)
    found = curve.NormalizedLengthParameter(0.5)
    t = found[1] if isinstance(found, tuple) else found
    return curve.PointAt(t)


def CurveParameter(curve_id, parameter):
    """The curve's own parameter of one from 0 to 1."""
    return coercecurve(curve_id, -1, True).Domain.ParameterAt(float(parameter))


def CurveNormalizedParameter(curve_id, parameter):
    return coercecurve(curve_id, -1, True).Domain.NormalizedParameterAt(float(parameter))


def DivideCurve(curve_id, segments, create_points=False, return_points=True):
    """Points (or parameters) that cut the curve in parts of the same length; None where that fails."""
    curve = coercecurve(curve_id, -1, True)
    return _divided(curve, curve.DivideByCount(int(segments), True), create_points, return_points)


def DivideCurveLength(curve_id, length, create_points=False, return_points=True):
    curve = coercecurve(curve_id, -1, True)
    return _divided(curve, curve.DivideByLength(float(length), True), create_points, return_points)


def _divided(curve, parameters, create_points, return_points):
    if isinstance(parameters, tuple):
        parameters = parameters[0]
    if not parameters:
        return None
    if not (create_points or return_points):
        return list(parameters)
    points = [curve.PointAt(t) for t in parameters]
    if create_points:
        for point in points:
            added(point)
    return points if return_points else list(parameters)


def DivideCurveEquidistant(curve_id, distance, create_points=False, return_points=True):
    curve = coercecurve(curve_id, -1, True)
    points = curve.DivideEquidistant(float(distance))
    if not points:
        return None
    if create_points:
        for point in points:
            added(point)
    return list(points) if return_points else [CurveClosestPoint(curve, point) for point in points]


def CurveClosestPoint(curve_id, test_point, segment_index=-1):
    """The parameter of the nearest point."""
    found = coercecurve(curve_id, segment_index, True).ClosestPoint(coerce3dpoint(test_point, True))
    if isinstance(found, tuple):
        return found[1] if found[0] else None
    return found


def CurveArcLengthPoint(curve_id, length, from_start=True):
    curve = coercecurve(curve_id, -1, True)
    at = float(length)
    if not from_start:
        at = curve.GetLength() - at
    point = curve.PointAtLength(at)
    return point if point.IsValid else None


def CurveCurvature(curve_id, parameter):
    """(point, tangent, centre of curvature, radius, curvature vector); None on a straight part."""
    curve, t = coercecurve(curve_id, -1, True), float(parameter)
    point, tangent, vector = curve.PointAt(t), curve.TangentAt(t), curve.CurvatureAt(t)
    size = vector.Length
    if size <= 1e-12:
        return None
    radius = 1.0 / size
    return point, tangent, point + vector * (radius * radius), radius, vector


def CurveFrame(curve_id, parameter, segment_index=-1):
    found = coercecurve(curve_id, segment_index, True).FrameAt(float(parameter))
    if isinstance(found, tuple):
        return found[1] if found[0] else None
    return found


def CurvePerpFrame(curve_id, parameter):
    found = coercecurve(curve_id, -1, True).PerpendicularFrameAt(float(parameter))
    if isinstance(found, tuple):
        return found[1] if found[0] else None
    return found


def CurveNormal(curve_id, segment_index=-1):
    found, plane = coercecurve(curve_id, segment_index, True).TryGetPlane(tolerance())
    return plane.Normal if found else None


def CurvePlane(curve_id, segment_index=-1):
    found, plane = coercecurve(curve_id, segment_index, True).TryGetPlane()
    return plane if found else None


def _area_of(curve_id):
    return static_call("AreaMassProperties", "Compute", coercecurve(curve_id, -1, True))


def CurveArea(curve_id):
    """(area, error)."""
    found = _area_of(curve_id)
    return (found.Area, getattr(found, "AreaError", 0.0)) if found is not None else None


def CurveAreaCentroid(curve_id):
    """(centroid, error)."""
    found = _area_of(curve_id)
    return (found.Centroid, getattr(found, "CentroidError", Vector3d.Zero)) if found is not None else None


def CurveDegree(curve_id, segment_index=-1):
    return coercecurve(curve_id, segment_index, True).Degree


def CurvePoints(curve_id, segment_index=-1):
    """The control points; those of a closed periodic curve without the ones that repeat."""
    nurbs = coercecurve(curve_id, segment_index, True).ToNurbsCurve()
    points = nurbs.Points
    return [getattr(point, "Location", point) if not isinstance(point, Point3d) else point for point in points]


def CurvePointCount(curve_id, segment_index=-1):
    return len(coercecurve(curve_id, segment_index, True).ToNurbsCurve().Points)


def CurveKnots(curve_id, segment_index=-1):
    return list(coercecurve(curve_id, segment_index, True).ToNurbsCurve().Knots)


def CurveWeights(curve_id, segment_index=-1):
    points = coercecurve(curve_id, segment_index, True).ToNurbsCurve().Points
    return [points.GetWeight(i) for i in range(len(points))]


def CurveEditPoints(curve_id, return_parameters=False, segment_index=-1):
    nurbs = coercecurve(curve_id, segment_index, True).ToNurbsCurve()
    return list(nurbs.GrevilleParameters()) if return_parameters else list(nurbs.GrevillePoints(True))


def PolylineVertices(curve_id, segment_index=-1):
    value = _stored(curve_id)
    if isinstance(value, Polyline):
        return [point._copy() for point in value]
    found = coercecurve(curve_id, segment_index, True).TryGetPolyline()
    if isinstance(found, tuple):
        return list(found[1]) if found[0] else None
    return list(found) if found else None


def CurveCurveIntersection(curveA, curveB=None, tolerance=-1):
    """Events as rows: 1 point or 2 overlap, points and parameters on both; None where there are none."""
    a = coercecurve(curveA, -1, True)
    limit = scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None or tolerance < 0 else tolerance
    if curveB is None or curveB is curveA:
        events = static_call("Intersection", "CurveSelf", a, limit)
    else:
        events = static_call("Intersection", "CurveCurve", a, coercecurve(curveB, -1, True), limit, 0.0)
    return event_rows(events)


def event_rows(events):
    """Intersection events in the form that scripts expect."""
    rows = []
    for event in events or ():
        overlap = event.IsOverlap
        row = [2 if overlap else 1, event.PointA, event.PointA2 if overlap else event.PointA, event.PointB,
               event.PointB2 if overlap else event.PointB]
        spans = (event.OverlapA, event.OverlapB) if overlap else None
        row += [spans[0][0], spans[0][1], spans[1][0], spans[1][1]] if overlap else [
            event.ParameterA, event.ParameterA, event.ParameterB, event.ParameterB]
        rows.append(tuple(row))
    return rows or None


def CurveBrepIntersect(curve_id, brep_id, tolerance=None):
    """(Guids of curves, Guids of points)."""
    from .support import all_added
    curve, brep = coercecurve(curve_id, -1, True), coercebrep(brep_id, True)
    limit = scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None else tolerance
    found = static_call("Intersection", "CurveBrep", curve, brep, limit)
    if not found or not found[0]:
        return None
    return all_added(found[1]) or [], [added(point) for point in found[2]]


def PlaneCurveIntersection(plane, curve, tolerance=None):
    limit = scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None else tolerance
    events = static_call("Intersection", "CurvePlane", coercecurve(curve, -1, True), coerceplane(plane, True), limit)
    return event_rows(events)


def ClosedCurveOrientation(curve_id, direction=(0, 0, 1)):
    from .coerce import coerce3dvector
    curve = coercecurve(curve_id, -1, True)
    return int(curve.ClosedCurveOrientation(coerce3dvector(direction, True))) if curve.IsClosed else 0


def PointInPlanarClosedCurve(point, curve, plane=None, tolerance=None):
    """0 outside, 1 inside, 2 on the curve; None where there is no answer."""
    limit = scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None else tolerance
    frame = coerceplane(plane) if plane is not None else None
    found = coercecurve(curve, -1, True)
    if frame is None:
        flat, frame = found.TryGetPlane()
        if not flat:
            return None
    kind = int(found.Contains(coerce3dpoint(point, True), frame, limit))
    return {0: None, 1: 1, 2: 0, 3: 2}[kind]


def PlanarClosedCurveContainment(curve_a, curve_b, plane=None, tolerance=None):
    """0 apart, 1 crossing, 2 a in b, 3 b in a."""
    from katydid.values import Plane
    limit = scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None else tolerance
    frame = coerceplane(plane) if plane is not None else Plane.WorldXY
    return int(static_call("Curve", "PlanarClosedCurveRelationship", coercecurve(curve_a, -1, True),
                           coercecurve(curve_b, -1, True), frame, limit))


def CurveDirectionsMatch(curve_id_0, curve_id_1):
    return static_call("Curve", "DoDirectionsMatch", coercecurve(curve_id_0, -1, True), coercecurve(curve_id_1, -1, True))


def CurveRadius(curve_id, test_point, segment_index=-1):
    from katydid.values import Circle
    value = _stored(curve_id)
    if isinstance(value, Circle):
        return value.Radius
    curve = coercecurve(curve_id, segment_index, True)
    found = CurveCurvature(curve, CurveClosestPoint(curve, test_point))
    return found[3] if found else None


def CircleRadius(curve_id, segment_index=-1):
    return _circle(curve_id, segment_index).Radius


def CircleCenterPoint(curve_id, segment_index=-1, return_plane=False):
    found = _circle(curve_id, segment_index)
    return found.Plane if return_plane else found.Center


def CircleCircumference(curve_id, segment_index=-1):
    return _circle(curve_id, segment_index).Circumference


def _circle(curve_id, segment_index):
    from katydid.values import Circle
    value = _stored(curve_id)
    if isinstance(value, Circle):
        return value
    found, circle = coercecurve(curve_id, segment_index, True).TryGetCircle(tolerance())
    if not found:
        raise ValueError("the curve is no circle")
    return circle


def _arc(curve_id, segment_index):
    found, arc = coercecurve(curve_id, segment_index, True).TryGetArc(tolerance())
    if not found:
        raise ValueError("the curve is no arc")
    return arc


def ArcAngle(curve_id, segment_index=-1):
    return degrees(_arc(curve_id, segment_index).Angle)


def ArcCenterPoint(curve_id, segment_index=-1):
    return _arc(curve_id, segment_index).Center


def ArcMidPoint(curve_id, segment_index=-1):
    return _arc(curve_id, segment_index).MidPoint


def ArcRadius(curve_id, segment_index=-1):
    return _arc(curve_id, segment_index).Radius


def _is_a(kind):
    def ask(object_id, *segment_index):
        try:
            return isinstance(coercegeometry(object_id), CLASSES[kind])
        except (ValueError, TypeError):
            return False
    return ask


def IsCurve(object_id):
    """Whether it is a curve."""
    return coercecurve(object_id) is not None


def IsPoint(object_id):
    return isinstance(coercegeometry(object_id), CLASSES["Point"])


IsPointCloud = _is_a("PointCloud")


def IsLine(object_id, segment_index=-1):
    curve = coercecurve(object_id, segment_index)
    return isinstance(curve, CLASSES["LineCurve"]) or (curve is not None and _corners(curve) == 2)


def IsPolyline(object_id, segment_index=-1):
    return isinstance(coercecurve(object_id, segment_index), CLASSES["PolylineCurve"])


def _corners(curve):
    return curve.PointCount if isinstance(curve, CLASSES["PolylineCurve"]) else 0


def IsPolyCurve(object_id, segment_index=-1):
    return isinstance(coercecurve(object_id, segment_index), CLASSES["PolyCurve"])


def IsCircle(object_id, tolerance=None):
    return bool(coercecurve(object_id, -1, True).IsCircle(scriptcontext.doc.ModelAbsoluteTolerance
                                                          if tolerance is None else tolerance))


def IsArc(object_id, segment_index=-1):
    curve = coercecurve(object_id, segment_index, True)
    return bool(curve.IsArc(tolerance())) and not curve.IsClosed


def IsEllipse(object_id, segment_index=-1):
    return bool(coercecurve(object_id, segment_index, True).IsEllipse())


def IsCurveClosed(curve_id, segment_index=-1):
    return bool(coercecurve(curve_id, segment_index, True).IsClosed)


def IsCurvePlanar(curve_id, segment_index=-1):
    return bool(coercecurve(curve_id, segment_index, True).IsPlanar(tolerance()))


def IsCurveLinear(curve_id, segment_index=-1):
    return bool(coercecurve(curve_id, segment_index, True).IsLinear())


def IsCurvePeriodic(curve_id, segment_index=-1):
    return bool(coercecurve(curve_id, segment_index, True).IsPeriodic)


def IsCurveClosable(curve_id, tolerance=None):
    return bool(coercecurve(curve_id, -1, True).IsClosable(scriptcontext.doc.ModelAbsoluteTolerance
                                                           if tolerance is None else tolerance))


def IsCurveInPlane(object_id, plane=None, segment_index=-1):
    from katydid.values import Plane
    frame = coerceplane(plane) if plane is not None else Plane.WorldXY
    return bool(coercecurve(object_id, segment_index, True).IsInPlane(frame, tolerance()))


def IsCurveRational(curve_id, segment_index=-1):
    return bool(coercecurve(curve_id, segment_index, True).ToNurbsCurve().IsRational)


def PointClosestObject(point, object_ids):
    """(Guid, nearest point)."""
    test, best = coerce3dpoint(point, True), None
    for one in (object_ids if is_many(object_ids) else [object_ids]):
        value = _stored(one)
        if isinstance(value, Point3d):
            near = value
        elif coercecurve(one) is not None:
            near = EvaluateCurve(one, CurveClosestPoint(one, test))
        else:
            near = coercegeometry(one, True).ClosestPoint(test)
        gap = test.DistanceTo(near)
        if best is None or gap < best[0]:
            best = (gap, one, near)
    return (best[1], best[2]) if best else None


def PointCloudPoints(object_id):
    return list(coercegeometry(object_id, True).GetPoints())
