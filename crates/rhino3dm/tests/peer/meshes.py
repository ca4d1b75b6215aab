"""Meshes."""

import base64
import struct

from .common import close, xyz


def vertices(mesh):
    """In double precision where the mesh has it."""
    return [xyz(mesh.Vertices.Point3dAt(i)) for i in range(len(mesh.Vertices))]


def unpacked(text, kind, width):
    """Rows of numbers out of the base64 of their bytes."""
    rows = struct.iter_unpack(f"<{width}{kind}", base64.b64decode(text))
    return [list(row) for row in rows]


def same(ours, theirs, what):
    """Numbers that came from the same bytes: equal, or neither a number."""
    assert len(ours) == len(theirs), f"{what}: {len(ours)} here, {len(theirs)} there"
    for i, (a, b) in enumerate(zip(ours, theirs)):
        assert all(x == y or (x != x and y != y) for x, y in zip(a, b)), f"{what}[{i}]: {a} here, {b} there"


def check_mesh(ours, theirs, what):
    singles = unpacked(ours["vertices"], "f", 3)
    doubles = unpacked(ours["double_vertices"], "d", 3) or singles
    same(doubles, vertices(theirs), f"{what} vertices")
    same(singles, [xyz(theirs.Vertices[i]) for i in range(len(theirs.Vertices))], f"{what} single vertices")
    faces = [list(theirs.Faces[i]) for i in range(len(theirs.Faces))]
    same(unpacked(ours["faces"], "i", 4), faces, f"{what} faces")
    normals = [xyz(theirs.Normals[i]) for i in range(len(theirs.Normals))]
    same(unpacked(ours["normals"], "f", 3), normals, f"{what} normals")
    texture = [theirs.TextureCoordinates[i] for i in range(len(theirs.TextureCoordinates))]
    same(unpacked(ours["texture_coordinates"], "f", 2), [[p.X, p.Y] for p in texture], f"{what} texture coordinates")
    colours = [list(theirs.VertexColors[i]) for i in range(len(theirs.VertexColors))]
    same(unpacked(ours["colours"], "B", 4), colours, f"{what} colours")
    if ours["closed"] is not None:
        assert ours["closed"] == theirs.IsClosed, f"{what} closed"


def check_stated_mesh(stated, theirs, what):
    """A mesh against numbers that were stated apart from any archive."""
    close(stated["vertices"], vertices(theirs), f"{what} vertices")
    faces = [theirs.Faces[i] for i in range(len(theirs.Faces))]
    assert stated["faces"] == [list(f[:3] if f[2] == f[3] else f) for f in faces], f"{what} faces"
    normals = [theirs.Normals[i] for i in range(len(theirs.Normals))]
    close(stated["normals"], [xyz(n) for n in normals], f"{what} normals", 1e-7)
    colours = [theirs.VertexColors[i] for i in range(len(theirs.VertexColors))]
    assert [c[:3] for c in stated["colours"]] == [list(c[:3]) for c in colours], f"{what} colours"
