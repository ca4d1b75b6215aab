"""Point clouds."""

from .common import close, xyz


def check_cloud(ours, theirs, what):
    close(ours["points"], [xyz(p) for p in (theirs.GetPoints() if theirs.Count else ())], f"{what} points", 0)
    normals = theirs.GetNormals() if theirs.ContainsNormals else []
    close(ours["normals"], [xyz(n) for n in normals], f"{what} normals", 0)
    colours = theirs.GetColors() if theirs.ContainsColors else []
    assert ours["colours"] == [list(c) for c in colours], f"{what} colours"
    close(ours["values"], list(theirs.GetValues()) if theirs.ContainsValues else [], f"{what} values", 0)
