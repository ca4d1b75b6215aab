"""Breps and extrusions."""

from .bytes import encoded_brep
from .common import close, ends, xyz
from .surfaces import check_surface


def same(ours, theirs, what):
    """Equal structures, their numbers nearly so; what only one side knows is passed over."""
    if isinstance(theirs, dict):
        for key, value in theirs.items():
            same(ours[key], value, f"{what} {key}")
    elif isinstance(theirs, list):
        assert len(ours) == len(theirs), f"{what}: {len(ours)} here, {len(theirs)} there"
        for i, (a, b) in enumerate(zip(ours, theirs)):
            same(a, b, f"{what}[{i}]")
    elif isinstance(theirs, float) and ours is not None:
        close(ours, theirs, what)
    else:
        assert ours == theirs, f"{what}: {ours} here, {theirs} there"


def check_brep(ours, theirs, what):
    """Every vertex, edge, trim, loop, face, curve and surface, and which faces have meshes."""
    encoded = encoded_brep(theirs)
    for meshes in ("render_meshes", "analysis_meshes"):
        present = encoded.pop(meshes)
        assert ours[meshes] == (present if any(present) else []), f"{what} {meshes}"
    # A curve that the kernel refuses is none here; what it refused comes back in the conversions.
    for curves in ("curves_2d", "curves_3d"):
        encoded[curves] = [theirs_ if ours_ else None for ours_, theirs_ in zip(ours[curves], encoded[curves], strict=True)]
    same(ours, encoded, what)
    assert len(ours["surfaces"]) == len(theirs.Surfaces), what
    for i, surface in enumerate(ours["surfaces"]):
        if surface:
            check_surface(surface, theirs.Surfaces[i], f"{what} surface {i}")
    for i, edge in enumerate(ours["edges"]):
        other = theirs.Edges[i]
        close(edge["part"]["domain"], ends(other.Domain), f"{what} edge {i} domain")
        if None not in edge["points"]:
            a, b = ends(other.Domain)
            points = [xyz(other.PointAt((1 - x) * a + x * b)) for x in (0, 0.3, 1)]
            close(edge["points"], points, f"{what} edge {i}", 1e-9)
    if ours["bare"]:
        assert len(theirs.Faces) == 1 and theirs.IsSurface, f"{what}: a bare surface here"
        check_surface(ours["bare"], theirs.Faces[0].UnderlyingSurface(), f"{what} surface")
    solid = ours["solidity"] != "Unknown" or ours["solid"]
    assert solid == theirs.IsSolid, f"{what}: solid {solid} here, {theirs.IsSolid} there"
    if theirs.IsValid:
        assert not ours["faults"], f"{what}: {ours['faults']}"


def check_extrusion(ours, theirs, what):
    close([ours["start"], ours["end"]], [xyz(theirs.PathStart), xyz(theirs.PathEnd)], f"{what} path")
    assert ours["profiles"] == theirs.ProfileCount, what
    assert ours["caps"] == [theirs.IsCappedAtBottom, theirs.IsCappedAtTop], f"{what} caps"
    assert ours["mitred"] == [theirs.IsMiteredAtStart, theirs.IsMiteredAtEnd], f"{what} mitres"
