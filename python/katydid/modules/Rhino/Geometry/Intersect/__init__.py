"""Rhino.Geometry.Intersect: intersections of geometry by the host, of lines and planes in Python."""

from katydid.geometry import CLASSES as _CLASSES
from katydid.geometry.intersect import Intersection, LineCircleIntersection, LineSphereIntersection  # noqa: F401
from katydid.geometry.intersect import PlaneCircleIntersection, PlaneSphereIntersection  # noqa: F401
from katydid.geometry.intersect import SphereSphereIntersection  # noqa: F401
from katydid.values.base import not_supported as _not_supported

MeshClash = _CLASSES["MeshClash"]
CurveIntersections = _CLASSES["CurveIntersections"]
IntersectionEvent = _CLASSES["IntersectionEvent"]


def __getattr__(name):
    if name.startswith("_"):
        raise AttributeError(name)
    raise _not_supported("Rhino.Geometry.Intersect." + name)
