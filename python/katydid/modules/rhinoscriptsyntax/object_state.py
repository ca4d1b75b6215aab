"""Objects of the document: sheared, compared, described. Without a window nothing is hidden, locked or selected."""

import math

import scriptcontext
from katydid.geometry import CLASSES
from katydid.values import BoundingBox, Plane, Transform, Vector3d

from .coerce import (coerce3dpoint, coerceboundingbox, coercecolor, coercegeometry, coercerhinoobject)
from .objects import AllObjects, BoundingBox_, TransformObjects, _one
from .support import is_many


def _shear(origin, reference_point, angle_degrees):
    """In the construction plane: what is at right angles to the line to the reference leans along that line by an angle."""
    start = coerce3dpoint(origin, True)
    along = coerce3dpoint(reference_point, True) - start
    along.Z = 0.0
    if along.IsTiny():
        raise ValueError("origin and reference point are too close to each other")
    frame = Plane(start, along, Vector3d.CrossProduct(Vector3d.ZAxis, along))
    lean = math.tan(math.radians(float(angle_degrees)))
    return Transform.Shear(frame, Vector3d(1.0, 0.0, 0.0), Vector3d(lean, 1.0, 0.0), Vector3d(0.0, 0.0, 1.0))


def ShearObjects(object_ids, origin, reference_point, angle_degrees, copy=False):
    return TransformObjects(object_ids, _shear(origin, reference_point, angle_degrees), copy)


def ShearObject(object_id, origin, reference_point, angle_degrees, copy=False):
    return _one(object_id, _shear(origin, reference_point, angle_degrees), copy)


_DESCRIPTIONS = {"Point": "point", "PointCloud": "point cloud", "Mesh": "mesh", "SubD": "SubD", "Hatch": "hatch",
                 "TextDot": "text dot", "Extrusion": "extrusion"}


def ObjectDescription(object_id):
    """A word for the kind of an object."""
    geometry = coercerhinoobject(object_id, True).Geometry
    kind = type(geometry).__name__
    if kind in _DESCRIPTIONS:
        return _DESCRIPTIONS[kind]
    if isinstance(geometry, CLASSES["Curve"]):
        return "closed curve" if geometry.IsClosed else "open curve"
    if isinstance(geometry, CLASSES["Brep"]) and len(geometry.Faces) > 1:
        return "closed polysurface" if geometry.IsSolid else "open polysurface"
    return "surface"


def IsObjectValid(object_id):
    return bool(coercerhinoobject(object_id, True).Geometry.IsValid)


def IsObjectInBox(object_id, box, test_mode=True):
    """Whether an object lies wholly in a box; with `test_mode` off, whether a part of it does."""
    outer = coerceboundingbox(box, True)
    inner = BoundingBox(BoundingBox_(object_id))
    if test_mode:
        return bool(outer.Contains(inner.Min) and outer.Contains(inner.Max))
    return all(getattr(inner.Max, name) >= getattr(outer.Min, name) and getattr(inner.Min, name) <= getattr(outer.Max, name)
               for name in ("X", "Y", "Z"))


def IsObjectNormal(object_id):
    """Neither hidden nor locked: as all are here."""
    return bool(coercerhinoobject(object_id, True).IsNormal)


def IsObjectHidden(object_id):
    return bool(coercerhinoobject(object_id, True).IsHidden)


def IsObjectLocked(object_id):
    return bool(coercerhinoobject(object_id, True).IsLocked)


def IsObjectReference(object_id):
    return bool(coercerhinoobject(object_id, True).IsReference)


def IsObjectSelectable(object_id):
    return coercerhinoobject(object_id, True) is not None


def IsObjectSelected(object_id):
    coercerhinoobject(object_id, True)
    return False


def ObjectNames(sort=False):
    """The names that objects have."""
    names = [one.Name for one in scriptcontext.doc.Objects if one.Name]
    return sorted(names) if sort else names


def MatchObjectAttributes(target_ids, source_id=None):
    """Gives objects the attributes of another one; plain ones where there is none. How many were changed."""
    targets = target_ids if is_many(target_ids) else [target_ids]
    from katydid.document.objects import Attributes
    for one in targets:
        found = coercerhinoobject(one, True)
        found.Attributes = Attributes() if source_id is None else coercerhinoobject(source_id, True).Attributes.Duplicate()
    return len(targets)


def NormalObjects(include_lights=False, include_grips=False):
    return AllObjects()


def HiddenObjects(include_lights=False, include_grips=False, include_references=False):
    return []


def LockedObjects(include_lights=False, include_grips=False, include_references=False):
    return []


def SelectedObjects(include_lights=False, include_grips=False):
    return []


def InvertSelectedObjects(include_lights=False, include_grips=False, include_references=False):
    return []


def UnselectObjects(object_ids):
    return 0


def LockObjects(object_ids):
    return 0


def UnlockObjects(object_ids):
    return 0


def FlashObject(object_ids, style=True):
    """Nothing is drawn by a script."""


def NextObject(object_id, select=False, include_lights=False, include_grips=False):
    """The object that was added before another one; None for the first."""
    guids = AllObjects()
    place = guids.index(coercerhinoobject(object_id, True).Id)
    return guids[place - 1] if place > 0 else None


def ObjectsByColor(color, select=False, include_lights=False):
    wanted = coercecolor(color, True)
    return [one.Id for one in scriptcontext.doc.Objects if one.Attributes.ObjectColor == wanted]


def IsTextDot(object_id):
    return isinstance(coercegeometry(object_id), CLASSES["TextDot"])


def _dot(object_id):
    found = coercegeometry(object_id, True)
    if not isinstance(found, CLASSES["TextDot"]):
        raise ValueError("%s is no text dot" % object_id)
    return found


def _kept(object_id, geometry):
    found = coercerhinoobject(object_id, True)
    found.value = found._geometry = geometry


def TextDotText(object_id, text=None):
    dot = _dot(object_id)
    before = dot.Text
    if text is not None:
        dot.Text = str(text)
        _kept(object_id, dot)
    return before


def TextDotPoint(object_id, point=None):
    dot = _dot(object_id)
    before = dot.Point
    if point is not None:
        dot.Point = coerce3dpoint(point, True)
        _kept(object_id, dot)
    return before


def TextDotHeight(object_id, height=None):
    if height is not None:
        raise NotImplementedError("rhinoscriptsyntax.TextDotHeight sets no heights")
    return _dot(object_id).FontHeight


def TextDotFont(object_id, fontface=None):
    if fontface is not None:
        raise NotImplementedError("rhinoscriptsyntax.TextDotFont sets no fonts")
    return _dot(object_id).FontFace


def PointCloudCount(object_id):
    return coercegeometry(object_id, True).Count


def PointCloudHasPointColors(object_id):
    return bool(coercegeometry(object_id, True).ContainsColors)


def PointCloudPointColors(object_id, colors=[]):
    """The colours of the points, None without."""
    cloud = coercegeometry(object_id, True)
    before = list(cloud.GetColors()) if cloud.ContainsColors else None
    if colors:
        made = CLASSES["PointCloud"]()
        made.AddRange(list(cloud.GetPoints()), [coercecolor(color, True) for color in colors])
        _kept(object_id, made)
    return before
