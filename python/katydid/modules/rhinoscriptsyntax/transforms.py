"""Transforms, and where lines and planes meet solids."""

from katydid.geometry.intersect import Intersection
from katydid.values import Sphere, Transform

from .coerce import coerce3dpoint, coerce3dvector, coerceline, coerceplane, coercexform


def IsXformZero(xform):
    """Whether all numbers are zero but the last, which may be 1."""
    numbers = [number for row in range(4) for number in [getattr(coercexform(xform, True), "M%d%d" % (row, column))
                                                         for column in range(4)]]
    return all(number == 0.0 for number in numbers[:15])


def XformRotation4(x0, y0, z0, x1, y1, z1):
    """From three perpendicular axes to three others."""
    own = [coerce3dvector(axis, True) for axis in (x0, y0, z0, x1, y1, z1)]
    return Transform.Rotation(*own)


def XformChangeBasis2(x0, y0, z0, x1, y1, z1):
    """From coordinates in three axes to coordinates in three others."""
    own = [coerce3dvector(axis, True) for axis in (x0, y0, z0, x1, y1, z1)]
    done = Transform.ChangeBasis(*own)
    return done[1] if isinstance(done, tuple) else done


def XformShear(plane, x, y, z):
    return Transform.Shear(coerceplane(plane, True), coerce3dvector(x, True), coerce3dvector(y, True), coerce3dvector(z, True))


def XformWorldToCPlane(point, plane):
    """A point in coordinates of a plane."""
    return coerceplane(plane, True).RemapToPlaneSpace(coerce3dpoint(point, True))[1]


def XformCPlaneToWorld(point, plane):
    """The point with these coordinates in a plane."""
    own = coerce3dpoint(point, True)
    return coerceplane(plane, True).PointAt(own.X, own.Y, own.Z)


def PlaneSphereIntersection(plane, sphere_plane, sphere_radius):
    """(0, point) where a plane touches a sphere, (1, plane of the circle, radius), None where they do not meet."""
    own, ball = coerceplane(plane, True), Sphere(coerceplane(sphere_plane, True), float(sphere_radius))
    found, circle = Intersection.PlaneSphere(own, ball)
    if int(found) == 1:
        return 0, circle.Center
    if int(found) == 2:
        return 1, circle.Plane, circle.Radius
    return None


def LineSphereIntersection(line, sphere_center, sphere_radius):
    """The points in which a line without ends meets a sphere."""
    ball = Sphere(coerce3dpoint(sphere_center, True), float(sphere_radius))
    found, first, second = Intersection.LineSphere(coerceline(line, True), ball)
    return [[], [first], [first, second], [first, second]][int(found)]


def LineCylinderIntersection(line, cylinder_plane, cylinder_height, cylinder_radius):
    """The points in which a line without ends meets the wall of a cylinder, which has ends."""
    own, frame = coerceline(line, True), coerceplane(cylinder_plane, True)
    height, radius = float(cylinder_height), float(cylinder_radius)
    start = frame.RemapToPlaneSpace(own.From)[1]
    along = frame.RemapToPlaneSpace(own.To)[1] - start
    # |(start + t along) in the plane| = radius.
    a = along.X ** 2 + along.Y ** 2
    b = start.X * along.X + start.Y * along.Y
    c = start.X ** 2 + start.Y ** 2 - radius ** 2
    turn = b * b - a * c
    if not a > 0.0 or turn < 0.0:
        return []
    root = turn ** 0.5
    places = sorted({(-b - root) / a, (-b + root) / a})
    low, high = min(0.0, height), max(0.0, height)
    return [own.PointAt(t) for t in places if low <= start.Z + t * along.Z <= high]
