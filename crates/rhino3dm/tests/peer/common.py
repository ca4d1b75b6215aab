"""What every comparison with rhino3dm uses: running this crate, and numbers that are nearly the same."""

import functools
import json
import os
import pathlib
import subprocess

CRATE = pathlib.Path(__file__).resolve().parent.parent.parent
SHARED = CRATE.parent.parent.parent / "shared" / "data" / "3dm"
CLOSE = 1e-12
VERSIONS = (4, 50, 60, 70, 80)


@functools.cache
def executables():
    """The path of each example of this crate by its name. They lie where `KATYDID_EXAMPLES` says; none is built here."""
    folder = os.environ.get("KATYDID_EXAMPLES")
    if not folder:
        raise RuntimeError("KATYDID_EXAMPLES is not set: `make test-python` builds the examples and sets it")
    return {path.name: path for path in pathlib.Path(folder).iterdir()}


def example(name, *arguments):
    command = [executables()[name], *map(str, arguments)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def dumped(path):
    return [json.loads(line) for line in example("dump", path).splitlines()]


def close(ours, theirs, what="", within=CLOSE):
    """Compares numbers and nested sequences of them, relatively beyond 1."""
    if isinstance(theirs, (list, tuple)):
        assert len(ours) == len(theirs), f"{what}: {len(ours)} here, {len(theirs)} there"
        for i, (a, b) in enumerate(zip(ours, theirs)):
            close(a, b, f"{what}[{i}]", within)
        return
    assert abs(ours - theirs) <= within * max(1.0, abs(theirs)), f"{what}: {ours} here, {theirs} there"


def xyz(p):
    return [p.X, p.Y, p.Z]


def ends(interval):
    return [interval.T0, interval.T1]


def encoded(geometry):
    try:
        return geometry.Encode()["data"]
    except Exception:  # rhino3dm does not encode every class
        return None
