"""What counts as geometry when a value enters a document, and the object that it becomes."""

from ..geometry import HostObject, as_curve
from ..geometry.classes import CLASSES
from ..values import Arc, BoundingBox, Box, Circle, Ellipse, Line, Point3d, Point3f, Polyline, Rectangle3d, Sphere

#: Structs that become objects when they are added.
STRUCTS = (Point3d, Point3f, Line, Circle, Arc, Ellipse, Polyline, Rectangle3d, Box, BoundingBox, Sphere)


def is_geometry(value):
    """Whether a value becomes an object of a document: geometry, or a struct that C# converts to it."""
    return isinstance(value, STRUCTS) or (isinstance(value, HostObject) and isinstance(value, CLASSES["GeometryBase"]))


def geometry_of(value):
    """The RhinoCommon geometry of a stored value: a Point, a curve, a Brep ..."""
    if isinstance(value, (Point3d, Point3f)):
        return CLASSES["Point"](value)
    if isinstance(value, (Box, BoundingBox, Sphere)):
        return value.ToBrep()
    return as_curve(value)
