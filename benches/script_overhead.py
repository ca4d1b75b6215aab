"""What a Python script component costs beyond its script: `python benches/script_overhead.py PROGRAM`.

Makes two definitions, runs each five times with `katydid run --allow-scripts`, and reads what each object took. Thirty
components with one script of 13 lines, which say themselves how long their lines took: all but the first find a warm
process. Eleven components that take 10,000 points and give them back, one after the other: side by side they would wait for
the one process, and the wait would count as theirs.
"""

import json
import os
import subprocess
import sys
import tempfile

RUNS = 5
GH_PYTHON = "410755b1-224a-4c1e-a407-bf32fb45ea7e"
LINES = ["import time", "t = time.perf_counter()", "s = 0", "for i in range(10):", "    s += i * x", "b = s / 2", "c = b + 1",
         "d = c * c", "e = [d, c]", "f = len(e)", "g = f + s", "h = g", "a = (time.perf_counter() - t) * 1000"]


def component(name, inputs, code, more=""):
    return "%s = `GhPython Script` @%s(%s) variable -> out, a {\n    CodeInput = %s\n%s}" % (
        name, GH_PYTHON, inputs, json.dumps(code), more)


def small():
    return ["katydid 1"] + [component("s%d" % k, "x = %d" % k, "\n".join(LINES)) for k in range(30)]


def points():
    a_list = "    ParameterData/InputParam[0]/ScriptParamAccess = 1\n" \
             "    ParameterData/InputParam[0]/TypeHintID = @e1937b56-b1da-4c12-8bd8-e34ee81746ef\n"
    return ["katydid 1", "n = Series(0, 1, 10000)", "p = Construct Point(n, n, 0)"] + \
        [component("q%d" % k, "pts = p", "a = list(pts)", a_list) for k in range(11)]


def objects(program, lines):
    """The script components of a run: their milliseconds, and the items of their output."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "bench.kd")
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")
        ran = subprocess.run([program, "run", path, "--allow-scripts", "--json=values", "--threads", "1"],
                             stdout=subprocess.PIPE, check=True)
    for thing in json.loads(ran.stdout)["objects"]:
        if thing["component"] == GH_PYTHON:
            yield thing["milliseconds"], thing["outputs"][1]["branches"][0]["items"]


def told(what, times):
    times.sort()
    print("%s: least %.2f, median %.2f, most %.2f ms of %d" % (what, times[0], times[len(times) // 2], times[-1], len(times)))


def main():
    program = sys.argv[1]
    beyond, through = [], []
    for _ in range(RUNS):
        beyond += [took - own[0] for took, own in list(objects(program, small()))[1:]]
        for took, given in list(objects(program, points()))[1:]:
            assert len(given) == 10000
            through.append(took)
    told("a warm call of 13 lines, beyond the script", beyond)
    told("10,000 points in and out", through)


if __name__ == "__main__":
    main()
