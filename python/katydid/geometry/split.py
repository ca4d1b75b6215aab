"""Brep.Split and Brep.Trim with planes, and with Breps of one planar face, as cutters.

The host cuts Breps along curves and by planes. A planar cutter does the same as its plane where it covers the whole
section; where it does not, and for cutters that bend, there is an error that says so.
"""

from ..values import Plane
from ..values.base import not_supported
from .call import invoke, static_call
from .classes import CLASSES


def planar(cutter):
    """The plane of a Brep with one planar face, its normal the face's; None for any other."""
    faces = cutter.Faces
    if len(faces) != 1:
        return None
    found = faces[0].TryGetPlane()
    if not found[0]:
        return None
    face, plane = faces[0], found[1]
    u, v = face.Domain(0), face.Domain(1)
    if face.NormalAt(u.Mid, v.Mid) * plane.ZAxis < 0.0:
        plane.Flip()
    return plane


def section(brep, cutter, tolerance, member):
    """The curves in which a plane, or a planar Brep that covers them, meets a Brep."""
    plane = cutter if isinstance(cutter, Plane) else planar(cutter)
    if plane is None:
        raise not_supported("Rhino.Geometry.Brep.%s with a cutter that is not planar" % member)
    curves = list(static_call("Brep", "CreateContourCurves", brep, plane) or ())
    if cutter is not plane:
        for curve in curves:
            points = [curve.PointAtNormalizedLength(i / 8.0) for i in range(9)]
            if any(cutter.ClosestPoint(point).DistanceTo(point) > tolerance for point in points):
                raise not_supported("Rhino.Geometry.Brep.%s with a cutter that ends within the section" % member)
    return curves


def _tolerance(rest):
    return next((value for value in rest if isinstance(value, float)), 0.001)


def split(brep, cutter, *rest):
    """The pieces of a Brep; none where nothing is cut. Curves go to the host as they are."""
    cutters = list(cutter) if isinstance(cutter, (list, tuple)) else [cutter]
    if not any(isinstance(one, (CLASSES["Brep"], Plane)) for one in cutters):
        return invoke("Brep", "Split", ["Brep"], (brep, cutters) + rest)
    tolerance = _tolerance(rest)
    curves = [curve for one in cutters for curve in section(brep, one, tolerance, "Split")]
    if not curves:
        return []
    joined = static_call("Curve", "JoinCurves", curves, 2.1 * tolerance)
    return invoke("Brep", "Split", ["Brep"], (brep, list(joined or curves), tolerance))


def trim(brep, cutter, *rest):
    """What is left behind a cutter: the parts on the side of its normal are taken away."""
    if isinstance(cutter, CLASSES["Brep"]):
        section(brep, cutter, _tolerance(rest), "Trim")
        cutter = planar(cutter)
    return invoke("Brep", "Trim", ["Brep"], (brep, cutter) + rest)


CLASSES["Brep"].Split = split
CLASSES["Brep"].Trim = trim
