"""Tables of real archives: read, and written in other versions, as rhino3dm has them."""

import base64
import collections
import json
import pathlib
import re
import tempfile

import rhino3dm

from .common import SHARED, close, dumped, example, xyz

# rhino3dm frees what its objects still point into; so files are held until the end.
HELD = []


def read(path):
    file = rhino3dm.File3dm.Read(str(path))
    assert file is not None, path
    HELD.append(file)
    return file


def same_colour(ours, theirs, what):
    assert tuple(ours) == (*theirs[:3], theirs[3]), f"{what}: {ours}, {theirs}"


def check_layers(ours, file, what):
    assert len(ours) == len(file.Layers), f"{what}: {len(ours)} layers here, {len(file.Layers)} there"
    for a, b in zip(ours, file.Layers):
        label = f"{what}, layer {b.FullPath}"
        assert (a["name"], a["path"]) == (b.Name, b.FullPath), label
        assert a["colour"][:3] == list(b.Color[:3]), label
        assert (a["visible"], a["locked"], a["expanded"]) == (b.Visible, b.Locked, b.Expanded), label
        assert (a["iges"], a["material"], a["linetype"]) == (b.IgesLevel, b.RenderMaterialIndex, b.LinetypeIndex), label
        assert (a["plot_colour"] or a["colour"])[:3] == list(b.PlotColor[:3]), label
        assert a["plot_weight"] == b.PlotWeight, label
        assert a["parent"] == str(b.ParentLayerId), label


def check_materials(ours, file, what):
    assert len(ours) == len(file.Materials), what
    for a, b in zip(ours, file.Materials):
        label = f"{what}, material {b.Name}"
        assert a["name"] == b.Name and a["diffuse"][:3] == list(b.DiffuseColor[:3]), label
        theirs = [b.Shine, b.Transparency, b.Reflectivity, b.IndexOfRefraction]
        close([a["shine"], a["transparency"], a["reflectivity"], a["refraction"]], theirs, label)


def check_linetypes(ours, file, what):
    assert len(ours) == len(file.Linetypes), what
    for a, b in zip(ours, file.Linetypes):
        segments = [list(b.GetSegment(i)) for i in range(b.SegmentCount)]
        assert a["name"] == b.Name, what
        close([length for length, _ in a["segments"]], [s[0] for s in segments], f"{what}, linetype {b.Name}")


def check_blocks(ours, file, what):
    assert len(ours) == len(file.InstanceDefinitions), what
    for a, b in zip(ours, file.InstanceDefinitions):
        assert (a["name"], a["id"], a["description"]) == (b.Name, str(b.Id), b.Description), what
        assert a["members"] == [str(i) for i in b.GetObjectIds()], what


def check_attributes(ours, theirs, what):
    a, b = ours, theirs
    assert a["url"] == b.Url and a["layer"] == b.LayerIndex and a["visible"] == b.Visible, what
    assert (a["material"], a["linetype"]) == (b.MaterialIndex, b.LinetypeIndex), what
    assert a["stored_colour"] == list(b.ObjectColor), f"{what}: {a['stored_colour']} {b.ObjectColor}"
    assert a["plot_colour"] == list(b.PlotColor), what
    sources = [b.ColorSource, b.MaterialSource, b.LinetypeSource, b.PlotColorSource, b.PlotWeightSource]
    keys = ["colour", "material", "linetype", "plot_colour", "plot_weight"]
    assert [a[f"{key}_source"] for key in keys] == [int(source) for source in sources], what
    assert (a["plot_weight"], a["wire_density"]) == (b.PlotWeight, b.WireDensity), what
    assert (a["display_order"], a["viewport"]) == (b.DisplayOrder, str(b.ViewportId)), what
    assert (a["casts"], a["receives"]) == (b.CastsShadows, b.ReceivesShadows), what
    assert sorted(a["groups"]) == sorted(b.GetGroupList()), what


def check_views(ours, theirs, what):
    assert len(ours) == len(theirs), what
    for a, b in zip(ours, theirs):
        port = b.Viewport
        assert a["name"] == b.Name and a["perspective"] == port.IsPerspectiveProjection, f"{what}, view {b.Name}"
        close(a["camera"], xyz(port.CameraLocation), what)
        close(a["direction"], xyz(port.CameraDirection), what)
        close(a["up"], xyz(port.CameraUp), what)
        frustum = port.GetFrustum()
        close(a["frustum"], [frustum[k] for k in ("left", "right", "bottom", "top", "near", "far")], what)


def check_styles(ours, file, what):
    # Of archives without any, rhino3dm makes one.
    for a, b in zip(ours, file.DimStyles):
        assert a["name"] == b.Name, f"{what}: {a['name']} {b.Name}"
        sizes = [b.ArrowLength, b.TextHeight, b.ExtensionLineExtension, b.ExtensionLineOffset, b.CentermarkSize, b.TextGap]
        close([a[k] for k in ("arrow", "text", "extension", "offset", "centermark", "gap")], sizes, f"{what}, {b.Name}")


def check_page(ours, file, what):
    if ours is None:
        return
    settings, anchor = file.Settings, file.Settings.EarthAnchorPoint
    close([ours["absolute"], ours["angle"]], [settings.PageAbsoluteTolerance, settings.PageAngleToleranceRadians], what)
    close(ours["base"], xyz(settings.ModelBasePoint), what)
    position = [anchor.EarthBasepointLatitude, anchor.EarthBasepointLongitude]
    if ours["position"] is None:
        assert abs(position[0]) > 1e300, f"{what}: {position}"
    else:
        close(ours["position"], position, what)


def check_reading(path):
    head, *objects = dumped(path)
    if "error" in head:
        return None
    file, tables, what = read(path), head["tables"], path.name
    check_layers(tables["layers"], file, what)
    check_materials(tables["materials"], file, what)
    check_linetypes(tables["linetypes"], file, what)
    assert [group["name"] for group in tables["groups"]] == [group.Name for group in file.Groups], what
    check_blocks(tables["blocks"], file, what)
    check_views(tables["views"], file.Views, what)
    check_views(tables["named_views"], file.NamedViews, what)
    check_styles(tables["dimension_styles"], file, what)
    check_page(tables.pop("page"), file, what)
    for i, (ours, theirs) in enumerate(zip(objects, file.Objects)):
        # Lights have a colour, a name and the like of their own there.
        if not isinstance(theirs.Geometry, rhino3dm.Light):
            check_attributes(ours, theirs.Attributes, f"{what}, object {i}")
    return {table: len(entries) for table, entries in tables.items()} | {"objects": len(objects)}


def encoded(thing):
    try:
        return base64.b64decode(thing.Encode()["data"])
    except Exception:  # rhino3dm does not encode every class
        return None


def view(view):
    return view.Name, encoded(view.Viewport), view.WallpaperName


def contents(file):
    """Every table of a file as comparable values, one list a table."""
    settings, anchor = file.Settings, file.Settings.EarthAnchorPoint
    return {
        "layers": [encoded(layer) for layer in file.Layers],
        "materials": [encoded(material) for material in file.Materials],
        "linetypes": [encoded(linetype) for linetype in file.Linetypes],
        "groups": [encoded(group) for group in file.Groups],
        "dimension styles": [encoded(style) for style in file.DimStyles],
        "blocks": [encoded(block) for block in file.InstanceDefinitions],
        "bitmaps": [encoded(bitmap) for bitmap in file.Bitmaps],
        "views": [view(v) for v in file.Views],
        "named views": [view(v) for v in file.NamedViews],
        "attributes": [encoded(o.Attributes) for o in file.Objects],
        "tolerances": [(settings.ModelAbsoluteTolerance, settings.ModelAngleToleranceRadians,
                        settings.ModelRelativeTolerance, settings.ModelUnitSystem)],
        "page": [(settings.PageAbsoluteTolerance, settings.PageAngleToleranceRadians, settings.PageRelativeTolerance,
                  settings.PageUnitSystem, str(settings.ModelBasePoint))],
        "earth anchor": [(anchor.Name, anchor.Description, anchor.EarthBasepointLatitude,
                          anchor.EarthBasepointLongitude, anchor.EarthBasepointElevation)],
        "render settings": [encoded(settings.RenderSettings)],
        "properties": [(file.ApplicationName, file.ApplicationUrl, file.ApplicationDetails, file.CreatedBy,
                        file.LastEditedBy, file.Revision)],
        "strings": [len(file.Strings)],
        "render content": [len(file.RenderContent)],
    }


def blur(value, again):
    """What two readings of the same file do not agree about: rhino3dm makes up identifiers that old files lack."""
    if isinstance(value, bytes) and isinstance(again, bytes) and len(value) == len(again):
        return [i for i in range(len(value)) if value[i] != again[i]]
    return []


# User data of strangers: rhino3dm states the version of the file it came from.
STRANGE = re.compile(rb"\x01(?:[\x02-\x05]|\x32|\x3c|\x46|\x50)\x00\x00\x00(?=.{4}.{4}\x00\x80\x00\x40)", re.DOTALL)


def alike(before, again, after):
    if before == after:
        return True
    if not isinstance(before, bytes) or not isinstance(after, bytes) or len(before) != len(after):
        return False
    places = blur(before, again)
    if not places:
        strange = [STRANGE.sub(b"?", value) for value in (before, after)]
        # The check sum of the chunk it stands in differs, too.
        return strange[0] != before and sum(a != b for a, b in zip(before, after)) <= 5 * len(STRANGE.findall(before))
    # Made-up identifiers are 16 bytes, the check sum behind them 4, and single bytes may agree by chance.
    spread = {j for i in places for j in range(i - 16, i + 17)}
    return all(a == b or i in spread for i, (a, b) in enumerate(zip(before, after)))


def check_conversion(path, version, counts, differences):
    """What differs before and after; what rhino3dm itself makes of the file in that version is right as well."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "out.3dm"
        rewritten = pathlib.Path(folder) / "rewritten.3dm"
        assert read(path).Write(str(rewritten), version // 10), path.name
        carried = json.loads(example("convert", path, out, version))
        if carried is None:
            return
        before, again, after, theirs = (contents(read(p)) for p in (path, path, out, rewritten))
    for tables in (before, again, theirs):
        tables["attributes"] = [tables["attributes"][i] for i in carried]
    for table, entries in before.items():
        others = after[table]
        counts[table, "of"] += len(entries)
        if len(entries) != len(others):
            differences.append(f"{path.name} as {version}: {len(entries)} {table} before, {len(others)} after")
        for i, (a, b, c) in enumerate(zip(entries, again[table], others)):
            if alike(a, b, c) or c in theirs[table]:
                counts[table, "alike"] += 1
            else:
                differences.append(f"{path.name} as {version}: {table} {i}")


def check_tables(versions=(60, 70, 80)):
    paths = sorted(SHARED.glob("*.3dm"))
    read_tables = collections.Counter()
    for path in paths:
        read_tables.update(check_reading(path) or {})
    print("tables read as rhino3dm reads them:", dict(read_tables))
    differences = []
    for version in versions:
        counts = collections.Counter()
        for path in paths:
            check_conversion(path, version, counts, differences)
        tables = [table for table, kind in counts if kind == "of"]
        line = ", ".join(f"{table} {counts[table, 'alike']} of {counts[table, 'of']}" for table in tables)
        print(f"version {version}, alike after reading and writing: {line}")
    return differences
