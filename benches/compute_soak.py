#!/usr/bin/env python3
"""A compute server of this machine for half an hour among clients of every sort.

usage: compute_soak.py BINARY LOAD [--clients 64] [--seconds 1800] [--definitions 50] [--allocator deploy|default]

`--allocator default` leaves the settings of the allocator as the system has them, in place of those in deploy/.

LOAD is the client: `cargo build --release -p katydid-server --example compute_load`.

Most turns ask and wait, and each answer is compared with what `katydid run` says. The others leave a solve that runs, go in
the middle of a request, send what is no request, too much or too slowly, have jobs done, cancel them, and refuse the cache.
Prints one line a measure. The exit code is 1 when an answer was wrong or missing, memory has grown by more than 3 % since
the warm-up, a file descriptor was lost, or the server did not become idle and healthy.
"""

import argparse
import base64
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
from concurrent.futures import ThreadPoolExecutor

from compute_load import INPUTS, prepared, resident

# A megabyte of body is too much, so that what is too much is said quickly.
SERVE = ["serve", "--port", "0", "--max-body", str(1 << 20), "--timeout", "20", "--keep-jobs", "60"]
# As in deploy/: what is given back goes back to the system, and is not kept for each thread.
ALLOCATOR = {"MALLOC_ARENA_MAX": "2", "MALLOC_MMAP_THRESHOLD_": "1048576", "MALLOC_TRIM_THRESHOLD_": "1048576"}
# A formula that may give a text, so that it is worked out item by item: minutes of work.
SLOW = 'Expression("if(x > -1e9, sin(x) * cos(x) + sqrt(abs(x)), \\"\\")", x = {})'
# The part of the time that is warm-up, the least seconds of it in a short run, but no more than this part of it (results of jobs
# are kept for 60, and the allocator's arenas are full after three minutes), and the part at either end of the rest that is
# compared.
WARM, LEAST, MOST, END = 0.2, 180, 0.6, 0.1
MOST_GROWTH = 3.0


def endless(binary, folder):
    """The body of a request that nobody waits for."""
    lines = ["katydid 1", "n = Number Slider(400000.0, 0..900000)", "s = Series(0, 1, n)"]
    last = "s"
    for k in range(400):
        lines.append(f"e{k} = {SLOW.format(last)}")
        last = f"e{k}"
    lines += ['"RH_IN:n": n', f'"RH_OUT:end": {last}', ""]
    kd, gh = f"{folder}/endless.kd", f"{folder}/endless.gh"
    with open(kd, "w") as file:
        file.write("\n".join(lines))
    subprocess.run([binary, "convert", kd, gh], check=True, capture_output=True)
    with open(gh, "rb") as file:
        return json.dumps({"algo": base64.b64encode(file.read()).decode(), "values": []})


class Server:
    """The two processes of `katydid serve`."""

    def __init__(self, binary, allocator):
        settings = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL, "env": {**os.environ, **allocator}}
        self.process = subprocess.Popen([binary, *SERVE], text=True, **settings)
        self.host = self.process.stdout.readline().strip().removeprefix("http://").rstrip("/")

    def pids(self):
        pid, children = self.process.pid, []
        for task in os.listdir(f"/proc/{pid}/task"):
            with open(f"/proc/{pid}/task/{task}/children") as file:
                children += [int(child) for child in file.read().split()]
        return [pid, *children]

    def memory(self):
        return sum(resident(pid) for pid in self.pids())

    def descriptors(self):
        return sum(len(os.listdir(f"/proc/{pid}/fd")) for pid in self.pids())

    def ask(self, method, path, body=None):
        request = urllib.request.Request(f"http://{self.host}{path}", data=body, method=method)
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return answer.read().decode()
        except urllib.error.HTTPError as refused:
            return refused.read().decode()

    def works(self):
        """Whether anything runs or waits, or was given up and is not back."""
        parts = ("katydid_solves_running ", "katydid_solves_waiting ", "katydid_threads_lost ")
        page = self.ask("GET", "/metrics").splitlines()
        return any(float(line.rsplit(" ", 1)[1]) for line in page if line.startswith(parts))

    def computed(self):
        """The milliseconds of processor time that each solving thread has had."""
        times = {}
        for pid in self.pids():
            for thread in os.listdir(f"/proc/{pid}/task"):
                try:
                    with open(f"/proc/{pid}/task/{thread}/comm") as name, open(f"/proc/{pid}/task/{thread}/schedstat") as had:
                        if name.read().startswith("solve"):
                            times[thread] = int(had.read().split()[0]) / 1e6
                except OSError:
                    continue  # It has ended meanwhile.
        return times

    def end(self):
        self.process.terminate()
        self.process.wait()


def until(is_so, seconds):
    """Waits until something is so; whether it is."""
    end = time.monotonic() + seconds
    while not is_so():
        if time.monotonic() > end:
            return False
        time.sleep(0.005)
    return True


def cancelled(server, body):
    """The milliseconds from the cancellation of a job until nothing runs any more, not even what was given up; and how much
    of a processor the thread that took most has had meanwhile: where other programs want all processors, work that has a
    lower priority waits for its turn to end, and holds none."""
    times, computed = [], []
    for _ in range(20):
        place = "/jobs/" + json.loads(server.ask("POST", "/jobs", body))["id"]
        until(lambda: json.loads(server.ask("GET", place))["state"] == "running", 30)
        time.sleep(0.3)
        before, begin = server.computed(), time.perf_counter()
        server.ask("DELETE", place)
        until(lambda: not server.works(), 30)
        times.append((time.perf_counter() - begin) * 1e3)
        after = server.computed()
        computed.append(max((after[thread] - before.get(thread, 0) for thread in after), default=0))
    return sorted(times), sorted(computed)


def run(server, load, folder, cases, body, words):
    """The report of the clients, and the memory over the time."""
    paths = f"{folder}/cases.json", f"{folder}/endless.json"
    for path, text in zip(paths, (json.dumps(cases), body)):
        with open(path, "w") as file:
            file.write(text)
    command = [load, "soak", server.host, paths[0], str(words.clients), str(words.seconds), paths[1]]
    clients = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    begin, memory = time.monotonic(), []
    step = min(5.0, words.seconds / 60)
    while clients.poll() is None:
        memory.append((time.monotonic() - begin, server.memory()))
        time.sleep(step)
    if clients.returncode:
        sys.exit("the clients failed")
    return json.loads(clients.stdout.read()), memory


def growth(memory, seconds):
    """Megabytes after the warm-up and at the end, and the growth in percent."""
    def mean(start, end):
        return statistics.mean(size for at, size in memory if start * seconds <= at <= end * seconds) / (1 << 20)
    warm = max(WARM, min(LEAST / seconds, MOST))
    early, late = mean(warm, warm + END), mean(1 - END, 1.0)
    return early, late, (late / early - 1) * 100, [mean(tenth / 10, (tenth + 1) / 10) for tenth in range(10)]


def report(seen, memory, words):
    """Prints what the clients saw; gives what was not as it should be."""
    faults = 0
    p50, p95, p99, p999, most = seen["p50_p95_p99_p999_most_ms"]
    print(f"{words.clients} clients, {seen['seconds']:.0f} s: {seen['solves']} solves, {seen['rate']:.0f} a second")
    print(f"latency in ms: median {p50:.1f}, 95 %: {p95:.1f}, 99 %: {p99:.1f}, 99.9 %: {p999:.1f}, most {most:.0f}")
    for name, turn in sorted(seen["turns"].items()):
        first = f", first: {turn['first']}" if turn["first"] else ""
        print(f"{name}: {turn['right']} right, {turn['wrong']} wrong, {turn['refused']} refused, {turn['broken']} unanswered{first}")
        faults += turn["wrong"] + turn["broken"]
    early, late, grown, course = growth(memory, words.seconds)
    print(f"memory: {early:.1f} MB after warm-up, {late:.1f} MB at the end, {grown:+.1f} %")
    print("memory by tenths of the time: " + ", ".join(f"{size:.1f}" for size in course) + " MB")
    return faults + (grown > MOST_GROWTH)


def main():
    words = argparse.ArgumentParser()
    words.add_argument("binary")
    words.add_argument("load")
    words.add_argument("--clients", type=int, default=64)
    words.add_argument("--seconds", type=float, default=1800)
    words.add_argument("--definitions", type=int, default=50)
    words.add_argument("--allocator", choices=["deploy", "default"], default="deploy")
    words = words.parse_args()
    binary = os.path.abspath(words.binary)
    with tempfile.TemporaryDirectory() as folder:
        with ThreadPoolExecutor(2) as pool:
            known = list(pool.map(lambda n: prepared(binary, folder, n, INPUTS), range(words.definitions)))
        cases = []
        for algo, expected in known:
            for value, branches in zip(INPUTS, expected):
                values = [{"ParamName": "RH_IN:a", "InnerTree": {"0": [{"data": value}]}}]
                cases.append({"body": json.dumps({"algo": algo, "values": values}), "expected": branches})
        body = endless(binary, folder)
        server = Server(binary, ALLOCATOR if words.allocator == "deploy" else {})
        try:
            sys.exit(1 if measure(server, words, folder, cases, body) else 0)
        finally:
            server.end()


def measure(server, words, folder, cases, body):
    until(lambda: server.ask("GET", "/healthcheck") == "Healthy", 30)
    server.ask("POST", "/grasshopper", cases[0]["body"].encode())
    first = server.descriptors()
    times, computed = cancelled(server, body.encode())
    print(f"cancelled until free: median {statistics.median(times):.1f} ms, most {times[-1]:.1f} ms")
    print(f"computed after that: median {statistics.median(computed):.1f} ms, most {computed[-1]:.1f} ms")
    pids = server.pids()
    seen, memory = run(server, words.load, folder, cases, body, words)
    faults = report(seen, memory, words)
    idle = until(lambda: not server.works(), 30)
    # Connections between the two processes are kept for a minute and a half.
    closed = until(lambda: server.descriptors() <= first, 150)
    print(f"file descriptors: {first} at the start, {server.descriptors()} at the end")
    health = server.ask("GET", "/healthcheck")
    same = server.pids() == pids
    print(f"at the end: {'idle' if idle else 'NOT IDLE'}, {health}, {'the same two processes' if same else 'ANOTHER PROCESS'}")
    return faults + (not idle) + (not closed) + (health != "Healthy") + (not same)


if __name__ == "__main__":
    main()
