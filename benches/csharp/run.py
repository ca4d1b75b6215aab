#!/usr/bin/env python3
"""The C# interpreter beside Mono's JIT and CPython, on the six programs of this folder: `make bench-csharp`.

The last of them, `members`, runs in a script component with Rhino.Geometry, by the whole program: Mono and CPython, which
cannot run RhinoCommon, run it with structs and classes of their own.

The answers are compared before anything is timed. Seconds are of the processor, the least of a few runs, and include the
start of each program, of which a line of its own tells the length. With --counts, callgrind counts the instructions of ours instead,
which do not depend on what else the machine does. Needs the Debian packages mono-mcs and mono-runtime, and valgrind for
--counts.
"""

import pathlib
import re
import resource
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).parent
NAMES = ["loops", "vectors", "nbody", "sieve", "text"]
# A component of Grasshopper 1 for C#, with its source in three parts.
COMPONENT = "a9a8ebd2-fff5-4c44-a8f5-739736d129ba"
# How far two answers may be apart: RhinoCommon's own formulas round otherwise in the last digits.
NEAR = 1e-9
EMPTY = "class P { static void Main() { } }\n"


def printed(command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def seconds(command, runs):
    best = float("inf")
    for _ in range(runs):
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(command, capture_output=True, check=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        best = min(best, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)
    return best


def assembled(source, folder):
    program = pathlib.Path(folder) / (source.stem + ".exe")
    subprocess.run(["mcs", "-optimize+", f"-out:{program}", str(source)], capture_output=True, check=True)
    return program


def component(name, source, folder):
    """A definition with one script component that runs the marked lines of a program."""
    lines = source.read_text().split("// BEGIN", 1)[1].split("// END", 1)[0] if source else "static double Run(int n) { return 0; }"
    indented = "".join(f"        {line}\n" for line in lines.strip("\n").splitlines())
    text = (f"katydid 1\ns = Script @{COMPONENT}(x = 1) variable -> A {{\n    ScriptSource = \"A = Run(1000000).ToString(\\\"R\\\");\"\n"
            f"    AdditionalSource = \"\"\"\n{indented}        \"\"\"\n}}\n")
    place = pathlib.Path(folder) / f"{name}.kd"
    place.write_text(text)
    return place


def members(katydid, folder):
    """Commands of the program over RhinoCommon's members, and those of the start alone."""
    source = FOLDER / "members.cs"
    ours = [katydid, "run", str(component("members", source, folder)), "--json"]
    own = [ours, ["mono", str(assembled(source, folder))], [sys.executable, str(FOLDER / "members.py")]]
    answer = float(printed(own[1]))
    if any(abs(float(printed(command)) - answer) > NEAR * answer for command in own[1:]):
        sys.exit("members: the answers differ")
    found = [float(number) for number in re.findall(r"-?\d+\.\d+(?:[eE][+-]?\d+)?", printed(ours))]
    if not any(abs(number - answer) <= NEAR * answer for number in found):
        sys.exit(f"members: {answer} is not among {found}")
    start = [katydid, "run", str(component("nothing", None, folder)), "--json"]
    return [("start of the whole program", [start, own[1][:1] + [str(pathlib.Path(folder) / "empty.exe")], [sys.executable, "-c", ""]]),
            ("members", own)]


def compared(ours, folder):
    """Commands of all programs; ends where two answers differ."""
    commands = []
    for name in NAMES:
        source = FOLDER / f"{name}.cs"
        own = [[ours, str(source)], ["mono", str(assembled(source, folder))], [sys.executable, str(FOLDER / f"{name}.py")]]
        # Mono writes numbers with other digits at times: they are compared as numbers.
        answers = [[float(word) for word in printed(command).split()] for command in own]
        if any(answer != answers[0] for answer in answers):
            sys.exit(f"{name}: the answers differ: {answers}")
        commands.append((name, own))
    return commands


def main():
    ours = sys.argv[1]
    katydid = next((word for word in sys.argv[2:] if not word.startswith("--")), None)
    runs = 5
    if "--counts" in sys.argv:
        for name in NAMES:
            command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", ours, str(FOLDER / f"{name}.cs")]
            text = subprocess.run(command, capture_output=True, text=True, check=True).stderr
            count = int(re.search(r"Collected : (\d+)", text)[1])
            print(f"| {name} | {count / 1e6:,.0f} million |", flush=True)
        return
    with tempfile.TemporaryDirectory() as folder:
        commands = compared(ours, folder)
        print("| program | Katydid | Mono | CPython | of Mono | of CPython |\n| --- | --- | --- | --- | --- | --- |")
        empty = pathlib.Path(folder) / "empty.cs"
        empty.write_text(EMPTY)
        nothing = pathlib.Path(folder) / "empty.py"
        nothing.write_text("")
        starts = [[ours, str(empty)], ["mono", str(assembled(empty, folder))], [sys.executable, str(nothing)]]
        more = members(katydid, folder) if katydid else []
        for name, own in [("start alone", starts), *commands, *more]:
            a, b, c = (seconds(command, runs) for command in own)
            print(f"| {name} | {a:.3f} s | {b:.3f} s | {c:.3f} s | {a / b:.1f} × | {a / c:.2f} × |", flush=True)


main()
