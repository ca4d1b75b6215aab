"""Counts which members of RhinoCommon's classes are here, against published stubs.

    pip download --no-deps rhino-stubs-typed; unzip it; KATYDID=... python measure_members.py FOLDER [--missing]

A member counts as present when a script can name it: in Python, or in the host's table. Signatures are not compared.
"""

import ast
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.dirname(os.path.abspath(__file__))))

from katydid import rhino  # noqa: E402
from katydid.backend import current  # noqa: E402

#: The classes of Rhino.Geometry that scripts of real definitions use most, and what they are made of.
CLASSES = ["Point3d", "Vector3d", "Plane", "Curve", "Brep", "BoundingBox", "Line", "Interval", "Polyline", "Point", "Sphere",
           "Mesh", "Box", "Rectangle3d", "Circle", "Arc", "Point2d", "NurbsCurve", "MeshFace", "Point3f", "Vector3f",
           "MeshingParameters", "LineCurve", "Transform", "ArcCurve", "PolylineCurve", "PolyCurve", "Surface",
           "NurbsSurface", "PlaneSurface", "BrepFace", "BrepEdge", "SubD", "Extrusion", "AreaMassProperties",
           "VolumeMassProperties", "GeometryBase", "Vector2d", "Ellipse", "Cylinder"]

#: What every .NET object has, and operators, which Python names otherwise.
_SKIP = {"Equals", "GetHashCode", "GetType", "ToString", "Finalize", "MemberwiseClone", "__init__"}


def stub_classes(folder):
    """Names of members by class, as the stubs have them."""
    path = os.path.join(folder, "Rhino", "Geometry", "__init__.pyi")
    with open(path, encoding="utf-8") as source:
        tree = ast.parse(source.read())
    found = {}
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            found[node.name] = {item.name for item in node.body if isinstance(item, ast.FunctionDef)
                                and item.name not in _SKIP and not item.name.startswith("op_")}
    return found


def is_there(cls, name):
    """Whether a member of a class can be named."""
    if any(name in vars(base) for base in cls.__mro__ if base is not object):
        return True
    if name == "Item":
        return hasattr(cls, "__getitem__")
    slots = [slot for base in cls.__mro__ for slot in getattr(base, "__slots__", ())]
    if name in slots:
        return True
    if name in getattr(cls, "_fields", ()) or (cls.__name__ == "MeshingParameters" and hasattr(cls.Default, name)):
        return True
    names = getattr(cls, "_names", None)
    if names is None:
        return False
    from katydid.geometry.list_names import has_list
    table = current().table
    return any(table.has(owner, name) or table.has(owner, "get_" + name) or has_list(table, owner, name)
               for owner in names())


def main():
    folder, show = sys.argv[1], "--missing" in sys.argv
    rhino.install()
    import Rhino.Geometry as geometry
    stubs, present, total = stub_classes(folder), 0, 0
    for name in CLASSES:
        wanted = sorted(stubs.get(name, ()))
        cls = getattr(geometry, name, None)
        missing = [member for member in wanted if cls is None or not is_there(cls, member)]
        here = len(wanted) - len(missing)
        present, total = present + here, total + len(wanted)
        print("%-22s %3d of %3d%s" % (name, here, len(wanted), "  " + " ".join(missing) if show and missing else ""))
    print("%d classes: %d of %d members, %.0f %%" % (len(CLASSES), present, total, 100.0 * present / max(total, 1)))


if __name__ == "__main__":
    main()
