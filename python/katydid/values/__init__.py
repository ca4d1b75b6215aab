"""The value types of RhinoCommon in plain Python: they compute without asking the host."""

from .box import BoundingBox, Box
from .circle import Arc, Circle, Ellipse
from .interval import Interval
from .line import Line, Ray3d
from .plane import Plane, to_plane, to_point, to_vector
from .point import Point2d, Point2f, Point3d, Point3f, Point4d
from .polyline import Point3dList, Polyline
from .quaternion import Quaternion
from .rectangle import Rectangle3d
from .solid import Cone, Cylinder, Sphere, Torus
from .system import Color, Complex, DateTime, Guid, MeshFace
from .transform import Transform
from .vector import Vector2d, Vector2f, Vector3d, Vector3f

__all__ = ["Arc", "BoundingBox", "Box", "Circle", "Color", "Complex", "Cone", "Cylinder", "DateTime", "Ellipse", "Guid",
           "Interval", "Line", "MeshFace", "Plane", "Point2d", "Point2f", "Point3d", "Point3dList", "Point3f", "Point4d",
           "Polyline", "Quaternion", "Ray3d", "Rectangle3d", "Sphere", "Torus", "Transform", "Vector2d", "Vector2f",
           "Vector3d", "Vector3f", "to_plane", "to_point", "to_vector"]
