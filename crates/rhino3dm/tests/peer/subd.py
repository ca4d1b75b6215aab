"""SubDs."""

from .common import close, xyz

# What archives number the tags as.
VERTEX_TAGS = {"Unset": 0, "Smooth": 1, "Crease": 2, "Corner": 3, "Dart": 4}
EDGE_TAGS = {"Unset": 0, "Smooth": 1, "Crease": 2, "SmoothX": 4}
NOTHING = {"counts": [0, 0, 0], "points": [], "vertex_ids": [], "edge_ids": [], "vertex_tags": [], "edge_tags": [],
           "sharpness": []}


def check_subd(ours, theirs, what):
    level = ours["levels"][-1] if ours["levels"] else NOTHING
    assert level["counts"] == [theirs.VertexCount, theirs.EdgeCount, theirs.FaceCount], f"{what} counts"
    # rhino3dm finds parts by their identifiers.
    vertices = [theirs.Vertices[i] for i in level["vertex_ids"]]
    assert [v.Id for v in vertices] == level["vertex_ids"], f"{what} vertices"
    close(level["points"], [xyz(v.ControlNetPoint) for v in vertices], f"{what} points", 0)
    assert level["vertex_tags"] == [VERTEX_TAGS[v.Tag.name] for v in vertices], f"{what} vertex tags"
    edges = [theirs.Edges[i] for i in level["edge_ids"]]
    assert level["edge_tags"] == [EDGE_TAGS[e.Tag.name] for e in edges], f"{what} edge tags"
    assert [s[0] for s in level["sharpness"]] == [e.EndSharpness(False) for e in edges], f"{what} sharpness"
    assert not ours["kernel"] or not theirs.IsValid, f"{what}: {ours['kernel']}"
    if ours["limit"]:
        # Not what the file remembers of it; a copy, so that the object stays as it is.
        fresh = theirs.Duplicate()
        fresh.ClearEvaluationCache()
        # The surface at the control points, where darts are only near it.
        smooth = [i for i, v in enumerate(vertices) if not v.IsDart]
        size = max(abs(x) for p in level["points"] for x in p)
        found = [ours["limit"][i] for i in smooth]
        close(found, [xyz(fresh.Vertices[level["vertex_ids"][i]].SurfacePoint) for i in smooth], f"{what} limit", 1e-9 * size)
