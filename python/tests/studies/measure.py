"""What studies take: `measure.py PROGRAM`. Prints a table; medians of some runs, since machines are shared.

* a definition of about a millisecond, 10,000 points: seconds for one and for two workers, and whether 1, 2 and 8 workers give the
  same tables;
* a definition of microseconds, 1,000,000 points: memory over time, microseconds a point on one worker.
"""

import os
import resource
import statistics
import subprocess
import sys
import tempfile
import threading
import time

from conftest import plan, tables, work

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "katydid"
ITEMS = int(os.environ.get("KATYDID_STUDY_ITEMS", "40000"))
RUNS = int(os.environ.get("KATYDID_STUDY_RUNS", "3"))


def memory(process):
    """The bytes that a process holds; of Linux."""
    try:
        with open("/proc/%d/statm" % process.pid) as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")
    except (OSError, IndexError):
        return None


def swept(*words):
    """Seconds, seconds of processor time, and the memory at every fifth of a second."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begun = time.monotonic()
    process = subprocess.Popen([PROGRAM, "sweep", *map(str, words)], stderr=subprocess.PIPE, text=True)
    held, over = [], threading.Event()

    def watch():
        while not over.wait(0.2):
            held.append(memory(process))
    watcher = threading.Thread(target=watch)
    watcher.start()
    _, said = process.communicate()
    over.set()
    watcher.join()
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if process.returncode not in (0, 1):
        sys.exit(said)
    used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return time.monotonic() - begun, used, [bytes for bytes in held if bytes]


def scaling(folder):
    file, points = work(folder, ITEMS), plan(folder, 10000)
    seconds = {1: [], 2: []}
    processor = {1: [], 2: []}
    for run in range(RUNS):
        for workers in (1, 2):
            elapsed, used, _ = swept(file, "--plan", points, "-o", os.path.join(folder, "%d-%d" % (workers, run)), "--workers", workers)
            seconds[workers].append(elapsed)
            processor[workers].append(used)
    swept(file, "--plan", points, "-o", os.path.join(folder, "8-0"), "--workers", 8)
    same = len({str(tables(os.path.join(folder, "%d-0" % workers))) for workers in (1, 2, 8)}) == 1
    one, two = (statistics.median(seconds[workers]) for workers in (1, 2))
    print("10,000 points of %.2f ms: one worker %.1f s, two %.1f s, %.2f times; processor time %.1f s and %.1f s; "
          "tables of 1, 2, 8 workers the same: %s"
          % (one / 10, one, two, one / two, *(statistics.median(processor[workers]) for workers in (1, 2)), same))


def flat(folder, count=1_000_000):
    file = os.path.join(folder, "small.kd")
    with open(file, "w", encoding="utf-8") as out:
        out.write("katydid 1\na = Number Slider(0.5, 0.0000..1.0000)\nb = Number Slider(3, 0..99)\ntotal = Addition(a, b)\n")
    points = os.path.join(folder, "million.json")
    with open(points, "w", encoding="utf-8") as out:
        out.write('{"inputs": {"a": {"steps": %d}, "b": {}}, "outputs": ["total"]}' % (count // 100))
    elapsed, used, held = swept(file, "--plan", points, "-o", os.path.join(folder, "million"), "--workers", 1)
    parts = [held[int(part * (len(held) - 1))] / 2**20 for part in (0.05, 0.25, 0.5, 0.75, 1.0)]
    print("%d points: %.1f s, %.1f microseconds a point, %.1f of processor time; MiB at 5, 25, 50, 75, 100 %%: %s"
          % (count, elapsed, 1e6 * elapsed / count, 1e6 * used / count, ", ".join("%.0f" % part for part in parts)))


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        flat(place)
        scaling(place)
