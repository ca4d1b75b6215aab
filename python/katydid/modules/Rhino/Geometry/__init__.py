"""Rhino.Geometry: value types in Python, geometry of the host, enumerations."""

from katydid.geometry import CLASSES as _CLASSES
from katydid.rhino import missing as _missing
from katydid.values import *  # noqa: F401,F403
from katydid.values import enums as _enums
from katydid.values.point import Point2f, Point4d  # noqa: F401
from katydid.values.vector import Vector2f  # noqa: F401

_ELSEWHERE = ("Intersection", "MeshClash", "CurveIntersections", "IntersectionEvent")
# What the values package brings that is not of this namespace.
for _name in ("Color", "Guid", "DateTime", "Complex", "Point3dList", "to_plane", "to_point", "to_vector"):
    globals().pop(_name, None)
for _name, _kind in list(_CLASSES.items()) + list(_enums.BY_NAME.items()):
    if _name not in _ELSEWHERE and _name not in ("UnitSystem",):
        globals()[_name] = _kind

from . import Collections, Intersect  # noqa: E402,F401


__getattr__ = _missing(__name__)
