"""Text dots, lights, blocks, hatches and annotations."""

import base64
import json
import pathlib
import tempfile
import uuid

import rhino3dm

from .common import SHARED, close, dumped, example, xyz

CLASSES = (rhino3dm.TextDot, rhino3dm.Light, rhino3dm.InstanceReference, rhino3dm.Hatch, rhino3dm.AnnotationBase)
LIGHTS = {"CameraDirectional": "CameraDirectional", "CameraPoint": "CameraPoint", "CameraSpot": "CameraSpot",
          "Directional": "WorldDirectional", "Point": "WorldPoint", "Spot": "WorldSpot", "Ambient": "Ambient",
          "Linear": "WorldLinear", "Rectangular": "WorldRectangular", "Unknown(0)": "Unknown"}


def axes(plane):
    return [xyz(plane.Origin), xyz(plane.XAxis), xyz(plane.YAxis), xyz(plane.ZAxis)]


def check_text_dot(ours, theirs, what):
    close(ours["point"], xyz(theirs.Point), what)
    assert (ours["text"], ours["secondary"]) == (theirs.Text, theirs.SecondaryText), what
    assert (ours["font"], ours["height"]) == (theirs.FontFace, theirs.FontHeight), what


def check_light(ours, theirs, what):
    assert LIGHTS[ours["style"]] == theirs.LightStyle.name, f"{what}: {ours['style']}, {theirs.LightStyle}"
    assert (ours["on"], ours["name"]) == (theirs.IsEnabled, theirs.Name), what
    # Exponent and hot spot are computed from each other there; the comparison of bytes is for them.
    close([ours[n] for n in ("intensity", "watts", "spot_angle", "shadow")],
          [theirs.Intensity, theirs.PowerWatts, theirs.SpotAngleRadians, theirs.ShadowIntensity], what)
    vectors = ("location", "direction", "length", "width", "attenuation")
    close([ours[n] for n in vectors],
          [xyz(v) for v in (theirs.Location, theirs.Direction, theirs.Length, theirs.Width, theirs.AttenuationVector)],
          what)
    for ours, theirs in zip((ours["ambient"], ours["diffuse"], ours["specular"]),
                            (theirs.Ambient, theirs.Diffuse, theirs.Specular)):
        assert ours[:3] == list(theirs[:3]), what


def check_block_reference(ours, theirs, what):
    assert ours["definition"] == str(theirs.ParentIdefId), what
    close([x for row in ours["transform"] for x in row], list(theirs.Xform.ToFloatArray(True)), what, 1e-6)


def check_hatch(ours, theirs, what):
    close(ours["plane"], axes(theirs.Plane), f"{what} plane")
    close([ours["scale"], ours["rotation"]], [theirs.PatternScale, theirs.PatternRotation], what)
    assert ours["pattern"] == theirs.PatternIndex, f"{what}: pattern {ours['pattern']}, {theirs.PatternIndex}"
    close(ours["base_point"], xyz(theirs.BasePoint), f"{what} base point", 1e-9)


def check_annotation(ours, theirs, what):
    # rhino3dm moves the text of version 2 by heights that the file's settings tell.
    if "plane" in ours:
        close(ours["plane"], axes(theirs.Plane), f"{what} plane")
    if "rich_text" not in ours:
        # rhino3dm makes its points and text of older classes through a dimension style and fonts.
        return
    assert ours["plain_text"] == theirs.PlainText, f"{what}: {ours['plain_text']!r} here, {theirs.PlainText!r} there"
    # A style that is not in the file is another there.
    if uuid.UUID(ours["style"]).int:
        assert ours["style"] == str(theirs.DimensionStyleId), what
    assert ours["wrapped"] == theirs.TextIsWrapped, what
    close(ours["rotation"], theirs.TextRotationRadians, what)
    points = ours["points"]
    if isinstance(theirs, rhino3dm.Leader):
        close(points["points"], [xyz(p) for p in theirs.Points], f"{what} points")
    elif isinstance(theirs, rhino3dm.Dimension) and hasattr(theirs, "Points"):
        for name, point in theirs.Points.items():
            if name in points:
                close(points[name], xyz(point), f"{what} {name}", 1e-9)


def check_class(ours, theirs, what):
    """Compares one object of these classes; says whether it is one."""
    detail = ours["detail"]
    if ours["kept"] or not isinstance(theirs, CLASSES):
        return False
    if isinstance(theirs, rhino3dm.TextDot):
        check_text_dot(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.Light):
        check_light(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.InstanceReference):
        check_block_reference(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.Hatch):
        check_hatch(detail, theirs, what)
    elif isinstance(theirs, rhino3dm.AnnotationBase):
        check_annotation(detail, theirs, what)
    return True


def check_bytes_of_real_objects():
    """Every object of these classes in the shared archives, as rhino3dm encodes it: read and written here."""
    forms, names = [], []
    for path in sorted(SHARED.glob("*.3dm")):
        file = rhino3dm.File3dm.Read(str(path))
        # Objects do not keep their file alive.
        for i, o in enumerate(file.Objects):
            if isinstance(o.Geometry, CLASSES):
                forms.append(o.Geometry.Encode())
                names.append(f"{path.name} object {i}, {type(o.Geometry).__name__}")
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "objects.jsonl"
        path.write_text("\n".join(map(json.dumps, forms)))
        for what, form, ours in zip(names, forms, dumped(path), strict=True):
            assert not ours["geometry"]["kept"], what
            written = ours["written"]
            assert written and written["read_back_equal"], what
            assert base64.b64decode(form["data"]) == base64.b64decode(written["data"]), f"{what}: other bytes"
    print(f"{len(forms)} text dots, lights, blocks, hatches and annotations written byte for byte as rhino3dm does")


def check_written_classes(version):
    """Objects of known numbers, written here in every generation: rhino3dm reads them, all of them valid."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "classes.3dm"
        example("write_classes", path, version)
        file = rhino3dm.File3dm.Read(str(path))
        ours = [o for o in dumped(path) if "geometry" in o]
    assert file is not None and file.ArchiveVersion == version
    theirs = list(file.Objects)
    assert [o["name"] for o in ours] == [o.Attributes.Name for o in theirs]
    for o, other in zip(ours, theirs):
        what = f"{o['name']} in version {version}"
        geometry = other.Geometry
        assert not o["geometry"]["kept"] and geometry.IsValid, f"{what}: {geometry.IsValidWithLog[1]}"
        check_class(o["geometry"], geometry, what)
    at = {o.Attributes.Name: o.Geometry for o in theirs}
    # Older annotations become those of version 6 with the same points in every version that is written.
    for name in ("linear 5", "aligned 5", "linear 2"):
        points = at[name].Points
        close(xyz(points["defpt1"]), [1, 2, 3], name)
        close(xyz(points["defpt2"]), [5, 5, 3], name)
        close(xyz(points["arrowpt2"]), [3.8, 6.6, 3], name)
    for name in ("radius 5", "diameter 5", "radius 2"):
        close(xyz(at[name].Points["radiuspt"]), [1, 7, 3], name)
    close(xyz(at["ordinate 5"].Points["leaderpt"]), [0.2, 8.9, 3], "ordinate 5")
    for name in ("leader 5", "leader 2"):
        close([xyz(p) for p in at[name].Points], [[1, 2, 3], [1.2, 3.4, 3], [2.8, 4.6, 3]], name)
    texts = {name: at[name].PlainText for name in ("text 5", "leader 5", "text 2", "leader 2")}
    assert texts == {"text 5": "Maß <>", "leader 5": "Maß <>", "text 2": "old", "leader 2": "old"}, texts
    print(f"version {version}: {len(theirs)} annotations, dots, lights, blocks and cages equal")
