"""Every component with extreme inputs, under limits of memory and time that are measured from outside.

    python attack/components.py target/release/katydid            every component, every theme
    python attack/components.py target/release/katydid --seconds 120      a sample of what fits into two minutes
    python attack/components.py target/release/katydid --only Voronoi     one component

A run fails when the process takes more than 320 MB under a limit of 256 MB, more than 2.3 s of processor time under a
limit of 2 s, or ends in any other way than by an exit code of the command.
"""

import json
import os
import random
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from bounded import Bounds, alone, run

LIMIT = 256 << 20
BOUNDS = Bounds(320, 2.3, (0, 1))

# Labels that inputs are wired to, each with what it reads.
MADE = {
    "few": ("Series(0, 1, 50)", []),
    "n": ("Series(0, 1, 2000)", []),
    "many": ("Series(0, 1, 1000000)", []),
    "pts": ("Construct Point(n, n |{(x*7919) % 101}, 0)", ["n"]),
    "row": ("Construct Point(row_x, 0, 0)", ["row_x"]),
    "row_x": ("Series(0, 0.1, 300000)", []),
    "same": ("Construct Point(same_x, 0, 0)", ["same_x"]),
    "same_x": ("Series(0, 0, 200000)", []),
    "wild": ("Construct Point([1e300, -1e300, nan, inf, 1e-300, 0], [0, 1e300, 1, nan, 0, 0], 0)", []),
    "vec": ("Vector XYZ(n, 1, 0)", ["n"]),
    "mesh": ("Mesh Sphere(plane((0, 0, 0)), 10, 400, 400)", []),
    "meshes": ("Mesh Box(box(plane((0, 0, 0)), 0..1, 0..1, 0..1), few |{1 + x % 4}, 8, 8)", ["few"]),
    "curve": ("Interpolate(zigzag)", ["zigzag"]),
    "zigzag": ("Construct Point(z_x, z_x |{Sin(x*12.9898)*10}, z_x |{Cos(x*78.233)*10})", ["z_x"]),
    "z_x": ("Series(0, 0.01, 20000)", []),
    "poly": ("PolyLine(zigzag)", ["zigzag"]),
    "circles": ("Circle(plane((0, 0, 0)), n |{x + 1})", ["n"]),
    "lines": ("Line SDL(pts, vector(1, 2, 3), n |{x + 1})", ["pts", "n"]),
    "surface": ("Surface From Points(grid, 60)", ["grid"]),
    "grid": ("Construct Point(g, g |{x % 60}, g |{Sin(x)})", ["g"]),
    "g": ("Series(0, 1, 3600)", []),
    "ball": ("Sphere(plane((0, 0, 0)), 10)", []),
    "boxes": ("Domain Box(plane((0, 0, 0)), 0..1, 0..1, n |{x + 1})", ["n"]),
    "long": ("Panel(\"" + "x" * 100_000 + "\")", []),
    "texts": ("Text Join(n, \",\")", ["n"]),
    "deep": ("Graft Tree(many)", ["many"]),
    "box": ("Center Box(plane((0, 0, 0)), 5, 5, 5)", []),
    "field": ("Point Charge(pts, 1)", ["pts"]),
}

# What an input of a type is given: one heavy item, many items, and what is wild. Labels, or values.
NUMBER = {
    "heavy": ["1e9", "1e300", "1e-300", "2147483647"],
    "many": ["n", "many"],
    "wild": ["[1e300, -1e300, nan, inf, 1e-308, 0]", "nan", "-1e18"],
}
FEED = {
    "Number": NUMBER,
    "Integer": {
        "heavy": ["2147483647", "1000000", "100000", "10000"],
        "many": ["n", "many"],
        "wild": ["-2147483648", "[2147483647, -1, 0, null]"],
    },
    "Boolean": {"heavy": ["true"], "many": ["n"], "wild": ["[true, null, false]"]},
    "Point": {"heavy": ["row", "same"], "many": ["pts", "zigzag", "row"], "wild": ["wild"]},
    "Vector": {"heavy": ["vector(1e300, 0, 0)"], "many": ["vec"], "wild": ["wild", "vector(0, 0, 0)"]},
    "Plane": {"heavy": ["plane((0, 0, 0))"], "many": ["pts"], "wild": ["wild"]},
    "Text": {"heavy": ["long", "texts"], "many": ["n", "many"], "wild": ["\"\"", "\"nan\"", "long"]},
    "Curve": {"heavy": ["curve", "poly"], "many": ["circles", "lines"], "wild": ["PolyLine(wild)"]},
    "Line": {"heavy": ["lines"], "many": ["lines"], "wild": ["Line(wild, (0, 0, 0))"]},
    "Circle": {"heavy": ["circles"], "many": ["circles"], "wild": ["Circle(plane((0, 0, 0)), 1e300)"]},
    "Arc": {"heavy": ["circles"], "many": ["circles"], "wild": ["Circle(plane((0, 0, 0)), 1e-300)"]},
    "Rectangle": {"heavy": ["boxes"], "many": ["boxes"], "wild": ["Rectangle(plane((0, 0, 0)), 1e300, 1e-300)"]},
    "Box": {"heavy": ["mesh"], "many": ["boxes"], "wild": ["Center Box(plane((0, 0, 0)), 1e200, 0, 1e-200)"]},
    "Surface": {"heavy": ["surface"], "many": ["boxes"], "wild": ["Sphere(plane((0, 0, 0)), 1e300)"]},
    "Brep": {"heavy": ["surface", "ball"], "many": ["boxes"], "wild": ["Sphere(plane((0, 0, 0)), 1e-300)"]},
    "Mesh": {"heavy": ["mesh"], "many": ["meshes"], "wild": ["Mesh Sphere(plane((0, 0, 0)), 1e300, 3, 3)"]},
    "SubD": {"heavy": ["mesh"], "many": ["meshes"], "wild": ["box"]},
    "Geometry": {"heavy": ["mesh", "curve", "surface"], "many": ["meshes", "circles", "zigzag"], "wild": ["wild"]},
    "Domain": {"heavy": ["0..1e300"], "many": ["n"], "wild": ["0..nan", "0..0", "1..-1e300"]},
    "Domain²": {"heavy": ["domain2(0..1e300, 0..1)"], "many": ["n"], "wild": ["domain2(0..0, 0..nan)"]},
    "Colour": {"heavy": ["rgb(1, 2, 3)"], "many": ["n"], "wild": ["rgb(1, 2, 3)"]},
    "Field": {"heavy": ["field"], "many": ["field"], "wild": ["field"]},
    "Generic Data": {
        "heavy": ["mesh", "long", "1e9"],
        "many": ["n", "many", "deep", "meshes"],
        "wild": ["wild", "[]", "null"],
    },
}
# For each theme which kind of food the inputs have, by the place of the input.
THEMES = {
    "heavy": lambda place, count, dice: "heavy",
    "many": lambda place, count, dice: "many",
    "wild": lambda place, count, dice: "wild",
    "first heavy, others many": lambda place, count, dice: "heavy" if place == 0 else "many",
    "first many, others heavy": lambda place, count, dice: "many" if place == 0 else "heavy",
    "mixed": lambda place, count, dice: dice.choice(["heavy", "many", "wild"]),
}


def definition(component, theme, dice):
    """A definition of one component with its inputs wired to what the theme has for them."""
    used, inputs = [], []

    def need(label):
        if label in MADE and label not in used:
            for other in MADE[label][1]:
                need(other)
            used.append(label)

    ports = component["inputs"]
    for place, port in enumerate(ports):
        food = FEED.get(port["type"], FEED["Generic Data"])[THEMES[theme](place, len(ports), dice)]
        bite = dice.choice(food)
        for label in MADE:
            if label in bite.replace("(", " ").replace(",", " ").replace(")", " ").split():
                need(label)
        modifier = dice.choice(["", "", "", " |graft", " |flatten"]) if bite in MADE else ""
        inputs.append(bite + modifier)
    lines = ["katydid 1"] + [f"{label} = {MADE[label][0]}" for label in used]
    lines.append(f"attacked = `{component['name']}` @{component['guid']}({', '.join(inputs)})")
    return "\n".join(lines) + "\n"


def attack(katydid, found, seconds=None, seed=1, only=None, workers=1, bounds=BOUNDS):
    """Runs components under their limits, in random order; all of them unless the time is over before."""
    listed = subprocess.run([katydid, "components", "--json"], capture_output=True, text=True, check=True)
    components = [c for c in json.loads(listed.stdout) if c["inputs"]]
    if only:
        components = [c for c in components if only.lower() in c["name"].lower()]
    trials = [(component, theme) for component in components for theme in THEMES]
    random.Random(seed).shuffle(trials)
    end = time.monotonic() + seconds if seconds else None
    limits = ["--limit-bytes", str(LIMIT), "--limit-seconds", "2", "--threads", "1"]

    with tempfile.TemporaryDirectory() as folder:

        def one(numbered):
            number, (component, theme) = numbered
            if end and time.monotonic() > end:
                return None
            dice = random.Random(f"{seed} {component['guid']} {theme}")
            text = definition(component, theme, dice)
            path = Path(folder) / f"{number}.kd"
            path.write_text(text)
            outcome = run([katydid, "run", str(path), *limits])
            path.unlink()
            return f"{component['name']}, {theme}", bounds.fault(outcome), text

        with ThreadPoolExecutor(workers) as pool:
            for result in pool.map(one, enumerate(trials)):
                if result:
                    name, wrong, text = result
                    found.note(name, wrong, f"# {wrong}\n{text}".encode(), ".kd")


def options(parser):
    parser.add_argument("--only", help="components with this in their name")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--workers", type=int, default=max(1, (os.cpu_count() or 2) // 2))


if __name__ == "__main__":
    sys.exit(alone("components", __doc__, attack, options, ["seed", "only", "workers"]))
