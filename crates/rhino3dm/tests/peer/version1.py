"""Archives of version 1: everything rhino3dm reads of them."""

import json
import pathlib
import tempfile

import rhino3dm

from .common import VERSIONS, close, dumped, encoded, example, xyz
from .geometry import check_geometry
from .version1_sample import archive, wrapped_version_2

CLASSES = {
    rhino3dm.LineCurve: "LineCurve",
    rhino3dm.NurbsCurve: "NurbsCurve",
    rhino3dm.PolyCurve: "PolyCurve",
    rhino3dm.Brep: "Brep",
    rhino3dm.Mesh: "Mesh",
    rhino3dm.Point: "Point",
    rhino3dm.TextDot: "TextDot",
    rhino3dm.Light: "Light",
    rhino3dm.NurbsSurface: "NurbsSurface",
    rhino3dm.Text: "Text",
    rhino3dm.Leader: "Leader",
    rhino3dm.DimLinear: "LinearDimension",
}


def check_head(head, file, path):
    assert head["version"] == 1
    assert head["units"] == file.Settings.ModelUnitSystem.name, head["units"]
    close(head["absolute"], file.Settings.ModelAbsoluteTolerance, "absolute tolerance")
    close(head["angle"], file.Settings.ModelAngleToleranceRadians, "angle tolerance")
    assert head["application"] == file.ApplicationName, head["application"]
    assert head["notes"] == (rhino3dm.File3dm.ReadNotes(str(path)) or ""), head["notes"]
    layers = [(l.Name, list(l.Color[:3]), l.Visible, l.Locked) for l in file.Layers]
    ours = [(l["name"], l["colour"][:3], l["visible"], l["locked"]) for l in head["tables"]["layers"]]
    assert ours == layers, ours
    materials = head["tables"]["materials"]
    assert len(materials) == len(file.Materials)
    for ours, theirs in zip(materials, file.Materials):
        assert ours["name"] == theirs.Name and ours["diffuse"][:3] == list(theirs.DiffuseColor[:3]), ours
        close([ours["shine"], ours["transparency"]], [theirs.Shine, theirs.Transparency], "material", 1e-7)
        theirs = [texture.FileName for texture in (theirs.GetBitmapTexture(), theirs.GetBumpTexture()) if texture]
        # rhino3dm turns paths of Windows into such of the system it runs on.
        assert [path.removeprefix("D:").replace("\\", "/") for path in ours["textures"]] == theirs, ours


def check_version_1(path):
    """Every object of one archive; gives their number by class."""
    head, *objects = dumped(path)
    file = rhino3dm.File3dm.Read(str(path))
    assert "error" not in head, head
    check_head(head, file, path)
    assert not any("CRC" in warning for warning in head["warnings"]), head["warnings"]
    counts = {}
    assert len(objects) == len(file.Objects), f"{path.name}: {len(file.Objects)} there, {len(objects)} here"
    for i, (ours, theirs) in enumerate(zip(objects, file.Objects)):
        what = f"{path.name} object {i}"
        attributes, geometry = theirs.Attributes, theirs.Geometry
        name = CLASSES[type(geometry)]
        assert ours["geometry"]["class"] == name, f"{what}: {ours['geometry']['class']} here, {name} there"
        # rhino3dm puts a light's own name, of which version 1 has none, in place of the object's.
        assert name == "Light" or ours["name"] == attributes.Name, what
        assert ours["layer"] == attributes.LayerIndex, what
        assert ours["visible"] == attributes.Visible, what
        assert ours["material"] == attributes.MaterialIndex, what
        assert ours["wire_density"] == attributes.WireDensity, what
        assert ours["colour"] is None and attributes.ColorSource == rhino3dm.ObjectColorSource.ColorFromLayer, what
        # Breps are compared as they are encoded, below; annotations become others when rhino3dm reads them.
        if name not in ("Brep", "Text", "Leader", "LinearDimension"):
            check_geometry(ours["geometry"], geometry, what)
        counts[name] = counts.get(name, 0) + 1
    return counts


def light(geometry):
    """All of a light but its identifier, which is made up anew by every reader."""
    colours = [geometry.Ambient, geometry.Diffuse, geometry.Specular]
    return [xyz(geometry.Location), xyz(geometry.Direction), geometry.SpotAngleRadians, geometry.HotSpot,
            geometry.SpotExponent, geometry.Intensity, geometry.ShadowIntensity, xyz(geometry.AttenuationVector),
            *map(list, colours)]


def check_converted_1(path, version):
    """The archive read here and written as a later version, against what rhino3dm reads of the original."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.3dm"
        carried = json.loads(example("convert", path, out, version))
        before, after = rhino3dm.File3dm.Read(str(path)), rhino3dm.File3dm.Read(str(out))
    same = 0
    for place, i in enumerate(carried):
        old, new = before.Objects[i].Geometry, after.Objects[place].Geometry
        what = f"{path.name} as {version}, object {i}"
        assert type(old) is type(new), what
        assert new.IsValid or not old.IsValid, f"{what}: {new.IsValidWithLog[1]}"
        if isinstance(old, rhino3dm.Light):
            close(light(new), light(old), what)
            same += 1
        else:
            same += encoded(old) == encoded(new)
    return len(before.Objects), len(carried), same


def check_samples(version_2):
    """What no shared archive holds: an archive made here, and a version 2 archive that says it is of version 1."""
    with tempfile.TemporaryDirectory() as folder:
        sample = pathlib.Path(folder) / "sample.3dm"
        sample.write_bytes(archive())
        counts = check_version_1(sample)
        results = [check_converted_1(sample, version) for version in VERSIONS]
        print(f"an archive made here: {counts} equal, {results} carried over and encoded alike")
        if version_2:
            sample.write_bytes(wrapped_version_2(version_2.read_bytes()))
            head, *objects = dumped(sample)
            file = rhino3dm.File3dm.Read(str(sample))
            assert head["version"] == 2 and len(objects) == len(file.Objects) > 0, head
            assert len(head["tables"]["layers"]) == len(file.Layers)
            print(f"an archive of version 2 that says it is of version 1: {len(objects)} objects")


def check_all(paths):
    total = {}
    for path in paths:
        for name, count in check_version_1(path).items():
            total[name] = total.get(name, 0) + count
    print(f"{len(paths)} archives of version 1: {sum(total.values())} objects equal, {total}")
    for version in VERSIONS:
        results = [check_converted_1(path, version) for path in paths]
        objects, carried, same = (sum(column) for column in zip(*results)) if results else (0, 0, 0)
        assert carried == objects, f"{objects - carried} objects of version 1 are not written as {version}"
        print(f"version 1 as {version}: {carried} of {objects} objects carried over, {same} of them encoded alike")
