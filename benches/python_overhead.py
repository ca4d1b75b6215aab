"""What the Python package costs beyond a solve: a call on a definition of 20 objects, and a million points in and out.

    PYTHONPATH=python python benches/python_overhead.py
"""

import statistics
import tempfile
import time
from pathlib import Path

import numpy as np

import katydid


def opened(text):
    file = Path(tempfile.mkdtemp()) / "bench.kd"
    file.write_text("katydid 1\n" + text)
    return katydid.open(file)


def beyond(solve, times):
    """The milliseconds of a call without those of the solve itself: the median and the smallest."""
    taken = []
    for place in range(times):
        begin = time.perf_counter()
        r = solve(place)
        taken.append(1e3 * (time.perf_counter() - begin) - r.milliseconds)
    return statistics.median(taken), min(taken)


def main():
    lines = ["x = Number Slider(1, 0..1000000)"] + ["a0 = Addition(x, 1)"]
    lines += ["a%d = Addition(a%d, 1)" % (k, k - 1) for k in range(1, 19)]
    d = opened("\n".join(lines) + "\n")
    assert len(d) == 20 and d.solve(x=5)["a18"].item == 24
    print("20 objects, one number in: %.3f ms (median), %.3f ms (least)" % beyond(lambda k: d.solve(x=k), 500))

    d = opened("points = Point()\nmoved = Move(points, Vector XYZ(0, 0, 1))\n")
    points = np.random.default_rng(1).random((1_000_000, 3))
    solved = {}

    def there_and_back(_):
        r = d.solve(points=points)
        solved["back"] = r["moved"].array()
        return r
    print("a million points in and back: %.1f ms (median), %.1f ms (least)" % beyond(there_and_back, 9))
    assert np.allclose(solved["back"], points + [0, 0, 1])
    begin = time.perf_counter()
    np.copyto(np.empty_like(points), points)
    print("a copy of a million points by NumPy, for comparison: %.1f ms" % (1e3 * (time.perf_counter() - begin)))


if __name__ == "__main__":
    main()
