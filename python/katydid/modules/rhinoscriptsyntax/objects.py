"""Objects of the document: moved, copied, asked and deleted by Guid."""

import scriptcontext
from katydid.geometry import CLASSES
from katydid.values import BoundingBox, Guid, Plane, Transform, Vector3d

from .coerce import (coerce3dpoint, coerce3dpointlist, coerce3dvector, coercecolor, coercegeometry, coerceguid,
                     coerceguidlist, coerceplane, coercerhinoobject, coercexform)
from .support import is_many, radians


def TransformObjects(object_ids, matrix, copy=False):
    """The Guids of what was moved, or of the copies."""
    xform = coercexform(matrix, True)
    results = []
    for guid in coerceguidlist(object_ids, True):
        moved = scriptcontext.doc.Objects.Transform(guid, xform, not copy)
        if moved != Guid.Empty:
            results.append(moved)
    return results


def TransformObject(object_id, matrix, copy=False):
    found = TransformObjects(object_id, matrix, copy)
    return found[0] if found else None


def _one(object_id, xform, copy=False):
    """One Guid for one object, a list for a list."""
    found = TransformObjects(object_id, xform, copy)
    if is_many(object_id):
        return found
    return found[0] if found else None


def MoveObjects(object_ids, translation):
    return TransformObjects(object_ids, Transform.Translation(coerce3dvector(translation, True)))


def MoveObject(object_id, translation):
    return _one(object_id, Transform.Translation(coerce3dvector(translation, True)))


def CopyObjects(object_ids, translation=None):
    motion = coerce3dvector(translation, True) if translation is not None else Vector3d.Zero
    return TransformObjects(object_ids, Transform.Translation(motion), True)


def CopyObject(object_id, translation=None):
    found = CopyObjects(object_id, translation)
    if is_many(object_id):
        return found
    return found[0] if found else None


def _rotation(center_point, rotation_angle, axis):
    centre = coerce3dpoint(center_point, True)
    turn = Vector3d.ZAxis if axis is None else coerce3dvector(axis, True)
    return Transform.Rotation(radians(rotation_angle), turn, centre)


def RotateObjects(object_ids, center_point, rotation_angle, axis=None, copy=False):
    """By degrees, about an axis through a point: the construction plane's z axis where none is given."""
    return TransformObjects(object_ids, _rotation(center_point, rotation_angle, axis), copy)


def RotateObject(object_id, center_point, rotation_angle, axis=None, copy=False):
    return _one(object_id, _rotation(center_point, rotation_angle, axis), copy)


def _scaling(origin, scale):
    plane = Plane.WorldXY
    plane.Origin = coerce3dpoint(origin, True)
    if isinstance(scale, (int, float)):
        scale = (scale,) * 3
    return Transform.Scale(plane, *[float(factor) for factor in scale])


def ScaleObjects(object_ids, origin, scale, copy=False):
    return TransformObjects(object_ids, _scaling(origin, scale), copy)


def ScaleObject(object_id, origin, scale, copy=False):
    return _one(object_id, _scaling(origin, scale), copy)


def _mirror(start_point, end_point):
    """The mirror plane stands upright on the line of two points."""
    start = coerce3dpoint(start_point, True)
    along = coerce3dpoint(end_point, True) - start
    if along.IsTiny():
        raise ValueError("start and end points are too close to each other")
    return Transform.Mirror(start, Vector3d.CrossProduct(Vector3d.ZAxis, along))


def MirrorObjects(object_ids, start_point, end_point, copy=False):
    return TransformObjects(object_ids, _mirror(start_point, end_point), copy)


def MirrorObject(object_id, start_point, end_point, copy=False):
    return _one(object_id, _mirror(start_point, end_point), copy)


def OrientObject(object_id, reference, target, flags=0):
    """From two or three points to two or three others; flag 1 copies, 2 scales."""
    start, end = coerce3dpointlist(reference, True), coerce3dpointlist(target, True)
    if len(start) < 3 or len(end) < 3:
        # Two points: the third stands upright.
        for points in (start, end):
            if len(points) == 2:
                points.append(points[0] + Vector3d.ZAxis)
    xform = Transform.PlaneToPlane(Plane(*start[:3]), Plane(*end[:3]))
    if flags & 2:
        factor = end[0].DistanceTo(end[1]) / start[0].DistanceTo(start[1])
        xform = xform * Transform.Scale(start[0], factor)
    return _one(object_id, xform, bool(flags & 1))


def DeleteObject(object_id):
    guid = coerceguid(object_id)
    return guid is not None and scriptcontext.doc.Objects.Delete(guid)


def DeleteObjects(object_ids):
    return sum(DeleteObject(one) for one in (object_ids if is_many(object_ids) else [object_ids]))


def IsObject(object_id):
    return coerceguid(object_id) is not None and coercerhinoobject(object_id) is not None


def ObjectType(object_id):
    """The number of the object's type: 1 point, 4 curve, 8 surface, 16 polysurface, 32 mesh ..."""
    found = coercerhinoobject(object_id, True).Geometry
    kind = int(coercerhinoobject(object_id).ObjectType)
    if kind == 16 and isinstance(found, CLASSES["Brep"]) and len(found.Faces) == 1:
        return 8
    return kind


def ObjectName(object_id, name=None):
    found = coercerhinoobject(object_id, True)
    before = found.Name
    if name is not None:
        found.Name = str(name)
    return before or None


def ObjectLayer(object_id, layer=None):
    coercerhinoobject(object_id, True)
    return "Default"


def ObjectColor(object_ids, color=None):
    many = is_many(object_ids)
    found = [coercerhinoobject(one, True) for one in (object_ids if many else [object_ids])]
    before = found[0].Attributes.ObjectColor if found else None
    if color is not None:
        for one in found:
            one.Attributes.ObjectColor = coercecolor(color, True)
        return len(found) if many else before
    return before


def AllObjects(select=False, include_lights=False, include_grips=False):
    return [one.Id for one in scriptcontext.doc.Objects]


def ObjectsByLayer(layer_name, select=False):
    return [one.Id for one in scriptcontext.doc.Objects.FindByLayer(layer_name)]


def ObjectsByType(geometry_type, select=False, state=0):
    return [one.Id for one in scriptcontext.doc.Objects if geometry_type == 0 or int(one.ObjectType) & geometry_type]


def ObjectsByName(name, select=False, include_lights=False, include_references=False):
    return [one.Id for one in scriptcontext.doc.Objects if one.Name == name]


def FirstObject(select=False, include_lights=False, include_grips=False):
    found = AllObjects()
    return found[-1] if found else None


def LastObject(select=False, include_lights=False, include_grips=False):
    found = AllObjects()
    return found[0] if found else None


def BoundingBox_(objects, view_or_plane=None, in_world_coords=True):
    """Eight corners around all objects, along the world's axes or a plane's."""
    many = is_many(objects)
    plane = coerceplane(view_or_plane) if view_or_plane is not None else None
    total = None
    for one in (objects if many else [objects]):
        geometry = coercegeometry(one)
        if geometry is None:
            point = coerce3dpoint(one, True)
            box = BoundingBox(point, point)
        elif plane is not None:
            moved = geometry.Duplicate()
            moved.Transform(Transform.ChangeBasis(Plane.WorldXY, plane))
            box = moved.GetBoundingBox(True)
        else:
            box = geometry.GetBoundingBox(True)
        total = box if total is None else BoundingBox.Union(total, box)
    if total is None or not total.IsValid:
        return None
    corners = total.GetCorners()
    if plane is not None and in_world_coords:
        back = Transform.ChangeBasis(plane, Plane.WorldXY)
        corners = [back * corner for corner in corners]
    return corners


def SelectObject(object_id, redraw=True):
    """Nothing can be selected without a window."""
    return False


def SelectObjects(object_ids):
    return 0


UnselectObject = HideObject = ShowObject = LockObject = UnlockObject = SelectObject
UnselectAllObjects = lambda: 0  # noqa: E731
HideObjects = ShowObjects = SelectObjects


def IsObjectSolid(object_id):
    geometry = coercegeometry(object_id, True)
    if isinstance(geometry, CLASSES["Mesh"]):
        return geometry.IsClosed
    return bool(getattr(geometry, "IsSolid", False))
