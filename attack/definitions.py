"""Definitions made to take too much: of memory, of time, or of the stack.

    python attack/definitions.py target/release/katydid
"""

import random
import sys
import tempfile
import time
import uuid
from pathlib import Path

from bounded import Bounds, alone, run

BOUNDS = Bounds(320, 4.0)
LIMITS = ["--limit-bytes", str(256 << 20), "--limit-seconds", "2", "--threads", "1"]


def doubled(first, line, times):
    """A line that reads itself twice, so many times."""
    lines = [f"t0 = {first}"] + [f"t{k} = {line.format(f't{k - 1}')}" for k in range(1, times + 1)]
    return "\n".join(lines)


def texts():
    """Definitions as text, without their first line."""
    yield "series", "x = Series(0, 1, 2147483647)"
    yield "doubled texts", doubled('Panel("0123456789abcdef")', "Concatenate({0}, {0})", 60)
    yield "doubled lists", doubled("Series(0, 1, 1000)", "Merge({0}, {0})", 40)
    yield "doubled trees", doubled("Graft Tree(Series(0, 1, 1000))", "Merge({0}, {0})", 40)
    yield "cross reference", "a = Series(0, 1, 100000)\nx = Cross Reference(a, a)"
    yield "a long chain", doubled("1", "Addition({0}, 1)", 20_000)
    yield "a wide fan", "a = 1\n" + "\n".join(f"x{k} = Negative(a)" for k in range(20_000))
    wires = ", ".join(f"x{k}" for k in range(2000))
    yield "many wires", "\n".join(f"x{k} = {k}" for k in range(2000)) + f"\ny = Merge([{wires}], [{wires}])"
    yield "all to all", "\n".join(
        [f"a{k} = {k}" for k in range(300)] + [f"b{k} = Negative([{', '.join(f'a{j}' for j in range(300))}])" for k in range(300)]
    )
    yield "a huge panel", f'x = Panel("{"x" * 20_000_000}")'
    yield "a panel of lines", 'x = Panel("' + "\\n".join(map(str, range(500_000))) + '")'
    yield "brackets", f'x = Expression("{"(" * 100_000}1{")" * 100_000}")'
    yield "a long formula", f'x = Expression("{"+".join(["1"] * 500_000)}")'
    yield "powers", 'x = Expression("9^9^9^9^9^9^9")'
    yield "digits", f'x = Panel("{"9" * 1_000_000}")\ny = Addition(x, 1)'
    yield "a slow pattern", f'x = Match Text("{"a" * 5000}", "*b", "(a+)+(a+)+(a+)+$")'
    yield "a large pattern", 'x = Match Text("a", "*b", "((a{1000}){1000}){1000}")'
    yield "a wide format", 'x = Format("{0:D2000000000}", 127, 1)'
    yield "a sphere", "x = Mesh Sphere(XY Plane(), 1, 1000000, 1000000)"
    yield "a subdivision", "b = Center Box(XY Plane(), 1, 1, 1)\nm = Mesh Box(b, 1, 1, 1)\ns = SubD from Mesh(m)\nx = Mesh from SubD(s, 14)"
    yield "moved spheres", "m = Mesh Sphere(XY Plane(), 1, 400, 400)\nv = Vector XYZ(Series(0, 1, 1000), 0, 0)\nx = Move(m, v)"
    yield "nested arrays", doubled("Circle(XY Plane(), 1)", "Linear Array({0}, vector(1, 0, 0), 100)", 6)
    yield "brackets of a text", "x = " + "(" * 200_000
    yield "a list in a list", "x = " + "[" * 100_000 + "1" + "]" * 100_000
    yield "a long name", f"{'x' * 5_000_000} = 1"


def item(name, kind, code, value):
    return f'<item name="{name}" type_name="{kind}" type_code="{code}">{value}</item>'


def archive(inside):
    return f'<?xml version="1.0" encoding="utf-8"?>\n<Archive name="Root">{inside}</Archive>'


def archives():
    """Definitions as XML."""
    yield "deep chunks", archive('<chunks><chunk name="a">' * 100_000)
    yield "many items", archive(f'<items count="2000000">{item("a", "gh_int32", 3, 1) * 300_000}</items>')
    yield "a false count", archive('<items count="2147483647"></items>')
    yield "laughs", (
        '<?xml version="1.0"?><!DOCTYPE a [<!ENTITY a0 "ha">'
        + "".join(f'<!ENTITY a{k} "{f"&a{k - 1};" * 10}">' for k in range(1, 12))
        + ']><Archive name="Root"><items>&a11;</items></Archive>'
    )
    yield "a wide attribute", archive(f'<items name="{"x" * 30_000_000}"></items>')


def looped(katydid, folder):
    """A definition whose objects read each other in a loop, made from one that does not: sources are swapped."""
    path, out = Path(folder) / "chain.kd", Path(folder) / "chain.ghx"
    path.write_text("katydid 1\n" + doubled("Addition(1, 1)", "Addition({0}, {0})", 30) + "\n")
    run([katydid, "convert", str(path), str(out)])
    text = out.read_text()
    ids = [part[:36] for part in text.split('name="Source"')[1:] for part in [part.split(">", 1)[1]]]
    dice = random.Random(1)
    for wanted in set(ids):
        text = text.replace(f">{wanted}<", f">{dice.choice(ids)}<")
    yield "mixed sources", text
    yield "one source for all", text.replace(ids[0], ids[-1]) if ids else text
    yield "sources that are not there", "".join(str(uuid.UUID(int=7)) if part in ids else part for part in [text])


def attack(katydid, found, seconds=None, bounds=BOUNDS):
    """Runs and checks each of them, within the time that there is."""
    end = time.monotonic() + seconds if seconds else None
    with tempfile.TemporaryDirectory() as folder:
        trials = [(name, ".kd", f"katydid 1\n{text}\n") for name, text in texts()]
        trials += [(name, ".ghx", text) for name, text in [*archives(), *looped(katydid, folder)]]
        random.Random(1).shuffle(trials)
        for name, suffix, text in trials:
            path = Path(folder) / f"hostile{suffix}"
            path.write_text(text)
            for words in (["run", path, *LIMITS], ["check", path], ["convert", path, Path(folder) / "out.gh"]):
                if end and time.monotonic() > end:
                    return
                outcome = run([katydid, *map(str, words)])
                found.note(f"{name} by {words[0]}", bounds.fault(outcome), text.encode(), suffix)


if __name__ == "__main__":
    sys.exit(alone("definitions", __doc__, attack))
