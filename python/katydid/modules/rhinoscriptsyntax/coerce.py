"""Arguments of rhinoscriptsyntax as geometry: Guids, geometry itself, texts and lists of numbers are taken alike.

What is no such thing gives None, or, where `raise_if_missing` is set, a ValueError.
"""

import re

import scriptcontext
from katydid import document
from katydid.geometry import CLASSES, HostObject, as_curve
from katydid.values import (Arc, BoundingBox, Box, Circle, Color, Ellipse, Guid, Interval, Line, Plane, Point2d, Point3d,
                            Polyline, Rectangle3d, Sphere, Transform, Vector3d, to_point, to_vector)
from katydid.values.tuples import Coordinates

_CURVES = (Line, Circle, Arc, Ellipse, Polyline, Rectangle3d)


def _missing(raise_if_missing, value, kind):
    if raise_if_missing:
        raise ValueError("Could not convert %s to a %s" % (value, kind))
    return None


def coerceguid(id, raise_if_missing=False):
    if isinstance(id, Guid):
        return id
    if isinstance(id, str) and id:
        found, guid = Guid.TryParse(id)
        if found:
            return guid
    if hasattr(id, "Id") and isinstance(id.Id, Guid):
        return id.Id
    return _missing(raise_if_missing, id, "Guid")


def coerceguidlist(ids, raise_if_missing=False):
    if ids is None:
        return _missing(raise_if_missing, ids, "list of Guids")
    if isinstance(ids, (list, tuple)) or hasattr(ids, "__next__"):
        return [guid for guid in (_object_id(one) for one in ids) if guid is not None]
    guid = _object_id(ids)
    return _missing(raise_if_missing, ids, "list of Guids") if guid is None else [guid]


def _object_id(value):
    """A Guid, or, of geometry that is in no document yet, that of a copy that is added."""
    guid = coerceguid(value)
    if guid is None and value is not None and document.is_geometry(value):
        return scriptcontext.doc.Objects.Add(value)
    return guid


def _stored(value):
    """What a Guid stands for, as it was added; other values as they are."""
    guid = coerceguid(value)
    if guid is None:
        return value
    found = scriptcontext.doc.Objects.Find(guid) if scriptcontext.doc is not None else None
    found = found or document.find(guid)
    return None if found is None else found.value


def coercerhinoobject(object_id, raise_if_bad_input=False, raise_if_missing=False):
    guid = _object_id(object_id)
    found = None
    if guid is not None:
        found = scriptcontext.doc.Objects.Find(guid) or document.find(guid)
    return _missing(raise_if_missing or raise_if_bad_input, object_id, "RhinoObject") if found is None else found


def coercegeometry(id, raise_if_missing=False):
    value = _stored(id)
    if value is not None and document.is_geometry(value):
        return document.geometry_of(value)
    return _missing(raise_if_missing, id, "geometry")


def _numbers(text):
    parts = re.findall(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?", text)
    return [float(part) for part in parts]


def coerce3dpoint(point, raise_if_missing=False):
    value = _stored(point)
    if isinstance(value, Point3d):
        return value._copy()
    if isinstance(value, str):
        value = _numbers(value)
        return Point3d(*value) if len(value) == 3 else _missing(raise_if_missing, point, "Point3d")
    if isinstance(value, Coordinates) or type(value).__name__ == "Point":
        return to_point(value)
    if isinstance(value, (list, tuple)) and len(value) in (2, 3) and not hasattr(value, "_net_name"):
        try:
            return to_point(value)
        except (TypeError, ValueError):
            pass
    if isinstance(value, Plane):
        return value.Origin
    return _missing(raise_if_missing, point, "Point3d")


def CreatePoint(point, y=None, z=None):
    """A point of three numbers, of two, or of what converts to one."""
    if y is None:
        return coerce3dpoint(point, True)
    return Point3d(float(point), float(y), 0.0 if z is None else float(z))


def coerce2dpoint(point, raise_if_missing=False):
    if isinstance(point, Point2d):
        return point
    if isinstance(point, Coordinates) or (isinstance(point, (list, tuple)) and len(point) in (2, 3)):
        return Point2d(float(point[0]), float(point[1]))
    return _missing(raise_if_missing, point, "Point2d")


def coerce3dvector(vector, raise_if_missing=False):
    if isinstance(vector, Line):
        return vector.Direction
    found = coerce3dpoint(vector)
    return _missing(raise_if_missing, vector, "Vector3d") if found is None else to_vector(found)


def CreateVector(vector, y=None, z=None):
    """A vector of three numbers, of two, or of what converts to one."""
    if y is None:
        return coerce3dvector(vector, True)
    return Vector3d(float(vector), float(y), 0.0 if z is None else float(z))


def coerce3dpointlist(points, raise_if_missing=False):
    if isinstance(points, HostObject) or points is None or isinstance(points, (str, Coordinates)):
        return _missing(raise_if_missing, points, "list of points")
    points = list(points)
    if points and all(isinstance(one, (int, float)) for one in points) and len(points) % 3 == 0:
        return [Point3d(*points[i:i + 3]) for i in range(0, len(points), 3)]
    made = [coerce3dpoint(one) for one in points]
    return _missing(raise_if_missing, points, "list of points") if None in made else made


def coerce2dpointlist(points):
    return [coerce2dpoint(one) for one in points]


def coerceplane(plane, raise_if_bad_input=False):
    if isinstance(plane, Plane):
        return plane._copy()
    if isinstance(plane, (list, tuple)):
        flat = [number for part in plane for number in (part if hasattr(part, "__iter__") else [part])]
        try:
            if len(flat) == 3:
                moved = Plane.WorldXY
                moved.Origin = Point3d(*flat)
                return moved
            if len(flat) == 9:
                return Plane(Point3d(*flat[:3]), Vector3d(*flat[3:6]), Vector3d(*flat[6:]))
            if len(flat) == 12:
                return Plane(Point3d(*flat[:3]), Vector3d(*flat[3:6]), Vector3d(*flat[6:9]))
        except (TypeError, ValueError):
            pass
    return _missing(raise_if_bad_input, plane, "Plane")


def _plane_or_point(value):
    """A plane; a point gives the plane through it that is parallel to the construction plane."""
    plane = coerceplane(value)
    if plane is not None and not (isinstance(value, (list, tuple)) and len(value) == 3
                                  and isinstance(value[0], (int, float))):
        return plane
    point = coerce3dpoint(value, True)
    moved = Plane.WorldXY
    moved.Origin = point
    return moved


def coercexform(xform, raise_if_bad_input=False):
    if isinstance(xform, Transform):
        return xform
    try:
        flat = [number for row in xform for number in (row if hasattr(row, "__iter__") else [row])]
        return Transform._of(flat)
    except (TypeError, ValueError):
        return _missing(raise_if_bad_input, xform, "Transform")


def coerceboundingbox(bbox, raise_if_bad_input=False):
    if isinstance(bbox, BoundingBox):
        return bbox
    points = coerce3dpointlist(bbox) if isinstance(bbox, (list, tuple)) else None
    return BoundingBox(points) if points else _missing(raise_if_bad_input, bbox, "BoundingBox")


def coercecolor(color, raise_if_bad_input=False):
    if isinstance(color, Color):
        return color
    if isinstance(color, (list, tuple)) and len(color) in (3, 4):
        parts = [int(part) for part in color]
        # The fourth part is the alpha.
        return Color.FromArgb(*(parts[3:] + parts[:3]))
    if isinstance(color, str):
        found = Color.FromName(color)
        return _missing(raise_if_bad_input, color, "Color") if found.IsEmpty else found
    if isinstance(color, int):
        return Color.FromArgb(color)
    return _missing(raise_if_bad_input, color, "Color")


def coerceline(line, raise_if_bad_input=False):
    value = _stored(line)
    if isinstance(value, Line):
        return value._copy()
    if isinstance(value, Polyline) and len(value) == 2:
        return Line(value[0], value[1])
    if isinstance(value, HostObject) and isinstance(value, CLASSES["Curve"]):
        if value.IsLinear():
            return Line(value.PointAtStart, value.PointAtEnd)
    if isinstance(value, (list, tuple)):
        points = coerce3dpointlist(value)
        if points and len(points) == 2:
            return Line(points[0], points[1])
    return _missing(raise_if_bad_input, line, "Line")


def coercecurve(id, segment_index=-1, raise_if_missing=False):
    value = _stored(id)
    if isinstance(value, _CURVES):
        value = as_curve(value)
    elif isinstance(value, (list, tuple)) and len(value) == 2:
        line = coerceline(value)
        value = as_curve(line) if line else None
    if isinstance(value, CLASSES["Curve"]):
        if segment_index is not None and segment_index >= 0 and isinstance(value, CLASSES["PolyCurve"]):
            return value.SegmentCurve(segment_index)
        return value
    return _missing(raise_if_missing, id, "Curve")


def coercesurface(object_id, raise_if_missing=False):
    value = _stored(object_id)
    if isinstance(value, (Sphere, Box, BoundingBox)):
        value = value.ToBrep()
    if isinstance(value, CLASSES["Surface"]):
        return value
    if isinstance(value, CLASSES["Brep"]) and len(value.Faces) == 1:
        return value.Faces[0]
    return _missing(raise_if_missing, object_id, "Surface")


def coercebrep(id, raise_if_missing=False):
    value = _stored(id)
    if isinstance(value, (Sphere, Box, BoundingBox)):
        return value.ToBrep()
    if isinstance(value, CLASSES["Brep"]):
        return value
    if isinstance(value, CLASSES["Surface"]):
        return value.ToBrep()
    return _missing(raise_if_missing, id, "Brep")


def coercemesh(object_id, raise_if_missing=False):
    value = _stored(object_id)
    return value if isinstance(value, CLASSES["Mesh"]) else _missing(raise_if_missing, object_id, "Mesh")


def CreateColor(color, g=None, b=None, a=None):
    """Of three or four numbers, a list of them, or a name."""
    if g is not None and b is not None:
        color = [color, g, b] + ([a] if a is not None else [])
    return coercecolor(color, True)


def CreatePlane(plane_or_origin, x_axis=None, y_axis=None, *ignored):
    """Of an origin and two axes, or of anything that is a plane."""
    if x_axis is not None and y_axis is not None:
        return Plane(coerce3dpoint(plane_or_origin, True), coerce3dvector(x_axis, True), coerce3dvector(y_axis, True))
    return coerceplane(plane_or_origin, True)


def CreateInterval(interval, y=None):
    if y is not None:
        return Interval(interval, y)
    if isinstance(interval, (int, float)):
        # One number: from zero to it.
        return Interval(min(interval, 0), max(interval, 0))
    return Interval(*interval)


CreateXform = coercexform
