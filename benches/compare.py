"""Katydid and NumPy over a million items, in turns, so that a busy machine is unfair to both alike. NumPy works on
columns, its fastest way.

    python benches/compare.py [rounds]

Series -> Sine -> Construct Point -> Move -> Distance -> Mass Addition with its partial results.
"""

import json
import statistics
import subprocess
import sys
import time
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
ITEMS = 1_000_000


def numpy_pipeline():
    # Coordinates as columns of their own: rows of three take NumPy more than twice as long.
    x = 0.001 * np.arange(ITEMS)
    y, z = np.sin(x), np.zeros(ITEMS)
    x, y, z = x + 0.0, y + 0.0, z + 10.0
    return np.cumsum(np.sqrt(x * x + y * y + z * z))


def numpy_seconds():
    times = []
    for _ in range(15):
        start = time.perf_counter()
        numpy_pipeline()
        times.append(time.perf_counter() - start)
    return statistics.median(times)


def katydid_seconds():
    command = ["cargo", "bench", "-q", "-p", "katydid-solver", "--bench", "pipeline"]
    subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    metadata = subprocess.run(
        ["cargo", "metadata", "--format-version", "1", "--no-deps"], cwd=ROOT, check=True, capture_output=True
    )
    target = Path(json.loads(metadata.stdout)["target_directory"])

    def median(threads):
        path = target / "criterion" / "pipeline" / f"threads {threads}" / "new" / "estimates.json"
        return json.loads(path.read_text())["median"]["point_estimate"] / 1e9

    return median(1), median(2)


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    rows = []
    for _ in range(rounds):
        peer = numpy_seconds()
        one, two = katydid_seconds()
        rows.append((peer, one, two))
        print(f"NumPy {peer * 1e3:.1f} ms, one thread {one * 1e3:.1f} ms, two threads {two * 1e3:.1f} ms")
    peer, one, two = (statistics.median(column) for column in zip(*rows))
    print(f"one thread / NumPy  {one / peer:.2f}")
    print(f"two threads / NumPy {two / peer:.2f}")
    print(f"two threads / one   {two / one:.2f}")


if __name__ == "__main__":
    main()
