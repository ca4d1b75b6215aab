"""Surfaces without trims."""

import rhino3dm

from .common import close, ends, xyz


def check_surface(ours, theirs, what):
    domains = [ends(theirs.Domain(0)), ends(theirs.Domain(1))]
    close(ours["domains"], domains, f"{what} domains")
    wanted = {"plane": "PlaneSurface", "sum": "Surface", "revolution": "RevSurface", "nurbs": "NurbsSurface"}
    # rhino3dm has no class of its own for sum surfaces.
    assert type(theirs).__name__ in (wanted[ours["kind"]], "Surface", "BrepFace"), f"{what}: {type(theirs).__name__}"
    (a, b), (c, d) = domains
    at = (0, 0.3, 0.5, 1)
    samples = [xyz(theirs.PointAt((1 - x) * a + x * b, (1 - y) * c + y * d)) for x in at for y in at]
    close(ours["samples"], samples, f"{what} samples", 1e-9)
    if ours["kind"] == "nurbs" and isinstance(theirs, rhino3dm.NurbsSurface):
        assert ours["degrees"] == [theirs.Degree(0), theirs.Degree(1)], what
        for mine, knots in zip(ours["knots"], (theirs.KnotsU, theirs.KnotsV)):
            close(mine, [knots[i] for i in range(len(knots))], f"{what} knots")
