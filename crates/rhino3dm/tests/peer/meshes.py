"""Meshes."""

from .common import close, xyz


def vertices(mesh):
    """In double precision where the mesh has it."""
    return [xyz(mesh.Vertices.Point3dAt(i)) for i in range(len(mesh.Vertices))]


def check_mesh(ours, theirs, what):
    close(ours["vertices"], vertices(theirs), f"{what} vertices")
    faces = [theirs.Faces[i] for i in range(len(theirs.Faces))]
    assert ours["faces"] == [list(f[:3] if f[2] == f[3] else f) for f in faces], f"{what} faces"
    normals = [theirs.Normals[i] for i in range(len(theirs.Normals))]
    close(ours["normals"], [xyz(n) for n in normals], f"{what} normals", 1e-7)
    colours = [theirs.VertexColors[i] for i in range(len(theirs.VertexColors))]
    assert [c[:3] for c in ours["colours"]] == [list(c[:3]) for c in colours], f"{what} colours"
