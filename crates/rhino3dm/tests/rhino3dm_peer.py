"""What this crate writes, as rhino3dm reads it, and what rhino3dm reads and writes, as this crate reads it.

Needs `pip install rhino3dm`; run with pytest or as a script. Arguments of the script are further files of encoded
objects, a JSON object with the members archive3dm, opennurbs and data a line.
"""

import base64
import json
import math
import pathlib
import subprocess
import sys
import tempfile
import types

import rhino3dm

CRATE = pathlib.Path(__file__).resolve().parent.parent
SHARED = CRATE.parent.parent.parent / "shared" / "data" / "3dm"
CLOSE = 1e-12
VERSIONS = (4, 50, 60, 70, 80)


def example(name, *arguments):
    command = ["cargo", "run", "-q", "-p", "katydid-3dm", "--example", name, "--", *map(str, arguments)]
    return subprocess.run(command, cwd=CRATE, check=True, capture_output=True, text=True).stdout


def dumped(path):
    return [json.loads(line) for line in example("dump", path).splitlines()]


def close(ours, theirs, what="", within=CLOSE):
    """Compares numbers and nested sequences of them, relatively beyond 1."""
    if isinstance(theirs, (list, tuple)):
        assert len(ours) == len(theirs), f"{what}: {len(ours)} here, {len(theirs)} there"
        for i, (a, b) in enumerate(zip(ours, theirs)):
            close(a, b, f"{what}[{i}]", within)
        return
    assert abs(ours - theirs) <= within * max(1.0, abs(theirs)), f"{what}: {ours} here, {theirs} there"


def xyz(p):
    return [p.X, p.Y, p.Z]


def ends(interval):
    return [interval.T0, interval.T1]


def homogeneous(curve):
    """Control points as (wx, wy, wz, w)."""
    return [[p.X, p.Y, p.Z, p.W] for p in (curve.Points[i] for i in range(len(curve.Points)))]


def check_curve(ours, theirs, what):
    close(ours["domain"], ends(theirs.Domain), f"{what} domain")
    kind = ours["kind"]
    wanted = {"line": "LineCurve", "arc": "ArcCurve", "polyline": "PolylineCurve", "nurbs": "NurbsCurve", "poly": "PolyCurve"}
    assert type(theirs).__name__ == wanted[kind], f"{what}: {kind} here, {type(theirs).__name__} there"
    if kind == "line":
        close(ours["from"], xyz(theirs.PointAtStart), f"{what} start")
        close(ours["to"], xyz(theirs.PointAtEnd), f"{what} end")
    elif kind == "arc":
        arc = theirs.Arc
        plane = arc.Plane
        close(ours["plane"], [xyz(plane.Origin), xyz(plane.XAxis), xyz(plane.YAxis), xyz(plane.ZAxis)], f"{what} plane")
        close(ours["radius"], arc.Radius, f"{what} radius")
        close(ours["angle"], [arc.StartAngle, arc.EndAngle], f"{what} angle")
    elif kind == "polyline":
        close(ours["points"], [xyz(theirs.Point(i)) for i in range(theirs.PointCount)], f"{what} points")
        for t, p in zip(ours["parameters"], ours["points"]):
            close(p, xyz(theirs.PointAt(t)), f"{what} at {t}", 1e-9)
    elif kind == "nurbs":
        assert ours["degree"] == theirs.Degree and ours["rational"] == theirs.IsRational, what
        close(ours["knots"], [theirs.Knots[i] for i in range(len(theirs.Knots))], f"{what} knots")
        close(ours["points"], homogeneous(theirs), f"{what} control points")
    else:
        assert len(ours["segments"]) == theirs.SegmentCount, what
        joints = [theirs.SegmentDomain(i).T0 for i in range(theirs.SegmentCount)] + [theirs.Domain.T1]
        close(ours["parameters"], joints, f"{what} joints")
        for i, segment in enumerate(ours["segments"]):
            check_curve(segment, theirs.SegmentCurve(i), f"{what} segment {i}")


def vertices(mesh):
    """In double precision where the mesh has it."""
    return [xyz(mesh.Vertices.Point3dAt(i)) for i in range(len(mesh.Vertices))]


def check_surface(ours, theirs, what):
    domains = [ends(theirs.Domain(0)), ends(theirs.Domain(1))]
    close(ours["domains"], domains, f"{what} domains")
    wanted = {"plane": "PlaneSurface", "sum": "Surface", "revolution": "RevSurface", "nurbs": "NurbsSurface"}
    # rhino3dm has no class of its own for sum surfaces.
    assert type(theirs).__name__ in (wanted[ours["kind"]], "Surface", "BrepFace"), f"{what}: {type(theirs).__name__}"
    (a, b), (c, d) = domains
    at = (0, 0.3, 0.5, 1)
    samples = [xyz(theirs.PointAt((1 - x) * a + x * b, (1 - y) * c + y * d)) for x in at for y in at]
    close(ours["samples"], samples, f"{what} samples", 1e-9)
    if ours["kind"] == "nurbs" and isinstance(theirs, rhino3dm.NurbsSurface):
        assert ours["degrees"] == [theirs.Degree(0), theirs.Degree(1)], what
        for mine, knots in zip(ours["knots"], (theirs.KnotsU, theirs.KnotsV)):
            close(mine, [knots[i] for i in range(len(knots))], f"{what} knots")


def check_mesh(ours, theirs, what):
    close(ours["vertices"], vertices(theirs), f"{what} vertices")
    faces = [theirs.Faces[i] for i in range(len(theirs.Faces))]
    assert ours["faces"] == [list(f[:3] if f[2] == f[3] else f) for f in faces], f"{what} faces"
    normals = [theirs.Normals[i] for i in range(len(theirs.Normals))]
    close(ours["normals"], [xyz(n) for n in normals], f"{what} normals", 1e-7)
    colours = [theirs.VertexColors[i] for i in range(len(theirs.VertexColors))]
    assert [c[:3] for c in ours["colours"]] == [list(c[:3]) for c in colours], f"{what} colours"


def check_brep(ours, theirs, what):
    assert "brep_error" not in ours, f"{what}: {ours}"
    assert ours["faces"] == len(theirs.Faces), what
    close(ours["vertices"], [xyz(theirs.Vertices[i].Location) for i in range(len(theirs.Vertices))], f"{what} vertices")
    assert len(ours["edges"]) == len(theirs.Edges), what
    for i, edge in enumerate(ours["edges"]):
        other = theirs.Edges[i]
        close(edge["domain"], ends(other.Domain), f"{what} edge {i} domain")
        if None not in edge["points"]:
            a, b = ends(other.Domain)
            points = [xyz(other.PointAt((1 - x) * a + x * b)) for x in (0, 0.3, 1)]
            close(edge["points"], points, f"{what} edge {i}", 1e-9)
    if ours["bare"]:
        assert len(theirs.Faces) == 1 and theirs.IsSurface, f"{what}: a bare surface here"
        check_surface(ours["bare"], theirs.Faces[0].UnderlyingSurface(), f"{what} surface")
    else:
        assert not theirs.IsSurface or theirs.Faces[0].OrientationIsReversed, f"{what}: a bare surface there"
    if ours["solidity"] != "Unknown" or ours["closed"]:
        assert ours["closed"] == theirs.IsSolid, f"{what}: closed {ours['closed']} here, {theirs.IsSolid} there"


def check_geometry(ours, theirs, what):
    """Compares one object; says whether it was taken apart here."""
    detail = ours["detail"]
    if isinstance(theirs, rhino3dm.Mesh) and not ours["kept"]:
        check_mesh(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.PointCloud):
        close(detail["points"], [xyz(p) for p in theirs.GetPoints()], f"{what} points")
        normals = theirs.GetNormals() if theirs.ContainsNormals else []
        close(detail["normals"], [xyz(n) for n in normals], f"{what} normals")
        colours = theirs.GetColors() if theirs.ContainsColors else []
        assert [c[:3] for c in detail["colours"]] == [list(c[:3]) for c in colours], f"{what} colours"
    elif isinstance(theirs, rhino3dm.Point):
        close(detail["point"], xyz(theirs.Location), what)
    elif ours["class"] == "AnnotationArrow":
        # rhino3dm turns the arrows of version 2 into lines.
        pass
    elif isinstance(theirs, rhino3dm.Surface) and not isinstance(theirs, rhino3dm.Extrusion):
        if not ours["kept"]:
            check_surface(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.Curve):
        assert not ours["kept"], f"{what}: a curve is kept as bytes"
        check_curve(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.Brep) and ours["class"] == "Brep":
        # Layouts of version 2 files are not summarised.
        if "major version 2" not in detail.get("brep_error", ""):
            check_brep(detail, theirs, what)
    return not ours["kept"]


def sample_curves():
    """Name to what `write_sample` states about each curve."""
    x = [1 / math.sqrt(2), 1 / math.sqrt(2), 0]
    z = [0.5 / 1.5, -0.5 / 1.5, 2 / 1.5]
    length = math.sqrt(sum(c * c for c in z))
    z = [c / length for c in z]
    y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]]
    plane = [[1, 2, 3], x, y, z]
    root = math.sqrt(0.5)
    rational = {"kind": "nurbs", "domain": [0, 1], "degree": 2, "rational": True, "knots": [0, 0, 1, 1],
                "points": [[1, 0, 0, 1], [root, root, 0, root], [0, 1, 0, 1]]}
    return {
        "line": {"kind": "line", "domain": [-1, 3.5], "from": [1, 1, 0], "to": [5, 6, 0]},
        "arc": {"kind": "arc", "domain": [0, 4], "plane": plane, "radius": 2.75, "angle": [math.pi / 6, math.pi * 2 / 3]},
        "circle": {"kind": "arc", "domain": [0, 2.75 * math.tau], "plane": plane, "radius": 2.75, "angle": [0, math.tau]},
        "polyline": {"kind": "polyline", "domain": [0, 6], "points": [[i, i % 2, 0.1 * i] for i in range(7)],
                     "parameters": [0, 1, 2.5, 3, 4, 5.25, 6]},
        "nurbs": {"kind": "nurbs", "domain": [0, 4], "degree": 3, "rational": False, "knots": [0, 0, 0, 1, 1.5, 4, 4, 4],
                  "points": [[i, i * i / 3, 0.7, 1] for i in range(6)]},
        "rational": rational,
        "polycurve": {"kind": "poly", "domain": [0, 7], "parameters": [0, 2, 3, 7], "segments": [
            {"kind": "line", "domain": [0, 2], "from": [3, 0, 0], "to": [1, 0, 0]},
            rational,
            {"kind": "polyline", "domain": [0, 2], "points": [[0, 1, 0], [0, 2, 0], [-1, 2, 1]], "parameters": [0, 1, 2]},
        ]},
    }


def sample_plane():
    plane = sample_curves()["arc"]["plane"]
    return lambda x, y: [o + x * a + y * b for o, a, b in zip(*plane[:3])]


def sample_plane_surface():
    at, steps = sample_plane(), (0, 0.3, 0.5, 1)
    return {"kind": "plane", "domains": [[0, 1], [2, 8]],
            "samples": [at(-1 + 5 * x, 2 * y) for x in steps for y in steps]}


def check_sphere(sphere):
    centre = sample_plane()(0, 0)
    for u in (0, 1, 2.5, 6):
        for v in (-1.5, -0.2, 0, 1):
            close(math.dist(xyz(sphere.PointAt(u, v)), centre), 2.75, "sphere", 1e-12)


def sample_mesh():
    columns, rows = 20, 15
    faces = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            a = row * columns + column
            if (row + column) % 3 == 0:
                faces += [[a, a + 1, a + columns + 1], [a, a + columns + 1, a + columns]]
            else:
                faces.append([a, a + 1, a + columns + 1, a + columns])
    count = columns * rows
    return {
        "vertices": [[(i % columns) * 0.1, (i // columns) / 3, i / 7] for i in range(count)],
        "faces": faces,
        "normals": [[0, 0.6, 0.8]] * count,
        "colours": [[i % 256, i // 2, 7, 255] for i in range(count)],
    }


def check_sample(version):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "sample.3dm"
        example("write_sample", path, version)
        file = rhino3dm.File3dm.Read(str(path))
        notes = rhino3dm.File3dm.ReadNotes(str(path))
    assert file is not None and file.ArchiveVersion == version
    assert notes == "Written for a reader.\nZweite Zeile.", notes
    assert file.Settings.ModelUnitSystem == rhino3dm.UnitSystem.Centimeters
    close(file.Settings.ModelAbsoluteTolerance, 0.0025)
    close(file.Settings.ModelAngleToleranceRadians, 0.02)
    assert file.ApplicationName == "Katydid"
    layers = [(layer.Name, layer.FullPath, layer.Color[:3]) for layer in file.Layers]
    assert layers == [("curves", "curves", (200, 30, 10)), ("conics ⌀", "curves::conics ⌀", (0, 128, 255)), ("rest", "rest", (0, 0, 0))], layers
    objects = {o.Attributes.Name: o for o in file.Objects}
    assert len(objects) == len(file.Objects) == 18
    for i, o in enumerate(file.Objects):
        assert o.Attributes.Id.int == 0xABCD_0000 + i + 1
        valid, log = o.Geometry.IsValidWithLog
        assert valid, f"{o.Attributes.Name}: {log}"
    where = {"point": 2, "cloud": 2, "line": 0, "arc": 1, "circle": 1, "polyline": 0, "nurbs": 0, "rational": 1,
             "polycurve": 0, "plane surface": 2, "sum surface": 2, "revolution": 2, "transposed revolution": 2,
             "sphere": 2, "nurbs surface": 2, "rational surface": 2, "mesh": 2, "plain mesh": 2}
    assert {name: o.Attributes.LayerIndex for name, o in objects.items()} == where
    line = objects["line"].Attributes
    assert line.ObjectColor[:3] == (12, 34, 56) and line.ColorSource == rhino3dm.ObjectColorSource.ColorFromObject
    assert line.Url == "https://example.org/"
    assert sorted(line.GetUserStrings()) == [("Länge", "√41"), ("material", "larch")], line.GetUserStrings()
    assert not objects["cloud"].Attributes.Visible and objects["point"].Attributes.Visible
    assert objects["arc"].Attributes.Mode == rhino3dm.ObjectMode.Locked
    assert objects["arc"].Attributes.ColorSource == rhino3dm.ObjectColorSource.ColorFromLayer
    close([0.1, -2.5, 1e6], xyz(objects["point"].Geometry.Location))
    cloud = {"points": [[i, 0.5, -1 / 3] for i in range(5)], "normals": [[0, 0, 1]] * 5, "colours": [[10 * i, 20, 30, 255] for i in range(5)]}
    check_geometry({"detail": cloud, "kept": False, "class": "PointCloud"}, objects["cloud"].Geometry, "cloud")
    for name, curve in sample_curves().items():
        check_curve(curve, objects[name].Geometry, name)
    check_surface(sample_plane_surface(), objects["plane surface"].Geometry, "plane surface")
    check_sphere(objects["sphere"].Geometry)
    check_mesh(sample_mesh(), objects["mesh"].Geometry, "mesh")
    plain = {"vertices": [[x, y, 0.25] for x, y in ((0, 0), (2, 0), (2, 1), (0, 1), (3, 0.5))],
             "faces": [[0, 1, 2, 3], [1, 4, 2]], "normals": [], "colours": []}
    check_mesh(plain, objects["plain mesh"].Geometry, "plain mesh")
    return {name: o.Geometry for name, o in objects.items()}


def test_what_we_write_is_read_by_rhino3dm():
    for version in VERSIONS:
        check_sample(version)
        print(f"version {version}: 18 objects, layers, units, colours, names and user strings equal")


def check_encoded(path, strict):
    """Objects encoded by rhino3dm or Rhino: read here, compared, written here and read there again."""
    forms = [json.loads(line) for line in pathlib.Path(path).read_text().splitlines()]
    counts = types.SimpleNamespace(read=0, apart=0, identical=0)
    for i, (form, ours) in enumerate(zip(forms, dumped(path), strict=True)):
        what = f"object {i}"
        assert "error" not in ours, f"{what}: {ours}"
        theirs = rhino3dm.CommonObject.Decode({k: form[k] for k in ("version", "archive3dm", "opennurbs", "data")})
        counts.read += 1
        written = ours["written"]
        assert written["read_back_equal"], what
        if check_geometry(ours["geometry"], theirs, what):
            counts.apart += 1
            back = rhino3dm.CommonObject.Decode({k: written[k] for k in ("version", "archive3dm", "opennurbs", "data")})
            check_geometry(ours["geometry"], back, f"{what} written here")
            theirs_again = theirs.Encode()
            counts.identical += base64.b64decode(theirs_again["data"]) == base64.b64decode(written["data"])
    print(f"{path}: {counts.read} objects read, {counts.apart} taken apart and equal, "
          f"{counts.identical} written byte for byte as rhino3dm does")
    if strict:
        assert counts.identical == counts.apart


def test_the_comparison_notices_small_differences():
    """A negative control: a nudge that matters to nobody but the comparison."""
    curve = rhino3dm.NurbsCurve.Create(False, 2, [rhino3dm.Point3d(x, x * x, 0) for x in range(5)])
    true = {"kind": "nurbs", "domain": ends(curve.Domain), "degree": 2, "rational": False,
            "knots": [curve.Knots[i] for i in range(len(curve.Knots))], "points": homogeneous(curve)}
    check_curve(true, curve, "as it is")
    for part in ("knots", "points", "domain"):
        nudged = json.loads(json.dumps(true))
        values = nudged[part][2] if part == "points" else nudged[part]
        values[1] += 1e-9
        try:
            check_curve(nudged, curve, "nudged")
        except AssertionError:
            continue
        raise AssertionError(f"a change of 1e-9 in the {part} went unnoticed")


def test_encoded_objects_come_out_as_they_went_in():
    geometry = check_sample(60)
    # A long buffer is deflated by another library here than there.
    names = [name for name in geometry if name != "mesh"]
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "objects.jsonl"
        path.write_text("\n".join(json.dumps(geometry[name].Encode()) for name in names))
        check_encoded(path, strict=True)


def check_archive(path):
    head, *objects = dumped(path)
    if "error" in head:
        assert "version 1" in head["error"], head
        return None
    file = rhino3dm.File3dm.Read(str(path))
    assert file is not None and len(file.Objects) == len(objects), f"{path.name}: {len(file.Objects)} there, {len(objects)} here"
    known = {"None", "Microns", "Millimeters", "Centimeters", "Meters", "Kilometers", "Inches", "Feet", "Yards", "Miles"}
    units = file.Settings.ModelUnitSystem.name
    assert head["units"] == (units if units in known else "None"), units
    close(head["absolute"], file.Settings.ModelAbsoluteTolerance, "tolerance")
    layers = [(layer.Name, list(layer.Color[:3])) for layer in file.Layers]
    assert [(layer["name"], layer["colour"][:3]) for layer in head["layers"]] == layers, path.name
    apart = 0
    for i, (ours, theirs) in enumerate(zip(objects, file.Objects)):
        what = f"{path.name} object {i}"
        attributes = theirs.Attributes
        # rhino3dm copies a light's own name into attributes without one.
        if ours["name"] or not isinstance(theirs.Geometry, rhino3dm.Light):
            assert ours["name"] == attributes.Name, what
        # A layer that is not there is -1 there and the first one here.
        assert ours["layer"] == max(0, attributes.LayerIndex), f"{what}: layer {ours['layer']}, {attributes.LayerIndex}"
        assert ours["visible"] == attributes.Visible, what
        own = attributes.ColorSource == rhino3dm.ObjectColorSource.ColorFromObject
        assert (ours["colour"] or [None] * 3)[:3] == (list(attributes.ObjectColor[:3]) if own else [None] * 3), what
        assert len(ours["user_strings"]) >= attributes.UserStringCount, what
        apart += check_geometry(ours["geometry"], theirs.Geometry, what)
    return len(objects), apart, len(layers)


def test_real_archives_are_read_as_rhino3dm_reads_them():
    paths = sorted(SHARED.glob("*.3dm"))
    if not paths:
        print("skipped: there are no shared archives")
        return
    results = [check_archive(path) for path in paths]
    read = [r for r in results if r]
    objects, apart, layers = (sum(column) for column in zip(*read))
    print(f"{len(read)} archives ({len(results) - len(read)} of version 1 refused): {objects} objects, "
          f"{apart} of them taken apart, and {layers} layers equal")


def check_conversion(path, version):
    """An archive read and written here against the same archive as rhino3dm reads it."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.3dm"
        carried = json.loads(example("convert", path, out, version))
        if carried is None:
            return 0, 0
        before, after = rhino3dm.File3dm.Read(str(path)), rhino3dm.File3dm.Read(str(out))
    assert len(after.Objects) == len(carried), path.name
    same = 0
    for place, i in enumerate(carried):
        old, new = before.Objects[i], after.Objects[place]
        what = f"{path.name} as {version}, object {i}"
        assert type(old.Geometry) is type(new.Geometry), what
        was_valid, is_valid = old.Geometry.IsValid, new.Geometry.IsValid
        assert is_valid or not was_valid, f"{what}: {new.Geometry.IsValidWithLog[1]}"
        if isinstance(old.Geometry, rhino3dm.Mesh):
            # Boxes of meshes come from the single-precision vertices, which may be rounded another way.
            close(vertices(new.Geometry), vertices(old.Geometry), what)
        elif not isinstance(old.Geometry, rhino3dm.AnnotationBase):
            boxes = [geometry.GetBoundingBox() for geometry in (new.Geometry, old.Geometry)]
            close(*([xyz(box.Min), xyz(box.Max)] for box in boxes), what, 1e-9)
        assert old.Attributes.Name == new.Attributes.Name, what
        same += encoded(old.Geometry) == encoded(new.Geometry)
    return len(carried), same


def encoded(geometry):
    try:
        return geometry.Encode()["data"]
    except Exception:  # rhino3dm does not encode every class
        return None


def test_converted_archives_hold_the_same_objects():
    for version in VERSIONS:
        results = [check_conversion(path, version) for path in sorted(SHARED.glob("*.3dm"))]
        if results:
            objects, same = (sum(column) for column in zip(*results))
            print(f"version {version}: {objects} objects carried over and valid, {same} of them encoded alike")


if __name__ == "__main__":
    test_the_comparison_notices_small_differences()
    test_what_we_write_is_read_by_rhino3dm()
    test_encoded_objects_come_out_as_they_went_in()
    test_real_archives_are_read_as_rhino3dm_reads_them()
    test_converted_archives_hold_the_same_objects()
    for extra in sys.argv[1:]:
        check_encoded(extra, strict=False)
