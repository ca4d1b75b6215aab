"""Intersection: planes, lines and spheres in Python; everything else is the host's."""

import math

from ..values import Circle, Line, Plane, Point3d, Vector3d
from ..values.base import UNSET, ZERO_TOLERANCE
from ..values.enums import make
from ..values.line import infinite_feet, segment_feet
from .classes import CLASSES

LineSphereIntersection = make("LineSphereIntersection", **{"None": 0, "Single": 1, "Multiple": 2, "Overlap": 3})
LineCircleIntersection = make("LineCircleIntersection", **{"None": 0, "Single": 1, "Multiple": 2})
PlaneSphereIntersection = make("PlaneSphereIntersection", **{"None": 0, "Point": 1, "Circle": 2})
PlaneCircleIntersection = make("PlaneCircleIntersection", **{
    "None": 0, "Tangent": 1, "Secant": 2, "Parallel": 3, "Coincident": 4})
SphereSphereIntersection = make("SphereSphereIntersection", **{"None": 0, "Point": 1, "Circle": 2, "Overlap": 3})


class Intersection(CLASSES["Intersection"]):
    """Static members only."""

    _net_name = "Intersection"
    __slots__ = ()

    @staticmethod
    def LineLine(a, b, *rest):
        """(found, parameter a, parameter b). With (tolerance, finite) too: whether they meet within the tolerance."""
        rest = [value for value in rest if not isinstance(value, bool)], [v for v in rest if isinstance(v, bool)]
        finite = rest[1][-1] if rest[1] else False
        tolerance = rest[0][-1] if rest[1] and rest[0] else None
        if finite:
            s, t = segment_feet(a, b)
        else:
            feet = infinite_feet(a, b)
            if feet is None:
                return False, 0.0, 0.0
            s, t = feet
        if tolerance is not None and tolerance > 0.0 and a.PointAt(s).DistanceTo(b.PointAt(t)) > tolerance:
            return False, s, t
        return True, s, t

    @staticmethod
    def LinePlane(line, plane, *place_holders):
        """(found, parameter on the line)."""
        normal = plane.ZAxis
        along = line.Direction * normal
        if abs(along) <= ZERO_TOLERANCE * max(line.Length, ZERO_TOLERANCE):
            return False, UNSET
        return True, (plane.Origin - line.From) * normal / along

    @staticmethod
    def PlanePlane(a, b, *place_holders):
        """(found, line): along the cross product of the normals."""
        along = Vector3d.CrossProduct(a.ZAxis, b.ZAxis)
        if not along.Length > 1e-12:
            return False, Line.Unset
        middle = Point3d((Vector3d(a.Origin) + Vector3d(b.Origin)) * 0.5)
        found, point = Intersection.PlanePlanePlane(a, b, Plane(middle, along))
        return found, Line(point, point + along) if found else Line.Unset

    @staticmethod
    def PlanePlanePlane(a, b, c, *place_holders):
        """(found, point), by Cramer's rule."""
        na, nb, nc = a.ZAxis, b.ZAxis, c.ZAxis
        bc, ca, ab = (Vector3d.CrossProduct(nb, nc), Vector3d.CrossProduct(nc, na), Vector3d.CrossProduct(na, nb))
        determinant = na * bc
        if abs(determinant) <= 1e-14:
            return False, Point3d.Unset
        da, db, dc = na * a.Origin, nb * b.Origin, nc * c.Origin
        return True, Point3d((bc * da + ca * db + ab * dc) / determinant)

    @staticmethod
    def PlaneSphere(plane, sphere, *place_holders):
        """(kind, circle)."""
        height = plane.DistanceTo(sphere.Center)
        if abs(height) > sphere.Radius + ZERO_TOLERANCE:
            return getattr(PlaneSphereIntersection, "None"), Circle.Unset
        ring = plane._copy()
        ring.Origin = plane.ClosestPoint(sphere.Center)
        radius = math.sqrt(max(0.0, sphere.Radius ** 2 - height ** 2))
        kind = PlaneSphereIntersection.Circle if radius > ZERO_TOLERANCE else PlaneSphereIntersection.Point
        return kind, Circle(ring, radius)

    @staticmethod
    def LineSphere(line, sphere, *place_holders):
        """(kind, first point, second point)."""
        return _line_round(line, sphere.Center, sphere.Radius, LineSphereIntersection)

    @staticmethod
    def LineCircle(line, circle, *place_holders):
        """(kind, t1, point 1, t2, point 2), for lines in the circle's plane or through it."""
        none = getattr(LineCircleIntersection, "None")
        found, t = Intersection.LinePlane(line, circle.Plane)
        if found:
            point = line.PointAt(t)
            if abs(point.DistanceTo(circle.Center) - circle.Radius) <= ZERO_TOLERANCE * 10:
                return LineCircleIntersection.Single, t, point, t, point
            return none, 0.0, Point3d.Unset, 0.0, Point3d.Unset
        if abs(circle.Plane.DistanceTo(line.From)) > ZERO_TOLERANCE * 10:
            return none, 0.0, Point3d.Unset, 0.0, Point3d.Unset
        kind, a, b = _line_round(line, circle.Center, circle.Radius, LineCircleIntersection)
        return kind, line.ClosestParameter(a) if a.IsValid else 0.0, a, line.ClosestParameter(b) if b.IsValid else 0.0, b

    @staticmethod
    def SphereSphere(a, b, *place_holders):
        """(kind, circle)."""
        span = b.Center - a.Center
        gap = span.Length
        none = getattr(SphereSphereIntersection, "None")
        if gap <= ZERO_TOLERANCE:
            same = abs(a.Radius - b.Radius) <= ZERO_TOLERANCE
            return (SphereSphereIntersection.Overlap if same else none), Circle.Unset
        height = (gap * gap + a.Radius ** 2 - b.Radius ** 2) / (2.0 * gap)
        square = a.Radius ** 2 - height ** 2
        if square < -ZERO_TOLERANCE:
            return none, Circle.Unset
        kind = SphereSphereIntersection.Circle if square > ZERO_TOLERANCE else SphereSphereIntersection.Point
        return kind, Circle(Plane(a.Center + span * (height / gap), span), math.sqrt(max(0.0, square)))

    @staticmethod
    def LineBox(line, box, tolerance, *place_holders):
        """(found, interval of parameters): the slabs of the box (Kay and Kajiya, 1986)."""
        from ..values import BoundingBox, Interval
        plane = Plane.WorldXY if isinstance(box, BoundingBox) else box.Plane
        inside = box if isinstance(box, BoundingBox) else box._inside()
        start = plane._local(line.From)
        along = [line.Direction * axis for axis in (plane.XAxis, plane.YAxis, plane.ZAxis)]
        low, high = -math.inf, math.inf
        for p, d, a, b in zip(start, along, inside.Min._parts(), inside.Max._parts()):
            a, b = a - tolerance, b + tolerance
            if d == 0.0:
                if not a <= p <= b:
                    return False, Interval.Unset
                continue
            near, far = sorted(((a - p) / d, (b - p) / d))
            low, high = max(low, near), min(high, far)
        return (True, Interval(low, high)) if low <= high else (False, Interval.Unset)


def _line_round(line, centre, radius, kinds):
    t = line.ClosestParameter(centre)
    foot = line.PointAt(t)
    square = radius ** 2 - foot.DistanceToSquared(centre)
    if square < -ZERO_TOLERANCE:
        return getattr(kinds, "None"), Point3d.Unset, Point3d.Unset
    if square <= ZERO_TOLERANCE:
        return kinds.Single, foot, foot
    along = line.UnitTangent * math.sqrt(square)
    return kinds.Multiple, foot - along, foot + along
