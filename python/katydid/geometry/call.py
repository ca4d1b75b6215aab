"""How a call of a script becomes a call of the host's table, and how its answer becomes what IronPython gives."""

import re

from ..backend import current
from ..values import (Arc, Circle, Cone, Cylinder, Ellipse, Line, Plane, Point3d, Polyline, Ray3d, Rectangle3d, Torus,
                      Vector3d)
from ..values.base import NotSupported, not_supported
from ..values.enums import member as enum_member
from ..values.netlist import NetList
from .list_names import ENUM_RESULTS, POLYLINES

_ARROW = re.compile(r"\)\s*->\s*(.*)$")


def full_name(cls_name, member):
    """The name that errors give a member."""
    space = {"Intersection": "Rhino.Geometry.Intersect.", "MeshClash": "Rhino.Geometry.Intersect."}
    return space.get(cls_name, "Rhino.Geometry.") + cls_name + "." + member


def given(signature):
    """The types that a signature gives: the result first, then what RhinoCommon has in out parameters."""
    found = _ARROW.search(signature)
    if not found or not found.group(1).strip():
        return []
    # Commas within generic types do not part results.
    parts, depth, start = [], 0, 0
    text = found.group(1)
    for i, letter in enumerate(text):
        depth += letter in "<[(" and 1 or letter in ">])" and -1 or 0
        if letter == "," and depth == 0:
            parts.append(text[start:i].strip())
            start = i + 1
    return parts + [text[start:].strip()]


def shaped(answer, signatures):
    """A list that stands for a result and its out values becomes a tuple; other lists get .NET's methods."""
    if type(answer) is dict:
        return solid_of(answer)
    if type(answer) is not list:
        return answer
    answer = [solid_of(part) if type(part) is dict else part for part in answer]
    counts = {len(given(signature)) for signature in signatures}
    if len(answer) > 1 and len(answer) in counts:
        if 1 not in counts or _is_status(answer[0]):
            return tuple(NetList(part) if type(part) is list else part for part in answer)
    return NetList(answer)


#: Structs that travel by their properties: the class, by its properties in the order of its constructor.
_BY_PROPERTIES = {frozenset(names): (cls, names) for cls, names in (
    (Cone, ("Plane", "Height", "Radius")), (Torus, ("Plane", "MajorRadius", "MinorRadius")),
    (Ray3d, ("Position", "Direction")))}
_CYLINDER = {"BasePlane", "Radius", "Height1", "Height2"}


def part_of(value):
    """A point or a plane of its properties; other values as they are."""
    if type(value) is not dict:
        return value
    if {"Origin", "XAxis", "YAxis"} <= set(value):
        axes = [Vector3d(*[value[name][one] for one in "XYZ"]) for name in ("XAxis", "YAxis")]
        return Plane(part_of(value["Origin"]), *axes)
    return Point3d(*[value[one] for one in "XYZ"]) if set("XYZ") <= set(value) else value


def solid_of(answer):
    """The struct of its properties; any other map as it is."""
    found = _BY_PROPERTIES.get(frozenset(answer))
    if found is not None:
        return found[0](*[part_of(answer[name]) for name in found[1]])
    if set(answer) == _CYLINDER:
        made = Cylinder(Circle(part_of(answer["BasePlane"]), answer["Radius"]))
        made.Height1, made.Height2 = answer["Height1"], answer["Height2"]
        return made
    return answer


def _is_status(value):
    return isinstance(value, (bool, int)) or value is None


def boxes_apart(arguments):
    """Arguments without the boxes that wait for out values (clr.StrongBox, clr.Reference), and those boxes."""
    boxes = [argument for argument in arguments if hasattr(type(argument), "_is_box")]
    return ([argument for argument in arguments if not hasattr(type(argument), "_is_box")], boxes) if boxes \
        else (arguments, boxes)


def invoke(owner, member, names, arguments, keywords=None):
    """Calls a member: `owner` is the class to call it on, `names` those whose signatures it may have."""
    backend = current()
    arguments, boxes = boxes_apart(list(arguments))
    signatures = [s for name in names for s in backend.table.signatures(name, member)]
    if keywords:
        arguments = arguments + placed(owner, member, signatures, len(arguments), keywords)
    try:
        answer = backend.call(owner + "." + member, *map(lowered, arguments))
    except NotSupported as error:
        if str(error).endswith("supported by Katydid yet"):
            raise
        # The host names its own path; scripts know the member.
        raise not_supported(full_name(owner, member)) from None
    answer = shaped(answer, signatures)
    if member in POLYLINES and isinstance(answer, list):
        return NetList(Polyline(points) for points in answer)
    if type(answer) is int and member in ENUM_RESULTS:
        return enum_member(ENUM_RESULTS[member], answer)
    if boxes and isinstance(answer, tuple):
        for box, value in zip(boxes, answer[1:]):
            box.Value = value
        return answer[0]
    return answer


def placed(owner, member, signatures, already, keywords):
    """Keyword arguments in the places of the signature that has all the names."""
    for signature in signatures:
        inside = signature[signature.find("(") + 1:signature.rfind(")", 0, signature.rfind("->"))]
        names = [part.strip().split(" ")[-1] for part in inside.split(",")]
        rest = names[already:]
        if set(rest[:len(keywords)]) == set(keywords):
            return [keywords[name] for name in rest[:len(keywords)]]
    raise TypeError("%s has no overload with %s" % (full_name(owner, member), ", ".join(sorted(keywords))))


def lowered(value):
    """Iterables other than lists are read before they travel; the rest goes as it is."""
    if value is None or hasattr(type(value), "_lower") or isinstance(value, (str, bytes, dict, list, tuple)):
        return value
    if hasattr(value, "__next__") or isinstance(value, (range, set, frozenset, map, filter, zip)):
        return list(value)
    return value


def static_call(cls_name, member, *arguments):
    """A static member of a class."""
    return invoke(cls_name, member, [cls_name], arguments)


member_call = static_call


def call(thing, member, *arguments):
    """A member of an object, found through its class."""
    return getattr(thing, member)(*arguments)


def construct(cls_name, *arguments):
    """A new object of a class."""
    from .classes import CLASSES
    return CLASSES[cls_name](*arguments)


def as_curve(value):
    """A curve of a curve or of a struct that C# converts to one; other values as they are."""
    if isinstance(value, Line):
        return construct("LineCurve", value)
    if isinstance(value, (Circle, Arc)):
        return construct("ArcCurve", value)
    if isinstance(value, Polyline):
        return construct("PolylineCurve", value)
    if isinstance(value, Rectangle3d):
        return construct("PolylineCurve", value.ToPolyline())
    if isinstance(value, Ellipse):
        return static_call("NurbsCurve", "CreateFromEllipse", value)
    return value
