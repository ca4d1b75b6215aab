#!/usr/bin/env python3
"""Many clients at a time on a compute server of this machine, each answer compared with what `katydid run` says.

usage: compute_load.py BINARY LOAD [--clients 64] [--solves 10000] [--definitions 50]

LOAD is the client: `cargo build --release -p katydid-server --example compute_load`.

Starts the server itself. Prints one line a measure; the exit code is 1 when an answer was wrong.
"""

import argparse
import base64
import json
import os
import subprocess
import sys
import tempfile
import time
import urllib.request
from concurrent.futures import ThreadPoolExecutor

KINDS = [
    "x = Addition(a, {n})\n",
    "x = Multiplication(a, {n})\n",
    "s = Series(a, {n}, 20)\nx = Mass Addition(s)\n",
    "r = Range(0 to a, {n})\nx = Sine(r)\n",
    "c = Circle(XY Plane(), a)\nx = Length(c)\n",
    "p = Construct Point(a, {n}, 0)\nq = Construct Point(0, a, {n})\nx = Distance(p, q)\n",
    "c = Circle(XY Plane(), a)\nd = Divide Curve(c, {n})\nx = Deconstruct(d.Points)\n",
    "s = Series(0, 1, 100)\ne = Expression(\"sin(x) * {n}\", x = s)\nx = Multiplication(e, a)\n",
]
INPUTS = [1, 2.5, 3, 4.25, 7]


def definition(n):
    kind = KINDS[n % len(KINDS)].format(n=n + 2)
    return f'katydid 1\na = Number Slider(1.0, 0..100)\n{kind}"RH_IN:a": a\n"RH_OUT:x": x\n'


def prepared(binary, folder, n, inputs):
    """A definition in base64, and what it gives by `katydid run`, for each input."""
    kd, gh = f"{folder}/{n}.kd", f"{folder}/{n}.gh"
    with open(kd, "w") as file:
        file.write(definition(n))
    subprocess.run([binary, "convert", kd, gh], check=True, capture_output=True)
    expected = []
    for value in inputs:
        done = subprocess.run([binary, "run", gh, "--set", f"RH_IN:a={value}", "--json=values"], check=True, capture_output=True, text=True)
        expected.append(outputs(json.loads(done.stdout)))
    with open(gh, "rb") as file:
        return base64.b64encode(file.read()).decode(), expected


def outputs(report):
    """The numbers of the object called x, whichever of its outputs comes first."""
    [of_x] = [one for one in report["objects"] if one["nickname"] == "x"][:1] or [report["objects"][-2]]
    return [[float(item) if not isinstance(item, dict) else item for item in branch["items"]] for branch in of_x["outputs"][0]["branches"]]


def resident(pid):
    with open(f"/proc/{pid}/statm") as file:
        return int(file.read().split()[1]) * 4096


def main():
    words = argparse.ArgumentParser()
    words.add_argument("binary")
    words.add_argument("load")
    words.add_argument("--clients", type=int, default=64)
    words.add_argument("--solves", type=int, default=10000)
    words.add_argument("--definitions", type=int, default=50)
    words = words.parse_args()
    binary = os.path.abspath(words.binary)
    with tempfile.TemporaryDirectory() as folder:
        with ThreadPoolExecutor(2) as pool:
            cases = list(pool.map(lambda n: prepared(binary, folder, n, INPUTS), range(words.definitions)))
        begin = time.perf_counter()
        server = subprocess.Popen([binary, "serve", "--port", "0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
        host = server.stdout.readline().strip().removeprefix("http://").rstrip("/")
        urllib.request.urlopen(f"http://{host}/version").read()
        print(f"ready after {(time.perf_counter() - begin) * 1e3:.1f} ms")
        try:
            sys.exit(measure(host, server.pid, cases, words, folder))
        finally:
            server.terminate()
            server.wait()


def measure(host, pid, cases, words, folder):
    made = []
    for algo, expected in cases:
        for value, branches in zip(INPUTS, expected):
            values = [{"ParamName": "RH_IN:a", "InnerTree": {"0": [{"data": value}]}}]
            made.append({"body": json.dumps({"algo": algo, "pointer": None, "values": values}), "expected": branches})
    path = f"{folder}/cases.json"
    with open(path, "w") as file:
        json.dump(made, file)

    def load(clients, solves):
        done = subprocess.run([words.load, host, path, str(clients), str(solves)], check=True, capture_output=True, text=True)
        return json.loads(done.stdout)

    load(1, 500)
    one = load(1, min(words.solves, 3000))
    print(f"beyond the solve: median {one['beyond_median_ms']:.3f} ms, 95th percentile {one['beyond_p95_ms']:.3f} ms")
    print(f"one client: {one['rate']:.0f} solves/s, median {one['median_ms']:.3f} ms, wrong: {one['wrong']}")
    memory, wrong = [resident(pid)], one["wrong"]
    for _ in range(3):
        many = load(words.clients, words.solves)
        memory.append(resident(pid))
        wrong += many["wrong"]
        print(
            f"{words.clients} clients, {many['solves']} solves: {many['rate']:.0f} solves/s ({many['rate'] / one['rate']:.2f} x), "
            f"median {many['median_ms']:.2f} ms, 99th percentile {many['p99_ms']:.1f} ms, wrong: {many['wrong']}"
        )
    print(f"memory in MB: {[size >> 20 for size in memory]}: {(memory[-1] / memory[-2] - 1) * 100:+.1f} % in the last round")
    return 1 if wrong else 0


if __name__ == "__main__":
    main()
