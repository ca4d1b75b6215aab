"""Breps."""

from .common import close, ends, xyz
from .surfaces import check_surface


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
