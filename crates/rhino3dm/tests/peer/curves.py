"""Curves."""

from .common import close, ends, xyz


def homogeneous(curve):
    """Control points as (wx, wy, wz, w)."""
    return [[p.X, p.Y, p.Z, p.W] for p in (curve.Points[i] for i in range(len(curve.Points)))]


def check_curve(ours, theirs, what):
    close(ours["domain"], ends(theirs.Domain), f"{what} domain")
    kind = ours["kind"]
    wanted = {"line": "LineCurve", "arc": "ArcCurve", "polyline": "PolylineCurve", "nurbs": "NurbsCurve", "poly": "PolyCurve"}
    assert type(theirs).__name__ == wanted[kind], f"{what}: {kind} here, {type(theirs).__name__} there"
    if kind == "line":
        close(ours["from"], xyz(theirs.PointAtStart), f"{what} start")
        close(ours["to"], xyz(theirs.PointAtEnd), f"{what} end")
    elif kind == "arc":
        arc = theirs.Arc
        plane = arc.Plane
        close(ours["plane"], [xyz(plane.Origin), xyz(plane.XAxis), xyz(plane.YAxis), xyz(plane.ZAxis)], f"{what} plane")
        close(ours["radius"], arc.Radius, f"{what} radius")
        close(ours["angle"], [arc.StartAngle, arc.EndAngle], f"{what} angle")
    elif kind == "polyline":
        close(ours["points"], [xyz(theirs.Point(i)) for i in range(theirs.PointCount)], f"{what} points")
        for t, p in zip(ours["parameters"], ours["points"]):
            close(p, xyz(theirs.PointAt(t)), f"{what} at {t}", 1e-9)
    elif kind == "nurbs":
        assert ours["degree"] == theirs.Degree and ours["rational"] == theirs.IsRational, what
        close(ours["knots"], [theirs.Knots[i] for i in range(len(theirs.Knots))], f"{what} knots")
        close(ours["points"], homogeneous(theirs), f"{what} control points")
    else:
        assert len(ours["segments"]) == theirs.SegmentCount, what
        joints = [theirs.SegmentDomain(i).T0 for i in range(theirs.SegmentCount)] + [theirs.Domain.T1]
        close(ours["parameters"], joints, f"{what} joints")
        for i, segment in enumerate(ours["segments"]):
            check_curve(segment, theirs.SegmentCurve(i), f"{what} segment {i}")
