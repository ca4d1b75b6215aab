"""Planes and lines as values."""

from katydid.geometry.intersect import Intersection
from katydid.values import Plane, Vector3d
from katydid.values.enums import PlaneFitResult

from .coerce import coerce3dpoint, coerce3dpointlist, coerce3dvector, coerceline, coerceplane, coercexform
from .support import radians


def WorldXYPlane():
    return Plane.WorldXY


def WorldYZPlane():
    return Plane.WorldYZ


def WorldZXPlane():
    return Plane.WorldZX


def ViewCPlane(view=None, plane=None):
    """The construction plane: without a window the world's XY."""
    return Plane.WorldXY


def MovePlane(plane, origin):
    """The plane with another origin."""
    moved = coerceplane(plane, True)
    moved.Origin = coerce3dpoint(origin, True)
    return moved


def RotatePlane(plane, angle_degrees, axis):
    """The plane turned about an axis through its origin; None where that fails."""
    turned = coerceplane(plane, True)
    return turned if turned.Rotate(radians(angle_degrees), coerce3dvector(axis, True)) else None


def PlaneTransform(plane, xform):
    moved = coerceplane(plane, True)
    return moved if moved.Transform(coercexform(xform, True)) else None


def EvaluatePlane(plane, parameter):
    """The point at (u, v) in a plane."""
    return coerceplane(plane, True).PointAt(float(parameter[0]), float(parameter[1]))


def PlaneFromFrame(origin, x_axis, y_axis):
    return Plane(coerce3dpoint(origin, True), coerce3dvector(x_axis, True), coerce3dvector(y_axis, True))


def PlaneFromNormal(origin, normal, xaxis=None):
    """With an x axis: that direction, laid into the plane."""
    point, z = coerce3dpoint(origin, True), coerce3dvector(normal, True)
    made = Plane(point, z)
    if xaxis is not None:
        x = coerce3dvector(xaxis, True)
        made = Plane(point, x - made.ZAxis * (made.ZAxis * x), Vector3d.CrossProduct(made.ZAxis, x))
    return made


def PlaneFromPoints(origin, x, y):
    made = Plane(coerce3dpoint(origin, True), coerce3dpoint(x, True), coerce3dpoint(y, True))
    return made if made.IsValid else None


def PlaneFitFromPoints(points):
    result, plane = Plane.FitPlaneToPoints(coerce3dpointlist(points, True))
    return plane if result == PlaneFitResult.Success else None


def PlaneClosestPoint(plane, point, return_point=True):
    frame, test = coerceplane(plane, True), coerce3dpoint(point, True)
    if return_point:
        return frame.ClosestPoint(test)
    _, u, v = frame.ClosestParameter(test)
    return u, v


def DistanceToPlane(plane, point):
    return coerceplane(plane, True).DistanceTo(coerce3dpoint(point, True))


def PlaneEquation(plane):
    return tuple(coerceplane(plane, True).GetPlaneEquation())


def IsPlane(object):
    return isinstance(coerceplane(object), Plane)


def PlanePlaneIntersection(plane1, plane2):
    """Two points of the line; None for parallel planes."""
    found, line = Intersection.PlanePlane(coerceplane(plane1, True), coerceplane(plane2, True))
    return (line.From, line.To) if found else None


def PlaneIntersection(plane1, plane2, plane3):
    found, point = Intersection.PlanePlanePlane(*[coerceplane(one, True) for one in (plane1, plane2, plane3)])
    return point if found else None


def LinePlaneIntersection(line, plane):
    segment = coerceline(line, True)
    found, t = Intersection.LinePlane(segment, coerceplane(plane, True))
    return segment.PointAt(t) if found else None


def LineLineIntersection(lineA, lineB):
    """The nearest points of two lines without ends; None where they are parallel."""
    a, b = coerceline(lineA, True), coerceline(lineB, True)
    found, s, t = Intersection.LineLine(a, b)
    return (a.PointAt(s), b.PointAt(t)) if found else None


def LineClosestPoint(line, testpoint):
    return coerceline(line, True).ClosestPoint(coerce3dpoint(testpoint, True), False)


def LineMinDistanceTo(line, point_or_line):
    return coerceline(line, True).MinimumDistanceTo(_point_or_line(point_or_line))


def LineMaxDistanceTo(line, point_or_line):
    return coerceline(line, True).MaximumDistanceTo(_point_or_line(point_or_line))


def _point_or_line(value):
    line = coerceline(value)
    return line if line is not None else coerce3dpoint(value, True)


def LineIsFartherThan(line, distance, point_or_line):
    return LineMinDistanceTo(line, point_or_line) > distance


def LinePlane(line):
    found, plane = coerceline(line, True).TryGetPlane()
    return plane if found else None


def LineTransform(line, xform):
    moved = coerceline(line, True)
    return moved if moved.Transform(coercexform(xform, True)) else None
