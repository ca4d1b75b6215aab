"""Times this crate against rhino3dm at reading and writing the same .3dm files, in one run.

Needs `pip install rhino3dm`; `python benches/rhino3dm_speed.py [FILE.3dm…]`. Without files: ten thousand curves, a
thousand breps, and the largest of the shared archives. Prints the medians and their ratios; what reads in half of
rhino3dm's time and writes in 0.35 of it is as fast as it should be.
"""

import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import rhino3dm

ROOT = pathlib.Path(__file__).resolve().parent.parent
SHARED = ROOT.parent / "shared" / "data" / "3dm"
VERSION = 7
PATIENCE = 1.5


def median(run):
    times = []
    start = time.perf_counter()
    while len(times) < 5 or time.perf_counter() - start < PATIENCE:
        one = time.perf_counter()
        run()
        times.append(time.perf_counter() - one)
    return statistics.median(times)


def curves(count):
    """Wavy cubic curves of twenty control points."""
    model = rhino3dm.File3dm()
    for i in range(count):
        points = [rhino3dm.Point3d(x, math.sin(x + i), i / 100) for x in range(20)]
        model.Objects.AddCurve(rhino3dm.NurbsCurve.Create(False, 3, points))
    return model


def breps(count):
    """Boxes, cylinders and spheres."""
    model = rhino3dm.File3dm()
    for i in range(count):
        low = rhino3dm.Point3d(3 * i, 0, 0)
        if i % 3 == 0:
            box = rhino3dm.BoundingBox(low, rhino3dm.Point3d(3 * i + 1, 1 + i / count, 1))
            brep = rhino3dm.Brep.CreateFromBox(rhino3dm.Box(box))
        elif i % 3 == 1:
            cylinder = rhino3dm.Cylinder(rhino3dm.Circle(low, 1.0), 2.0)
            brep = rhino3dm.Brep.CreateFromCylinder(cylinder, True, True)
        else:
            brep = rhino3dm.Brep.CreateFromSphere(rhino3dm.Sphere(low, 1.0))
        model.Objects.AddBrep(brep)
    return model


def ours(files):
    build = ["cargo", "build", "-q", "--release", "-p", "katydid-3dm", "--example", "speed", "--message-format=json"]
    messages = subprocess.run(build, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout
    built = [json.loads(line) for line in messages.splitlines()]
    program = next(m["executable"] for m in built if m.get("executable"))
    # A process for each file: memory that one gave back would count for the next as if it had been there before.
    commands = [[program, str(10 * VERSION), str(file)] for file in files]
    return [json.loads(subprocess.run(c, check=True, capture_output=True, text=True).stdout) for c in commands]


def theirs(file, folder):
    data = file.read_bytes()
    read = median(lambda: rhino3dm.File3dm.FromByteArray(data))
    model = rhino3dm.File3dm.FromByteArray(data)
    out = os.path.join(folder, "out.3dm")
    return read, median(lambda: model.Write(out, VERSION))


def main(files):
    with tempfile.TemporaryDirectory() as folder:
        if not files:
            for name, model in (("curves", curves(10_000)), ("breps", breps(1_000))):
                files.append(pathlib.Path(folder) / f"{name}.3dm")
                model.Write(str(files[-1]), VERSION)
            files += sorted(SHARED.glob("*.3dm"), key=lambda path: path.stat().st_size)[-1:]
        for result in ours(files):
            file = pathlib.Path(result["file"])
            read, write = theirs(file, folder)
            print(f"{file.name}: {result['bytes'] / 1e6:.2f} MB, {result['objects']} objects")
            for what, here, there in (("read", result["read"], read), ("written", result["write"], write)):
                print(f"  {what} in {1e3 * here:.2f} ms here, {1e3 * there:.2f} ms there: {here / there:.2f}")
            print(f"  peak while reading {result['peak'] / result['bytes']:.2f} times the file")


if __name__ == "__main__":
    main([pathlib.Path(path) for path in sys.argv[1:]])
