"""A compute server under attack, among clients that mean well.

    python attack/server.py target/release/katydid --minutes 60

First the clients that mean well are alone, then others do their worst. The server has 4 GB of address space. It must not
end, every answer to a client that means well must be right, and the slowest hundredth of them must not take more than
three times as long as without attack.
"""

import argparse
import base64
import http.client
import json
import multiprocessing
import os
import random
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

import components
from abuse import refused, slow
from definitions import texts
from serving import Remote, Serving

SERVE = ["serve", "--port", "0", "--timeout", "5", "--limit-bytes", 256 << 20, "--total-bytes", 1 << 30]
SERVE += ["--max-body", 16 << 20, "--cache-bytes", 128 << 20]
# As in deploy/: what is given back goes back to the system, and is not kept for each thread.
ALLOCATOR = {"MALLOC_ARENA_MAX": "2", "MALLOC_MMAP_THRESHOLD_": "1048576", "MALLOC_TRIM_THRESHOLD_": "1048576"}
MOST_TIMES = 3.0
# What clients that mean well have solved, and what must come out of it for a number.
HONEST = {
    "sum": (
        'katydid 1\na = Number Slider(2.0, 0..1000)\nsum = Addition(a, 3)\n"RH_IN:a": a\n"RH_OUT:x": sum\n',
        lambda a: a + 3,
    ),
    "circle": (
        "katydid 1\na = Number Slider(2.0, 0..1000)\nc = Circle(XY Plane(), a)\nl = Length(c)\n"
        '"RH_IN:a": a\n"RH_OUT:x": l\n',
        lambda a: 6.283185307179586 * a,
    ),
    "points": (
        "katydid 1\na = Number Slider(2.0, 0..1000)\ns = Series(0, a, 1000)\np = Construct Point(s, 0, 0)\n"
        'd = Distance(p, (0, 0, 0))\nm = Mass Addition(d)\n"RH_IN:a": a\n"RH_OUT:x": m\n',
        lambda a: 499_500 * a,
    ),
}


def packed(katydid, folder, name, text):
    """A definition as clients send it; nothing when it is none."""
    source, target = Path(folder) / f"{name}.kd", Path(folder) / f"{name}.gh"
    source.write_text(text)
    subprocess.run([katydid, "convert", source, target], capture_output=True, timeout=60)
    if not target.exists():
        return None
    data = target.read_bytes()
    target.unlink()
    return base64.b64encode(data).decode()


class Honest:
    """Clients that mean well, what they waited, and what was wrong."""

    def __init__(self, server, katydid, folder):
        self.server, self.waited, self.wrong = server, [], []
        self.algos = {name: packed(katydid, folder, name, text) for name, (text, _) in HONEST.items()}

    def ask(self, dice, who):
        name = dice.choice(list(HONEST))
        a = dice.randrange(1, 1000)
        value = {"ParamName": "RH_IN:a", "InnerTree": {"0": [{"data": a}]}}
        start = time.monotonic()
        try:
            code, answer = self.server.post(
                "/grasshopper", {"algo": self.algos[name], "values": [value]}, {"X-Forwarded-For": who}
            )
            self.waited.append(time.monotonic() - start)
            if code != 200:
                self.wrong.append(f"{name} of {a}: {code}, {answer[:300].decode(errors='replace')}")
                return
            item = next(iter(json.loads(answer)["values"][0]["InnerTree"].values()))[0]["data"]
            got, wanted = float(json.loads(item)), HONEST[name][1](a)
            if abs(got - wanted) > 1e-6 * wanted:
                self.wrong.append(f"{name} of {a}: {got} for {wanted}")
        except (OSError, http.client.HTTPException, ValueError, KeyError, IndexError, StopIteration) as error:
            self.wrong.append(f"{name} of {a}: {type(error).__name__} {error}")

    def for_seconds(self, seconds, clients=4):
        """Asks for a while; gives what was waited, in order."""
        self.waited = []
        end = time.monotonic() + seconds

        def one(number):
            dice = random.Random(number)
            while time.monotonic() < end and self.server.runs():
                self.ask(dice, f"10.0.0.{number}")
                time.sleep(0.02 + 0.1 * dice.random())

        threads = [threading.Thread(target=one, args=(number,)) for number in range(clients)]
        [thread.start() for thread in threads]
        [thread.join() for thread in threads]
        return sorted(self.waited)


class Watch(threading.Thread):
    """The most memory and address space that a server takes."""

    def __init__(self, server):
        super().__init__(daemon=True)
        self.server, self.most = server, {"VmRSS": 0.0, "VmSize": 0.0}

    def run(self):
        while self.server.runs():
            now = self.server.memory()
            self.most = {name: max(most, now.get(name, 0.0)) for name, most in self.most.items()}
            time.sleep(0.5)


def share(waited, part):
    return waited[min(len(waited) - 1, int(part * len(waited)))] if waited else float("nan")


def worst(katydid, folder, seed):
    """Definitions that are too large, too deep or too wild, as clients send them."""
    dice = random.Random(seed)
    listed = subprocess.run([katydid, "components", "--json"], capture_output=True, text=True, check=True)
    known = [c for c in json.loads(listed.stdout) if c["inputs"]]
    algos = []
    for number in range(150):
        text = components.definition(dice.choice(known), dice.choice(list(components.THEMES)), dice)
        text += '"RH_OUT:x": attacked\n'
        algos.append(packed(katydid, folder, f"attack{number}", text))
    for number, (_, text) in enumerate(texts()):
        if len(text) < 1_000_000:
            algos.append(packed(katydid, folder, f"large{number}", f"katydid 1\n{text}\n"))
    return [algo for algo in algos if algo]


class Attack:
    """Those who do their worst, in a process of their own, behind all others: they are other machines."""

    def __init__(self, server, algos):
        spawn = multiprocessing.get_context("spawn")
        self.stopped, self.told = spawn.Event(), spawn.Queue()
        self.process = spawn.Process(target=attack, args=(server.host, server.port, algos, self.stopped, self.told))
        self.sent, self.statuses = 0, {}

    def __enter__(self):
        self.process.start()
        return self

    def __exit__(self, *_):
        self.stopped.set()
        self.sent, self.statuses = self.told.get(timeout=120)
        self.process.join()


def attack(host, port, algos, stopped, told):
    os.nice(10)
    hostile = Hostile(Remote(host, port), algos, stopped)
    [thread.start() for thread in hostile.threads]
    stopped.wait()
    end = time.monotonic() + 60
    [thread.join(max(0.0, end - time.monotonic())) for thread in hostile.threads]
    told.put((hostile.sent, hostile.statuses))


class Hostile:
    """Each kind of those who do their worst, on a thread of its own."""

    def __init__(self, server, algos, stopped):
        self.server, self.stopped, self.sent, self.statuses = server, stopped, 0, {}
        self.algos = algos
        self.requests = [request for _, request in refused()]
        kinds = [self.solves] * 6 + [self.raws] * 2 + [self.leaves, self.jobs, self.slows]
        self.threads = [threading.Thread(target=kind, args=(random.Random(k),), daemon=True) for k, kind in enumerate(kinds)]

    def again(self):
        self.sent += 1
        return not self.stopped.is_set()

    def count(self, code):
        self.statuses[code] = self.statuses.get(code, 0) + 1

    def solves(self, dice):
        """Components with extreme inputs, as one machine of the network each."""
        who = f"10.1.0.{dice.randrange(250)}"
        while self.again():
            try:
                body = {"algo": dice.choice(self.algos), "values": []}
                self.count(self.server.post("/grasshopper", body, {"X-Forwarded-For": who})[0])
            except (OSError, http.client.HTTPException):
                self.count("broken off")
                time.sleep(0.1)

    def raws(self, dice):
        """Bytes that are no requests."""
        while self.again():
            self.server.raw(dice.choice(self.requests), 5)
            time.sleep(0.05)

    def leaves(self, dice):
        """Asks, and leaves or does not listen."""
        while self.again():
            try:
                body = json.dumps({"algo": dice.choice(self.algos), "values": []}).encode()
                connection = self.server.connect()
                head = f"POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nContent-Length: {len(body)}\r\n\r\n"
                connection.sendall(head.encode() + body)
                time.sleep(dice.choice([0, 0.1, 2]))
                connection.close()
            except OSError:
                time.sleep(0.1)

    def jobs(self, dice):
        """Work that nobody waits for."""
        while self.again():
            try:
                self.count(self.server.post("/jobs", {"algo": dice.choice(self.algos), "values": []})[0])
                time.sleep(1.0)
            except (OSError, http.client.HTTPException):
                time.sleep(0.5)

    def slows(self, dice):
        """Two hundred connections that do next to nothing."""
        while self.again():
            slow(self.server, 20)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("katydid")
    parser.add_argument("--minutes", type=float, default=60.0, help="of attack; a tenth of that before it is quiet")
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, Serving(args.katydid, SERVE, 4 << 30, ALLOCATOR) as server:
        watch = Watch(server)
        watch.start()
        honest = Honest(server, args.katydid, folder)
        hostile = Attack(server, worst(args.katydid, folder, args.seed))
        honest.for_seconds(5)
        quiet = honest.for_seconds(max(20.0, 6 * args.minutes))
        alone = len(honest.wrong)
        with hostile:
            attacked = honest.for_seconds(60 * args.minutes)
        is_well = server.is_well()
        most = watch.most
        times = share(attacked, 0.99) / share(quiet, 0.99)
        for what, waited in (("quiet", quiet), ("attacked", attacked)):
            parts = ", ".join(f"p{100 * p:g} {1e3 * share(waited, p):.1f} ms" for p in (0.5, 0.95, 0.99, 1.0))
            print(f"{what}: {len(waited)} answers, {parts}")
        print(f"hostile: {hostile.sent} requests, answers by status {hostile.statuses}")
        print(f"p99 {times:.2f} times quiet; {len(honest.wrong)} of them wrong ({alone} while quiet); {most['VmRSS']:.0f} MB, {most['VmSize']:.0f} MB of addresses")
        for wrong in honest.wrong[:10]:
            print("wrong:", wrong)
        if not server.runs():
            print("the server ended:", server.said[-1000:].decode(errors="replace"))
        return 0 if is_well and not honest.wrong and times <= MOST_TIMES else 1


if __name__ == "__main__":
    sys.exit(main())
