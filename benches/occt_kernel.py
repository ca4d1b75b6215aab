"""Kernel operations of Open CASCADE, called through Python, on the inputs of the other kernel rows.

    python benches/occt_kernel.py ../shared/data/kernel-bench [TABLE]

With cadquery-ocp (python-tests/step/requirements.txt). TABLE is what `cargo run --release -p katydid-kernel-bench --bin
ratios` printed in the same hour: rows of both are put side by side. Only operations of microseconds and more are here, as
a call from Python costs some 0.2 µs itself: a batch where Open CASCADE has one, else one call a question, with what it
prepares made once for all questions. Every answer is held against the reference beside the inputs, which no kernel gave,
before anything is timed; a row with wrong answers says how many. The median of the rounds counts, one thread.
"""

import json
import re
import statistics
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from OCP.collections import Array1_double, Array1_gp_Pnt, Array1_gp_Pnt2d, Array1_int, Array2_double, Array2_gp_Pnt
from OCP.collections import HArray1_gp_Pnt
from OCP.Extrema import Extrema_ExtPC
from OCP.GCPnts import GCPnts_AbscissaPoint, GCPnts_UniformAbscissa
from OCP.Geom import Geom_BSplineCurve, Geom_BSplineSurface
from OCP.Geom2d import Geom2d_BSplineCurve
from OCP.Geom2dAPI import Geom2dAPI_InterCurveCurve
from OCP.GeomAdaptor import GeomAdaptor_Curve
from OCP.GeomAPI import GeomAPI_Interpolate, GeomAPI_ProjectPointOnCurve, GeomAPI_ProjectPointOnSurf
from OCP.gp import gp_Pnt, gp_Pnt2d

ROUNDS = 9
# Farther from the reference than this, in units, an answer is wrong.
NEAR = 1e-6


@dataclass
class Inputs:
    curves: dict
    surfaces: dict
    points: dict


def read(path):
    """All records of an inputs file by name."""
    words = iter(path.read_text().split())
    inputs = Inputs({}, {}, {})

    def count():
        return int(next(words))

    def numbers(many):
        return [float(next(words)) for _ in range(many)]

    def rows(many, width):
        return [numbers(width) for _ in range(many)]

    for kind in words:
        name = next(words)
        if kind == "curve":
            degree, points, rational = count(), count(), count() == 1
            inputs.curves[name] = (degree, numbers(points + degree + 1), rows(points, 4), rational)
        elif kind == "surf":
            degrees, counts, rational = [count(), count()], [count(), count()], count() == 1
            knots = [numbers(n + p + 1) for n, p in zip(counts, degrees)]
            inputs.surfaces[name] = (degrees, counts, knots, rows(counts[0] * counts[1], 4), rational)
        elif kind == "pts":
            inputs.points[name] = rows(count(), 3)
        else:
            many, width = count(), count()
            rows(many, width)
    return inputs


def array(kind, items):
    out = kind(1, len(items))
    for place, item in enumerate(items, 1):
        out.SetValue(place, item)
    return out


def stepped(knots):
    """The knots that differ, and how often each stands there."""
    values = sorted(set(knots))
    return array(Array1_double, values), array(Array1_int, [knots.count(value) for value in values])


def curve(record):
    degree, knots, points, rational = record
    poles = array(Array1_gp_Pnt, [gp_Pnt(x, y, z) for x, y, z, _ in points])
    if not rational:
        return Geom_BSplineCurve(poles, *stepped(knots), degree)
    return Geom_BSplineCurve(poles, array(Array1_double, [w for *_, w in points]), *stepped(knots), degree)


def flat(record):
    degree, knots, points, _ = record
    return Geom2d_BSplineCurve(array(Array1_gp_Pnt2d, [gp_Pnt2d(x, y) for x, y, *_ in points]), *stepped(knots), degree)


def surface(record):
    degrees, counts, knots, points, rational = record
    poles, weights = Array2_gp_Pnt(1, counts[0], 1, counts[1]), Array2_double(1, counts[0], 1, counts[1])
    for place, (x, y, z, w) in enumerate(points):
        row, column = divmod(place, counts[1])
        poles.SetValue(row + 1, column + 1, gp_Pnt(x, y, z))
        weights.SetValue(row + 1, column + 1, w)
    (u, in_u), (v, in_v) = map(stepped, knots)
    if rational:
        return Geom_BSplineSurface(poles, weights, u, v, in_u, in_v, *degrees)
    return Geom_BSplineSurface(poles, u, v, in_u, in_v, *degrees)


@dataclass
class Row:
    """`name` begins the name of the row of the table; `work` gives an answer a thing, and `items` says how many things."""

    name: str
    items: int
    work: object
    wrong: object


def missed(found, wanted):
    """How many distances are none, or larger than the reference."""
    bad = sum(1 for f, w in zip(found, wanted) if f is None or f > w + NEAR)
    return f"{bad} of {len(wanted)} wrong" if bad else None


def lengths(inputs, reference):
    for name, kind in (("c_nr", "plain"), ("c_r", "rational")):
        adaptor = GeomAdaptor_Curve(curve(inputs.curves[name]))
        total = reference[f"{name}_len"]
        yield Row(
            f"length, {kind}",
            1,
            lambda adaptor=adaptor: GCPnts_AbscissaPoint.Length_s(adaptor, 1e-9),
            lambda found, total=total: None if abs(found - total) < NEAR else f"{found} for {total}",
        )

        def divided(adaptor=adaptor):
            found = GCPnts_UniformAbscissa(adaptor, 1001, 1e-9)
            return [found.Parameter(k) for k in range(1, found.NbPoints() + 1)]

        def uneven(found, adaptor=adaptor, total=total):
            parts = [GCPnts_AbscissaPoint.Length_s(adaptor, a, b, 1e-12) for a, b in zip(found, found[1:])]
            worst = max(abs(part - total / 1000) for part in parts)
            return None if len(parts) == 1000 and worst < NEAR else f"{len(parts)} parts, {worst:.1e} off"

        yield Row(f"parameter at length, 1,000 on one curve, {kind}", 1000, divided, uneven)



def closest(inputs, reference):
    queries = [gp_Pnt(*p) for p in inputs.points["q_curve"]]
    for name, kind in (("c_nr", "plain"), ("c_r", "rational")):
        shape = curve(inputs.curves[name])
        wanted = reference[f"{name}_cp"]

        def once(shape=shape):
            found = []
            for query in queries:
                # It finds feet of perpendiculars alone.
                search = GeomAPI_ProjectPointOnCurve(query, shape)
                inner = [search.LowerDistance()] if search.NbPoints() else []
                found.append(min(inner + [query.Distance(end()) for end in (shape.StartPoint, shape.EndPoint)]))
            return found

        def ready(shape=shape):
            adaptor = GeomAdaptor_Curve(shape)
            search = Extrema_ExtPC()
            search.Initialize(adaptor, adaptor.FirstParameter(), adaptor.LastParameter(), 1e-10)
            ends = [adaptor.Value(t) for t in (adaptor.FirstParameter(), adaptor.LastParameter())]
            found = []
            for query in queries:
                search.Perform(query)
                inner = [search.SquareDistance(k) for k in range(1, search.NbExt() + 1)] if search.IsDone() else []
                found.append(min(inner + [query.SquareDistance(end) for end in ends]) ** 0.5)
            return found

        judge = lambda found, wanted=wanted: missed(found, wanted)
        yield Row(f"closest point on a curve, one question a curve, {kind}", len(queries), once, judge)
        yield Row(f"closest point on a curve, prepared, {kind}", len(queries), ready, judge)
    wanted = reference["s_nr_cp"]
    some = [gp_Pnt(*p) for p in inputs.points["q_surf"][: len(wanted)]]
    shape = surface(inputs.surfaces["s_nr"])

    def on_surface():
        search = GeomAPI_ProjectPointOnSurf()
        search.Init(shape, *shape.Bounds(), 1e-10)
        found = []
        for query in some:
            search.Perform(query)
            found.append(search.LowerDistance() if search.NbPoints() else None)
        return found

    yield Row("closest point on a surface, plain", len(some), on_surface, lambda found: missed(found, wanted))


def others(inputs, reference):
    for case, name, a, b in (
        ("cc", "curve with curve, 7 crossings", "cc_a", "cc_b"),
        ("weave", "curve with curve, two weaving cubics with 67 crossings", "wv_a", "wv_b"),
    ):
        pair = flat(inputs.curves[a]), flat(inputs.curves[b])
        count = len(reference[case])
        yield Row(
            name,
            1,
            lambda pair=pair: Geom2dAPI_InterCurveCurve(*pair, 1e-9).NbPoints(),
            lambda found, count=count: None if found == count else f"{found} of {count} found",
        )
    points = [gp_Pnt(*p) for p in inputs.points["interp1000"]]
    given = HArray1_gp_Pnt(1, len(points))
    for place, point in enumerate(points, 1):
        given.SetValue(place, point)

    def interpolated():
        fit = GeomAPI_Interpolate(given, False, 1e-9)
        fit.Perform()
        return fit.Curve()

    def apart(shape):
        worst = max(GeomAPI_ProjectPointOnCurve(p, shape).LowerDistance() for p in points[1:-1:50])
        return None if worst < NEAR else f"{worst:.1e} off"

    yield Row("interpolate 1,000 points", 1, interpolated, apart)
    raised = curve(inputs.curves["c_nr"])

    def degree():
        copy = Geom_BSplineCurve(raised)
        copy.IncreaseDegree(4)
        return copy

    def differs(shape):
        worst = max(shape.Value(k / 97).Distance(raised.Value(k / 97)) for k in range(98))
        return None if worst < 1e-9 else f"{worst:.1e} off"

    yield Row("raise degree", 1, degree, differs)


def ours(table):
    """Nanoseconds by the name of the row."""
    found = {}
    for line in table.read_text().splitlines():
        cells = [cell.strip() for cell in line.split("|")]
        if len(cells) > 3 and re.fullmatch(r"[\d.]+", cells[2]):
            found[cells[1]] = float(cells[2])
    return found


def main():
    folder = Path(sys.argv[1])
    inputs, reference = read(folder / "inputs.txt"), json.loads((folder / "reference.json").read_text())
    known = ours(Path(sys.argv[2])) if len(sys.argv) > 2 else {}
    print("| operation | Katydid ns | Open CASCADE ns | ratio | its answers |\n| --- | --- | --- | --- | --- |")
    for kind in (lengths, closest, others):
        for row in kind(inputs, reference):
            wrong = row.wrong(row.work())
            times = []
            for _ in range(ROUNDS):
                start = time.perf_counter()
                row.work()
                times.append(time.perf_counter() - start)
            theirs = 1e9 * statistics.median(times) / row.items
            katydid = next((ns for name, ns in known.items() if name.startswith(row.name)), None)
            mine, ratio = ("–", "–") if katydid is None else (f"{katydid:.0f}", f"{katydid / theirs:.4f}")
            print(f"| {row.name} | {mine} | {theirs:.0f} | {ratio} | {wrong or 'right'} |", flush=True)


main()
