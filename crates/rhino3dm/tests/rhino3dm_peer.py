"""What this crate writes, as rhino3dm reads it, and what rhino3dm reads and writes, as this crate reads it.

Needs `pip install rhino3dm`; run with pytest or as a script. Arguments of the script are further files of encoded
objects, a JSON object with the members archive3dm, opennurbs and data a line.
"""

import base64
import json
import pathlib
import sys
import tempfile
import types

import rhino3dm

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))

from peer.classes import check_bytes_of_real_objects, check_written_classes
from peer import generated, object_bytes, version1
from peer.common import SHARED, VERSIONS, close, dumped, encoded, ends, example, xyz
from peer.curves import check_curve, homogeneous
from peer.geometry import check_geometry
from peer.meshes import vertices
from peer.sample import check_sample


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
    assert "error" not in head, head
    file = rhino3dm.File3dm.Read(str(path))
    assert file is not None and len(file.Objects) == len(objects), f"{path.name}: {len(file.Objects)} there, {len(objects)} here"
    known = {"None", "Microns", "Millimeters", "Centimeters", "Meters", "Kilometers", "Inches", "Feet", "Yards", "Miles"}
    units = file.Settings.ModelUnitSystem.name
    assert head["units"] == (units if units in known else "None"), units
    close(head["absolute"], file.Settings.ModelAbsoluteTolerance, "tolerance")
    layers = [(layer.Name, list(layer.Color[:3])) for layer in file.Layers]
    assert [(layer["name"], layer["colour"][:3]) for layer in head["tables"]["layers"]] == layers, path.name
    apart = 0
    for i, (ours, theirs) in enumerate(zip(objects, file.Objects)):
        what = f"{path.name} object {i}"
        attributes = theirs.Attributes
        # rhino3dm copies a light's own name into attributes without one.
        if ours["name"] or not isinstance(theirs.Geometry, rhino3dm.Light):
            assert ours["name"] == attributes.Name, what
        assert ours["layer"] == attributes.LayerIndex, f"{what}: layer {ours['layer']}, {attributes.LayerIndex}"
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
    objects, apart, layers = (sum(column) for column in zip(*results))
    print(f"{len(results)} archives: {objects} objects, {apart} of them taken apart, and {layers} layers equal")


def test_archives_of_version_1_are_read_as_rhino3dm_reads_them():
    version1.check_samples(next(iter(sorted(SHARED.glob("*_v2_*.3dm"))), None))
    version1.check_all(sorted(SHARED.glob("*_v1_*.3dm")))


def test_objects_of_small_classes_have_the_bytes_of_rhino3dm():
    check_bytes_of_real_objects()
    for version in VERSIONS:
        check_written_classes(version)


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
        # Version 4 has no extrusions.
        became_brep = isinstance(old.Geometry, rhino3dm.Extrusion) and isinstance(new.Geometry, rhino3dm.Brep)
        assert type(old.Geometry) is type(new.Geometry) or version < 50 and became_brep, what
        was_valid, is_valid = old.Geometry.IsValid, new.Geometry.IsValid
        assert is_valid or not was_valid, f"{what}: {new.Geometry.IsValidWithLog[1]}"
        # Asked first: rhino3dm keeps the boxes that it computes, and encodes them.
        same += encoded(old.Geometry) == encoded(new.Geometry)
        if isinstance(old.Geometry, rhino3dm.Brep) and before.ArchiveVersion == 2:
            # It believes the boxes of faces in such archives, whatever they are.
            pass
        elif isinstance(old.Geometry, rhino3dm.Mesh):
            # Boxes of meshes come from the single-precision vertices, which may be rounded another way.
            close(vertices(new.Geometry), vertices(old.Geometry), what)
        elif not became_brep and not isinstance(old.Geometry, rhino3dm.AnnotationBase):
            # Boxes of extrusions are wider than those of their breps.
            boxes = [geometry.GetBoundingBox() for geometry in (new.Geometry, old.Geometry)]
            close(*([xyz(box.Min), xyz(box.Max)] for box in boxes), what, 1e-9)
        assert old.Attributes.Name == new.Attributes.Name, what
    return len(carried), same


def test_converted_archives_hold_the_same_objects():
    for version in VERSIONS:
        results = [check_conversion(path, version) for path in sorted(SHARED.glob("*.3dm"))]
        if results:
            objects, same = (sum(column) for column in zip(*results))
            print(f"version {version}: {objects} objects carried over and valid, {same} of them encoded alike")


def test_single_objects_have_the_bytes_of_rhino3dm():
    object_bytes.check_oracle()
    object_bytes.check_generated()


def test_generated_models_of_every_version():
    found, counts = generated.differences(sources=(2, 5, 7), targets=(50, 60, 80))
    found = [difference for difference in found if not generated.is_known(difference)]
    assert not found, "\n".join(found)
    print(f"generated: {counts['files']} files, {counts['encoded alike']} of {counts['objects']} objects and "
          f"{counts['entries alike']} of {counts['entries']} entries of tables alike after reading and writing")


if __name__ == "__main__":
    test_the_comparison_notices_small_differences()
    test_what_we_write_is_read_by_rhino3dm()
    test_encoded_objects_come_out_as_they_went_in()
    test_archives_of_version_1_are_read_as_rhino3dm_reads_them()
    test_real_archives_are_read_as_rhino3dm_reads_them()
    test_objects_of_small_classes_have_the_bytes_of_rhino3dm()
    test_converted_archives_hold_the_same_objects()
    test_single_objects_have_the_bytes_of_rhino3dm()
    test_generated_models_of_every_version()
    for extra in sys.argv[1:]:
        check_encoded(extra, strict=False)
