"""Ends that come too early: signals, and disks that are full.

    python attack/ends.py target/release/katydid

A file that is written is there whole or not at all, what cannot be written is an error, and a server ends when it is
told.
"""

import os
import random
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import seeds
from bounded import Bounds, alone, run
from serving import Serving

BOUNDS = Bounds(512, 20.0, (1, 2))
# Enough to be written for a while.
MANY = "katydid 1\nx = Series(0, 1, 30000)\np = Construct Point(x, x, x)\nl = Line(p, (0, 0, 0))\nm = Mesh Sphere(XY Plane(), 1, 30, 30)\n"


def full(katydid, found, folder):
    """What is printed to a full disk, and files that cannot grow."""
    definition = Path(folder) / "many.kd"
    definition.write_text(MANY)
    model = Path(folder) / "many.3dm"
    run([katydid, "run", str(definition), "-o", str(model)])
    printing = [
        ["run", definition, "--json"],
        ["check", definition],
        ["check", definition, "--json"],
        ["info", model],
        ["info", model, "--json"],
        ["components"],
        ["diff", definition, definition, "--json"],
        ["serve", "--port", "0"],
        ["studio", definition, "--port", "0", "--no-open"],
    ]
    for words in printing:
        with open("/dev/full", "wb") as disk:
            outcome = run([katydid, *map(str, words)], 20, stdout=disk)
        found.note(f"{words[0]} to a full disk", BOUNDS.fault(outcome))
    for suffix in seeds.WRITTEN:
        target = Path(folder) / f"short.{suffix}"
        if suffix in ("gh", "ghx"):
            words = ["convert", definition, target]
        else:
            words = ["run", definition, "-o", target]
        kept = b"what was there before"
        target.write_bytes(kept)
        # The archives of definitions are small.
        outcome = run([katydid, *map(str, words)], file_bytes=600)
        wrong = BOUNDS.fault(outcome)
        if wrong is None and target.read_bytes() != kept:
            wrong = "the file that was there is damaged"
        left = [p.name for p in Path(folder).iterdir() if p.name.startswith(".") or p.name.endswith(".tmp")]
        found.note(f"{suffix} that cannot grow", wrong or (f"leaves {left}" if left else None))
        target.unlink()


def killed(katydid, found, folder, end):
    """Writing, ended at any moment."""
    definition, target = Path(folder) / "many.kd", Path(folder) / "killed.3dm"
    definition.write_text(MANY)
    words = [katydid, "run", str(definition), "-o", str(target)]
    start = time.monotonic()
    subprocess.run(words, capture_output=True, check=True)
    whole, took = target.read_bytes(), time.monotonic() - start
    dice = random.Random(4)
    for number in range(60):
        if time.monotonic() > end:
            return
        before = dice.choice([None, b"what was there before"])
        target.unlink(missing_ok=True)
        if before:
            target.write_bytes(before)
        process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(dice.random() * took)
        process.send_signal(dice.choice([signal.SIGKILL, signal.SIGTERM]))
        process.wait()
        now = target.read_bytes() if target.exists() else None
        # Two runs may differ in the time that they note: the length is the same.
        is_whole = now is not None and now[:4] == whole[:4] and abs(len(now) - len(whole)) <= 64
        found.note(f"writing, killed {number}", None if now == before or is_whole else "the file is there in part")
        for left in Path(folder).glob(".*"):
            left.unlink()


def told(katydid, found, folder, end):
    """Servers that are told to end, and that are killed and started again on their port."""
    for number in range(6):
        if time.monotonic() > end:
            return
        with Serving(katydid, ["serve", "--port", "0", "--grace", "2"]) as server:
            server.is_well()
            waiting = [server.connect() for _ in range(20)]
            for connection in waiting[:10]:
                connection.sendall(b"POST /grasshopper HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100\r\n\r\n{")
            start = time.monotonic()
            server.process.send_signal(signal.SIGTERM)
            if number % 2:
                time.sleep(0.2)
                server.process.send_signal(signal.SIGTERM)
            try:
                code = server.process.wait(15)
                late = time.monotonic() - start > 10
                wrong = f"ended with {code}" if code not in (0, 143) else "took long to end" if late else None
            except subprocess.TimeoutExpired:
                wrong = "does not end"
            found.note(f"server told to end {number}", wrong)
            for connection in waiting:
                connection.close()
    with Serving(katydid, ["serve", "--port", "0"]) as server:
        server.process.kill()
        server.process.wait()
        port = server.port
    with Serving(katydid, ["serve", "--port", port]) as server:
        found.note("server after a kill", None if server.is_well() else "does not start again on its port")


def attack(katydid, found, seconds=None):
    """All of them, within the time that there is."""
    end = time.monotonic() + (seconds or 300.0)
    with tempfile.TemporaryDirectory() as folder:
        if os.path.exists("/dev/full"):
            full(katydid, found, folder)
        told(katydid, found, folder, end)
        killed(katydid, found, folder, end)


if __name__ == "__main__":
    sys.exit(alone("ends", __doc__, attack))
