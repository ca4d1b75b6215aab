"""Brep.Split with Breps or planes as cutters: along the curves in which they meet."""

from ..values import Plane
from .call import invoke, static_call
from .classes import CLASSES


def split(brep, cutter, *rest):
    """The pieces of a Brep. Curves go to the host as they are."""
    cutters = list(cutter) if isinstance(cutter, (list, tuple)) else [cutter]
    if not any(isinstance(one, (CLASSES["Brep"], Plane)) for one in cutters):
        return invoke("Brep", "Split", ["Brep"], (brep, cutters) + rest)
    tolerance = next((value for value in rest if isinstance(value, float)), 0.001)
    curves = []
    for one in cutters:
        if isinstance(one, Plane):
            curves += static_call("Brep", "CreateContourCurves", brep, one) or []
            continue
        found = static_call("Intersection", "BrepBrep", brep, one, tolerance)
        if found[0]:
            curves += found[1]
    if not curves:
        return []
    joined = static_call("Curve", "JoinCurves", curves, 2.1 * tolerance)
    return invoke("Brep", "Split", ["Brep"], (brep, list(joined or curves), tolerance))


CLASSES["Brep"].Split = split
