"""Rhino.Geometry.Intersect: intersections of geometry by the host, of lines and planes in Python."""

from katydid.geometry import CLASSES as _CLASSES
from katydid.geometry.intersect import Intersection, LineCircleIntersection, LineSphereIntersection  # noqa: F401
from katydid.geometry.intersect import PlaneCircleIntersection, PlaneSphereIntersection  # noqa: F401
from katydid.geometry.intersect import SphereSphereIntersection  # noqa: F401
from katydid.rhino import missing as _missing

MeshClash = _CLASSES["MeshClash"]
CurveIntersections = _CLASSES["CurveIntersections"]
IntersectionEvent = _CLASSES["IntersectionEvent"]


__getattr__ = _missing(__name__)
