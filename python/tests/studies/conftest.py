"""Studies on clusters and under optimisers of other packages. `make test-studies` runs these; they are no part of `make test`."""

import json
import os
import shutil
import subprocess
import sys

import pytest

HERE = os.path.dirname(os.path.abspath(__file__))
PACKAGE = os.path.dirname(os.path.dirname(HERE))
if PACKAGE not in sys.path:
    sys.path.insert(0, PACKAGE)
# The processes of a cluster find the package that is tested.
os.environ["PYTHONPATH"] = PACKAGE + os.pathsep + os.environ.get("PYTHONPATH", "")
os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")
# Ray's workers stand back behind all other programs of a machine; beside a sweep that does not, times would not compare.
os.environ.setdefault("RAY_worker_niceness", "0")

TABLES = ("table.parquet", "data.csv", "failed.csv")
#: The sum of sin(a·k) + b over so many k: some milliseconds a point, as many as KATYDID_STUDY_ITEMS says.
WORK = """katydid 1
a = Number Slider(0.5, 0.0000..1.0000)
b = Number Slider(3, 0..99)
k = Series(0, 1, {items})
f = Expression("Sin(a*k) + b", a = a, k = k, b = b)
total = Mass Addition(f)
"""


def work(folder, items):
    """A definition of about so many items of work, and its file."""
    file = os.path.join(str(folder), "work.kd")
    with open(file, "w", encoding="utf-8") as out:
        out.write(WORK.format(items=items))
    return file


def plan(folder, points, **more):
    """A plan of so many points in hundreds."""
    whole = {"inputs": {"a": {"steps": points // 100}, "b": {}}, "outputs": ["total.Result"], **more}
    file = os.path.join(str(folder), "plan-%d.json" % points)
    with open(file, "w", encoding="utf-8") as out:
        json.dump(whole, out)
    return file


def tables(folder):
    """The bytes of the tables of a study."""
    found = {}
    for name in TABLES:
        with open(os.path.join(str(folder), name), "rb") as table:
            found[name] = table.read()
    return found


def program():
    """The program `katydid`."""
    found = os.environ.get("KATYDID") or shutil.which("katydid")
    if not found:
        pytest.skip("KATYDID names no program")
    return found


def sweep(*words, check=True):
    """`katydid sweep` with words."""
    run = subprocess.run([program(), "sweep", *map(str, words)], capture_output=True, text=True)
    if check:
        assert run.returncode in (0, 1), run.stderr
    return run
