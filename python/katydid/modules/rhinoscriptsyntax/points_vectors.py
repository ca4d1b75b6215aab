"""Points, vectors and transforms as values."""

import math

from katydid.values import Plane, Point3d, Transform, Vector3d, to_vector
from katydid.values.base import ZERO_TOLERANCE

from .coerce import coerce3dpoint, coerce3dpointlist, coerce3dvector, coerceplane, coercexform
from .support import degrees, radians, tolerance


def Distance(point1, point2):
    """The distance of two points; a list as the second gives a list."""
    a = coerce3dpoint(point1, True)
    b = coerce3dpoint(point2)
    if b is not None:
        return a.DistanceTo(b)
    points = coerce3dpointlist(point2, True)
    return [a.DistanceTo(point) for point in points]


def Angle(point1, point2, plane=True):
    """(angle in XY, elevation, dx, dy, dz) in degrees, from one point to another."""
    a, b = coerce3dpoint(point1, True), coerce3dpoint(point2, True)
    span = b - a
    if span.IsTiny():
        return None
    if isinstance(plane, Plane):
        span = Vector3d(span * plane.XAxis, span * plane.YAxis, span * plane.ZAxis)
    flat = math.hypot(span.X, span.Y)
    return degrees(math.atan2(span.Y, span.X)), degrees(math.atan2(span.Z, flat)), span.X, span.Y, span.Z


def Angle2(line1, line2):
    """(angle, reflex angle) of two lines in degrees."""
    from .coerce import coerceline
    a, b = coerceline(line1, True).Direction, coerceline(line2, True).Direction
    angle = degrees(Vector3d.VectorAngle(a, b))
    return angle, 360.0 - angle


def PointAdd(point1, point2):
    return coerce3dpoint(point1, True) + coerce3dvector(point2, True)


def PointSubtract(point1, point2):
    return Point3d(coerce3dpoint(point1, True) - coerce3dpoint(point2, True))


def PointScale(point, scale):
    return coerce3dpoint(point, True) * float(scale)


def PointDivide(point, divide):
    return coerce3dpoint(point, True) / float(divide)


def PointCompare(point1, point2, tolerance=None):
    limit = ZERO_TOLERANCE if tolerance is None else tolerance
    return coerce3dpoint(point1, True).DistanceTo(coerce3dpoint(point2, True)) <= limit


def PointTransform(point, xform):
    return coercexform(xform, True) * coerce3dpoint(point, True)


def PointArrayTransform(points, xform):
    matrix = coercexform(xform, True)
    return [matrix * point for point in coerce3dpointlist(points, True)]


def PointArrayClosestPoint(points, test_point):
    """The index of the nearest point."""
    found, test = coerce3dpointlist(points, True), coerce3dpoint(test_point, True)
    return min(range(len(found)), key=lambda i: found[i].DistanceToSquared(test)) if found else None


def PointArrayBoundingBox(points, view_or_plane=None, in_world_coords=True):
    from katydid.values import BoundingBox
    return BoundingBox(coerce3dpointlist(points, True)).GetCorners()


def PointsAreCoplanar(points, tolerance=1.0e-12):
    return Point3d.ArePointsCoplanar(coerce3dpointlist(points, True), tolerance)


def ArePointsInLine(points, tolerance=1.0e-12):
    from katydid.values.fit import line_of_points
    found = coerce3dpointlist(points, True)
    good, line = line_of_points(found)
    return good and all(line.DistanceTo(point, False) <= tolerance for point in found)


def CullDuplicateNumbers(numbers, tolerance=None):
    limit, kept = tolerance or 0.0, []
    for number in sorted(numbers):
        if not kept or abs(number - kept[-1]) > limit:
            kept.append(number)
    return kept


def CullDuplicatePoints(points, tolerance=-1):
    limit = _tolerance(tolerance)
    return Point3d.CullDuplicates(coerce3dpointlist(points, True), limit) or []


def _tolerance(value):
    return tolerance() if value is None or value < 0 else value


def SortPoints(points, ascending=True, order=0):
    """By coordinates: order 0 is X Y Z, 1 X Z Y, 2 Y X Z, 3 Y Z X, 4 Z X Y, 5 Z Y X."""
    keys = ((0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0))[order]
    return sorted(coerce3dpointlist(points, True), key=lambda p: [p[i] for i in keys], reverse=not ascending)


def SortPointList(points, tolerance=None):
    """Points in a chain: each next one is the nearest that is left, from the first."""
    left = coerce3dpointlist(points, True)
    chain = left[:1]
    left = left[1:]
    while left:
        i = min(range(len(left)), key=lambda k: left[k].DistanceToSquared(chain[-1]))
        chain.append(left.pop(i))
    return chain


def SimplifyArray(points):
    return [number for point in coerce3dpointlist(points, True) for number in point]


def Polar(point, angle_degrees, distance, plane=None):
    """The point at a distance and an angle in a plane."""
    start, frame = coerce3dpoint(point, True), coerceplane(plane) if plane is not None else Plane.WorldXY
    along = frame.XAxis
    along.Rotate(radians(angle_degrees), frame.ZAxis)
    return start + along * distance


# Vectors.
def VectorAdd(vector1, vector2):
    return coerce3dvector(vector1, True) + coerce3dvector(vector2, True)


def VectorSubtract(vector1, vector2):
    return coerce3dvector(vector1, True) - coerce3dvector(vector2, True)


def VectorScale(vector, scale):
    return coerce3dvector(vector, True) * float(scale)


def VectorDivide(vector, divide):
    return coerce3dvector(vector, True) / float(divide)


def VectorMultiply(vector1, vector2):
    return coerce3dvector(vector1, True) * coerce3dvector(vector2, True)


VectorDotProduct = VectorMultiply


def VectorCrossProduct(vector1, vector2):
    return Vector3d.CrossProduct(coerce3dvector(vector1, True), coerce3dvector(vector2, True))


def VectorLength(vector):
    return coerce3dvector(vector, True).Length


def VectorUnitize(vector):
    """The vector with length 1; None for one without length."""
    made = to_vector(coerce3dvector(vector, True))
    return made if made.Unitize() else None


def VectorReverse(vector):
    return -coerce3dvector(vector, True)


def VectorRotate(vector, angle_degrees, axis):
    """The vector turned about an axis; None where the axis has no length."""
    made = to_vector(coerce3dvector(vector, True))
    return made if made.Rotate(radians(angle_degrees), coerce3dvector(axis, True)) else None


def VectorTransform(vector, xform):
    return coercexform(xform, True) * to_vector(coerce3dvector(vector, True))


def VectorCreate(to_point, from_point):
    return coerce3dpoint(to_point, True) - coerce3dpoint(from_point, True)


def VectorAngle(vector1, vector2):
    """In degrees; None where a vector has no length."""
    a, b = to_vector(coerce3dvector(vector1, True)), to_vector(coerce3dvector(vector2, True))
    if not (a.Unitize() and b.Unitize()):
        return None
    return degrees(math.acos(max(-1.0, min(1.0, a * b))))


def VectorCompare(vector1, vector2):
    a, b = coerce3dvector(vector1, True), coerce3dvector(vector2, True)
    return a.CompareTo(b)


def IsVectorZero(vector):
    return coerce3dvector(vector, True).IsZero


def IsVectorTiny(vector):
    return coerce3dvector(vector, True).IsTiny(1.0e-12)


def IsVectorParallelTo(vector1, vector2):
    return coerce3dvector(vector1, True).IsParallelTo(coerce3dvector(vector2, True))


def IsVectorPerpendicularTo(vector1, vector2):
    return coerce3dvector(vector1, True).IsPerpendicularTo(coerce3dvector(vector2, True))


# Transforms.
def XformIdentity():
    return Transform.Identity


def XformZero():
    return Transform()


def XformTranslation(vector):
    return Transform.Translation(coerce3dvector(vector, True))


def XformScale(scale, point=None):
    """About a point; one factor, or one for each axis."""
    plane = Plane.WorldXY
    if point is not None:
        plane.Origin = coerce3dpoint(point, True)
    factors = coerce3dpoint(scale) if not isinstance(scale, (int, float)) else None
    x, y, z = factors if factors is not None else (float(scale),) * 3
    return Transform.Scale(plane, x, y, z)


def XformMirror(mirror_plane_point, mirror_plane_normal):
    return Transform.Mirror(coerce3dpoint(mirror_plane_point, True), coerce3dvector(mirror_plane_normal, True))


def XformRotation1(initial_plane, final_plane):
    return Transform.PlaneToPlane(coerceplane(initial_plane, True), coerceplane(final_plane, True))


def XformRotation2(angle_degrees, rotation_axis, center_point):
    return Transform.Rotation(radians(angle_degrees), coerce3dvector(rotation_axis, True),
                              coerce3dpoint(center_point, True))


def XformRotation3(start_direction, end_direction, center_point):
    return Transform.Rotation(coerce3dvector(start_direction, True), coerce3dvector(end_direction, True),
                              coerce3dpoint(center_point, True))


def XformPlanarProjection(plane):
    return Transform.PlanarProjection(coerceplane(plane, True))


def XformChangeBasis(initial_plane, final_plane):
    return Transform.ChangeBasis(coerceplane(initial_plane, True), coerceplane(final_plane, True))


def XformMultiply(xform1, xform2):
    return coercexform(xform1, True) * coercexform(xform2, True)


def XformInverse(xform):
    found, inverse = coercexform(xform, True).TryGetInverse()
    return inverse if found else None


def XformDeterminant(xform):
    return coercexform(xform, True).Determinant


def XformCompare(xform1, xform2):
    a, b = coercexform(xform1, True)._m, coercexform(xform2, True)._m
    return (a > b) - (a < b)


def IsXformIdentity(xform):
    return coercexform(xform, True) == Transform.Identity


def IsXformSimilarity(xform):
    return coercexform(xform, True).SimilarityType != 0
