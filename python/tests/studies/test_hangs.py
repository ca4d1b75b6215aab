"""Points that take for ever, or too much memory: scripts with endless loops, huge unions and lists. Their rows name them, the
rest goes on."""

import csv
import json
import subprocess
import sys

import pytest
from conftest import program

#: Twice the slider, by a script that goes round for ever at 3 and at 7.
PYTHON = '''katydid 1
s = Number Slider(1, 0..11)
twice = `GhPython Script` @410755b1-224a-4c1e-a407-bf32fb45ea7e(x = s) variable -> out, a {
    CodeInput = """
        while x in (3, 7):
            pass
        a = x * 2
        """
    HideInput = true
}
after = Addition(s, 1)
'''
SHARP = '''katydid 1
s = Number Slider(1, 0..11)
code = Panel("// #! csharp\\nint n = (int)x; while (n == 3 || n == 7) { } a = n * 2;")
twice = Script @c9b2d725-6f87-4b07-af90-bd9aefef68eb(script = code, x = s) variable -> out, a {
    UsingScriptInputParam = true
}
after = Addition(s, 1)
'''
#: Twice the slider, beside a union of three thousand spheres at 3 and at 7, which takes minutes.
UNION = '''katydid 1
s = Number Slider(1, 0..11)
n = Expression("If(x = 3, 3000, If(x = 7, 3000, 2))", x = s)
box = Center Box(plane((0, 0, 0)), 5, 5, 5)
points = Populate 3D(box, n)
balls = Sphere(points, 1.5)
joined = Solid Union(balls)
size = Volume(joined)
total = Mass Addition(size.Volume)
twice = Expression("2*s + 0*t", s = s, t = total)
after = Addition(s, 1)
'''
#: Twice the slider, beside sixteen million pairs at 3 and at 7.
PAIRS = '''katydid 1
s = Number Slider(1, 0..11)
n = Expression("If(x = 3, 4000, If(x = 7, 4000, 2))", x = s)
many = Series(0, 1, n)
joined = Cross Reference(many, many) -> A, B
total = Mass Addition(joined.A)
twice = Expression("2*s + 0*t", s = s, t = total)
after = Addition(s, 1)
'''
OBJECTS = {"python": (PYTHON, "twice.a"), "sharp": (SHARP, "twice.a"), "union": (UNION, "twice"), "pairs": (PAIRS, "twice")}
SECONDS = 4


def study(folder, kind):
    """The definition and the plan of a kind."""
    text, output = OBJECTS[kind]
    file, plan = folder / "hangs.kd", folder / "plan.json"
    file.write_text(text)
    plan.write_text(json.dumps({"inputs": {"s": {}}, "outputs": [output, "after"]}))
    return file, plan, output


def check(folder, output, status):
    """All rows but two have their results, and those two say why they have none."""
    with open(folder / "data.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 12
    for k, row in enumerate(rows):
        if k in (3, 7):
            assert row["status"] == status and row["reason"].split(":")[0] in ("twice", "joined"), row
        else:
            assert row["status"] == "ok" and float(row["out:" + output]) == 2 * k and float(row["out:after"]) == k + 1, row


@pytest.mark.parametrize("kind", ["python", "sharp", "union"])
@pytest.mark.parametrize("workers", [1, 4])
def test_points_that_never_end_are_named_and_all_others_are_solved(tmp_path, kind, workers):
    file, plan, output = study(tmp_path, kind)
    words = [program(), "sweep", str(file), "--plan", str(plan), "-o", str(tmp_path / "s"), "--workers", str(workers),
             "--limit-seconds", str(SECONDS), "--allow-scripts"]
    run = subprocess.run(words, capture_output=True, text=True, timeout=20 * SECONDS)
    assert run.returncode == 1 and "2 without results" in run.stderr, run.stderr
    check(tmp_path / "s", output, "time")


@pytest.mark.parametrize("kind", ["python", "sharp"])
def test_they_are_named_from_python_too(tmp_path, kind):
    file, plan, output = study(tmp_path, kind)
    code = ("import katydid, sys\n"
            "summary = katydid.study(sys.argv[1], sys.argv[2], sys.argv[3], time_limit=float(sys.argv[4]), allow_scripts=True)"
            ".run(engine='local', workers=3)\nprint(summary.solved, summary.failed)\n")
    run = subprocess.run([sys.executable, "-c", code, file, plan, tmp_path / "s", str(SECONDS)], capture_output=True, text=True,
                         timeout=20 * SECONDS)
    assert run.stdout.split() == ["12", "2"], run.stdout + run.stderr
    check(tmp_path / "s", output, "time")


def test_a_point_that_takes_too_much_memory_is_named(tmp_path):
    file, plan, output = study(tmp_path, "pairs")
    words = [program(), "sweep", str(file), "--plan", str(plan), "-o", str(tmp_path / "s"), "--workers", "3",
             "--limit-bytes", "100000000"]
    run = subprocess.run(words, capture_output=True, text=True, timeout=120)
    assert run.returncode == 1, run.stderr
    check(tmp_path / "s", output, "memory")
