"""BrepFace.CreateExtrusion for straight paths, of what the host has: the face, its copy, and walls between them."""

from ..values.transform import Transform
from .call import invoke, static_call


def extruded_face(face, path, cap):
    """The Brep that a face sweeps along a curve. Paths that bend are the host's own matter."""
    from ..backend import current
    if any("pathCurve" in s for s in current().table.signatures("BrepFace", "CreateExtrusion")) or not path.IsLinear():
        return invoke("BrepFace", "CreateExtrusion", ["BrepFace"], (face, path, cap))
    along = path.PointAtEnd - path.PointAtStart
    base = face.DuplicateFace(False)
    walls = [static_call("Surface", "CreateExtrusion", edge, along).ToBrep() for edge in base.DuplicateEdgeCurves()]
    if cap:
        far = base.Duplicate()
        far.Transform(Transform.Translation(along))
        walls += [base, far]
    joined = static_call("Brep", "JoinBreps", walls, 1e-3)
    made = joined[0] if joined else None
    if made is not None and made.IsSolid and str(made.SolidOrientation) == "Inward":
        made.Flip()
    return made
