"""Races Open CASCADE on pairs of spline surfaces whose common curves are known.

    cargo build --release -p katydid-geometry --example ssi_race
    python benches/ssi_race.py target/release/examples/ssi_race ../shared/data/oracle/ssi_dev.json [REPEATS]

With cadquery-ocp (python-tests/step/requirements.txt). FILE is a list of `cases` of surfaces `a` and `b` with the number of
`closed` and `open` branches and their `length` within `length_rel_tol`. The kernels take turns on each pair, one thread each;
an answer is verified before its time counts, and the smallest time of the repeats stands.
"""

import json
import statistics
import subprocess
import sys
import time

from OCP.collections import Array1_double, Array1_int, Array2_double, Array2_gp_Pnt
from OCP.Geom import Geom_BSplineSurface
from OCP.GeomAdaptor import GeomAdaptor_Curve
from OCP.GeomAPI import GeomAPI_IntSS
from OCP.GCPnts import GCPnts_AbscissaPoint
from OCP.gp import gp_Pnt

# The distance within which curves are wanted, as a part of the size.
WITHIN = 1e-6
# Ends of one curve are no further apart than this part of the size.
SAME = 1e-5


def multiplicities(knots, degree):
    """Different knots and how often each stands, with the two at the ends that openNURBS leaves out."""
    full = [knots[0], *knots, knots[-1]]
    values, counts = [], []
    for knot in full:
        if values and knot == values[-1]:
            counts[-1] += 1
        else:
            values.append(knot)
            counts.append(1)
    assert counts[0] == counts[-1] == degree + 1
    return values, counts


def surface(data):
    """A surface of the file as Open CASCADE's."""
    degrees = [order - 1 for order in data["order"]]
    rows, columns = data["n"]
    points, weights = Array2_gp_Pnt(1, rows, 1, columns), Array2_double(1, rows, 1, columns)
    for i in range(rows):
        for j in range(columns):
            place = data["cv"][i * columns + j]
            weight = place[3] if data["rat"] else 1.0
            points.SetValue(i + 1, j + 1, gp_Pnt(*(x / weight for x in place[:3])))
            weights.SetValue(i + 1, j + 1, weight)
    sides = []
    for knots, degree in zip(data["knots"], degrees):
        values, counts = multiplicities(knots, degree)
        reals, integers = Array1_double(1, len(values)), Array1_int(1, len(values))
        for k, (value, count) in enumerate(zip(values, counts)):
            reals.SetValue(k + 1, value)
            integers.SetValue(k + 1, count)
        sides.append((reals, integers))
    (uk, um), (vk, vm) = sides
    return Geom_BSplineSurface(points, weights, uk, vk, um, vm, *degrees, False, False)


def joined(ends, near):
    """How many closed and open chains curves with these end points make."""
    chains = [list(e) for e in ends]
    closed = 0
    while True:
        done = [c for c in chains if c[0].Distance(c[1]) <= near]
        closed += len(done)
        chains = [c for c in chains if c[0].Distance(c[1]) > near]
        pair = next(
            (
                (i, j, a, b)
                for i in range(len(chains))
                for j in range(i + 1, len(chains))
                for a in (0, 1)
                for b in (0, 1)
                if chains[i][a].Distance(chains[j][b]) <= near
            ),
            None,
        )
        if pair is None:
            return closed, len(chains)
        i, j, a, b = pair
        other = chains.pop(j)
        chains[i] = [chains[i][1 - a], other[1 - b]]


def occt(a, b, size):
    """Closed and open branches, their length, and the milliseconds that the intersection took."""
    start = time.perf_counter()
    met = GeomAPI_IntSS(a, b, WITHIN * size)
    took = 1e3 * (time.perf_counter() - start)
    if not met.IsDone():
        return 0, 0, 0.0, took
    ends, length = [], 0.0
    for k in range(1, met.NbLines() + 1):
        curve = GeomAdaptor_Curve(met.Line(k))
        length += GCPnts_AbscissaPoint.Length_s(curve)
        ends.append((curve.Value(curve.FirstParameter()), curve.Value(curve.LastParameter())))
    closed, opened = joined(ends, SAME * size)
    return closed, opened, length, took


def is_right(case, closed, opened, length):
    near = abs(length - case["length"]) <= case["length_rel_tol"] * max(case["length"], 1e-9)
    return (closed, opened) == (case["closed"], case["open"]) and near


def main():
    program, path = sys.argv[1:3]
    repeats = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    with open(path) as file:
        cases = json.load(file)["cases"]
    own = subprocess.Popen([program, path], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def ours(index):
        own.stdin.write(f"{index}\n")
        own.stdin.flush()
        words = own.stdout.readline().split()
        return int(words[0]), int(words[1]), float(words[2]), float(words[4])

    right, times = {"katydid": 0, "occt": 0}, []
    for index, case in enumerate(cases):
        pair = surface(case["a"]), surface(case["b"])
        best, good = {}, {}
        for _ in range(repeats):
            for name, answer in (("katydid", ours(index)), ("occt", occt(*pair, case["size"]))):
                good[name] = is_right(case, *answer[:3])
                best[name] = min(best.get(name, answer[3]), answer[3])
        for name in right:
            right[name] += good[name]
        if all(good.values()):
            times.append((best["katydid"], best["occt"]))
        else:
            print(f"{case.get('id', index)} {case.get('family', '')}: right are {[n for n in good if good[n]]}")
    own.stdin.close()
    own.wait()
    print(f"of {len(cases)} pairs right: Katydid {right['katydid']}, Open CASCADE {right['occt']}")
    if times:
        print(
            f"where both are right ({len(times)}), ms in all: {sum(t[0] for t in times):.1f} and "
            f"{sum(t[1] for t in times):.1f}; median of the ratios Open CASCADE / Katydid: "
            f"{statistics.median(t[1] / t[0] for t in times):.2f}"
        )


if __name__ == "__main__":
    main()
