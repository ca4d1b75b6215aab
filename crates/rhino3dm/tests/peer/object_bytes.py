"""Single objects: read from the bytes in which rhino3dm encodes them, and written here byte for byte."""

import base64
import collections
import json
import math
import pathlib
import tempfile

import rhino3dm as r

from .common import SHARED, dumped
from .generated_documents import FAMILIES, seeds
from .generated_models import SEED, Maker

ORACLE = SHARED.parent / "oracle" / "on_dev.json"
ENCODED = ("version", "archive3dm", "opennurbs", "data")


def control_point(values, rational, dimension):
    weight = values[-1] if rational else 1.0
    coordinates = [*values[:dimension], 0.0, 0.0][:3]
    return r.Point4d(*coordinates, weight)


def curve_of(form):
    curve = r.NurbsCurve(form["dim"], bool(form["rat"]), form["order"], len(form["cv"]))
    for i, point in enumerate(form["cv"]):
        curve.Points[i] = control_point(point, form["rat"], form["dim"])
    for i, knot in enumerate(form["knots"]):
        curve.Knots[i] = knot
    return curve


def surface_of(form):
    surface = r.NurbsSurface.Create(form["dim"], bool(form["rat"]), *form["order"], *form["n"])
    for i, point in enumerate(form["cv"]):
        surface.Points[divmod(i, form["n"][1])] = control_point(point, form["rat"], form["dim"])
    for list_, knots in zip((surface.KnotsU, surface.KnotsV), form["knots"]):
        for i, knot in enumerate(knots):
            list_[i] = knot
    return surface


def nurbs_forms(value):
    """Every NURBS curve and surface that stands anywhere in the oracle."""
    if isinstance(value, dict):
        if {"dim", "rat", "order", "knots", "cv"} <= value.keys():
            yield curve_of(value) if isinstance(value["order"], int) else surface_of(value)
            return
        value = list(value.values())
    if isinstance(value, list):
        for inner in value:
            yield from nurbs_forms(inner)


def plane_of(axes):
    origin, x, y, _ = (r.Point3d(*point) for point in axes)
    return r.Plane(origin, r.Point3d(origin.X + x.X, origin.Y + x.Y, origin.Z + x.Z),
                   r.Point3d(origin.X + y.X, origin.Y + y.Y, origin.Z + y.Z))


def conic_of(given):
    if given["kind"] == "Arc3pt":
        return r.ArcCurve.CreateFromArc(r.Arc(*(r.Point3d(*point) for point in given["p"])))
    circle = r.Circle(r.Point3d(0, 0, 0), given["r"])
    circle.Plane = plane_of(given["plane"])
    if given["kind"] == "Circle":
        return r.ArcCurve.CreateFromCircle(circle)
    arc = r.Arc(circle, given["angle"][1] - given["angle"][0])
    return r.ArcCurve.CreateFromArc(arc)


def primitives_of(given):
    """What the oracle makes of a primitive, as objects."""
    kind = given["f"].split()[0]
    if kind == "Sphere":
        sphere = r.Sphere(r.Point3d(*given["c"]), given["r"])
        return [sphere.ToBrep(), sphere.ToNurbsSurface(), r.Brep.CreateQuadSphere(sphere)]
    if kind == "Cylinder":
        circle = r.Circle(r.Point3d(0, 0, 0), given["r"])
        circle.Plane = plane_of(given["plane"])
        cylinder = r.Cylinder(circle, given.get("h", 2.5))
        return [cylinder.ToBrep(True, True), cylinder.ToNurbsSurface(),
                r.Extrusion.CreateCylinderExtrusion(cylinder, True, True)]
    if kind == "Box":
        box = r.BoundingBox(r.Point3d(*given["min"]), r.Point3d(*given["max"]))
        return [r.Brep.CreateFromBoundingBox(box), r.Extrusion.CreateBoxExtrusion(r.Box(box), True)]
    if kind == "RevSurface":
        axis = r.Line(r.Point3d(0, 0, 0), r.Point3d(0, 0, 1))
        turned = r.RevSurface.Create(curve_of(given["profile"]), axis, 0, 2 * math.pi)
        return [turned, r.Brep.CreateFromRevSurface(turned, True, True)]
    if kind == "Extrusion.Create":
        circle = r.Circle(r.Point3d(*given["c"]), given["r"])
        extrusion = r.Extrusion.Create(r.ArcCurve.CreateFromCircle(circle), given["h"], True)
        return [extrusion, extrusion.ToBrep(True)]
    return [r.NurbsSurface.CreateRuledSurface(curve_of(given["a"]), curve_of(given["b"]))]


def oracle_objects():
    oracle = json.loads(ORACLE.read_text())
    objects = list(nurbs_forms(oracle)) + [conic_of(entry["in"]) for entry in oracle["conics"]]
    for entry in oracle["primitives"]:
        objects += primitives_of(entry["in"])
    return [made for made in objects if made is not None]


def generated_objects(seed):
    for family in FAMILIES:
        yield from getattr(Maker(seed), family)()
    yield from seeds(Maker(seed))


def compare(objects):
    """How many objects of each class have the same bytes, are equal where read by rhino3dm, or differ."""
    forms = [made.Encode() for made in objects]
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "objects.jsonl"
        path.write_text("\n".join(json.dumps({key: form[key] for key in ENCODED}) for form in forms))
        lines = dumped(path)
    counts = collections.defaultdict(collections.Counter)
    for made, form, line in zip(objects, forms, lines, strict=True):
        count = counts[type(made).__name__]
        count["objects"] += 1
        assert "error" not in line and line["written"], f"{type(made).__name__}: {line.get('error')}"
        assert not line["geometry"]["kept"], f"{type(made).__name__} is kept as bytes"
        written = line["written"]
        assert written["read_back_equal"], type(made).__name__
        if base64.b64decode(form["data"]) == base64.b64decode(written["data"]):
            count["identical"] += 1
        else:
            theirs, ours = (r.CommonObject.Decode({key: f[key] for key in ENCODED}) for f in (form, written))
            count["equal" if theirs.Encode()["data"] == ours.Encode()["data"] else "different"] += 1
    return counts


def report(what, counts):
    total = sum(counts.values(), collections.Counter())
    share = 100 * total["identical"] / max(1, total["objects"])
    print(f"{what}: {total['identical']} of {total['objects']} objects identical to the byte ({share:.1f} %), "
          f"{total['equal']} equal but for deflated buffers, {total['different']} different")
    return total, share


def check_oracle():
    if not ORACLE.exists():
        print("skipped: there is no oracle")
        return
    total, share = report("oracle", compare(oracle_objects()))
    assert share >= 99 and not total["different"]


def check_generated(seed=SEED):
    counts = compare(list(generated_objects(seed)))
    total, _ = report("generated", counts)
    # Buffers of meshes are deflated by another program.
    deflated = ("Mesh", "Brep", "Extrusion")
    unlike = {name: dict(count) for name, count in counts.items()
              if count["identical"] < count["objects"] and name not in deflated}
    assert not unlike, unlike
    assert not total["different"]
