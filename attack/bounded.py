"""Runs a program, and measures from outside what it took."""

import argparse
import os
import resource
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path

# How long a run may take on the clock before it is ended: it hangs, or waits for something.
HANGS = 60.0
# Nothing that is attacked may bring the machine down with it.
MOST_ADDRESSES = 4 << 30


@dataclass
class Outcome:
    """What a run did: its exit code (below 0: the signal that ended it), megabytes at most, seconds of processor time."""

    code: int
    megabytes: float
    seconds: float
    hung: bool
    said: str


def limited(file_bytes=None):
    resource.setrlimit(resource.RLIMIT_AS, (MOST_ADDRESSES, MOST_ADDRESSES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    if file_bytes is not None:
        resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, file_bytes))


def run(command, hangs=HANGS, stdout=subprocess.DEVNULL, file_bytes=None):
    """Runs a command to its end, its output thrown away; gives what it took. With `file_bytes` no file that it writes
    may grow longer."""
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=stdout,
            stderr=said,
            preexec_fn=lambda: limited(file_bytes),
            # Writing beyond a limit is an error then, and not the end.
            restore_signals=False,
        )
        end = time.monotonic() + hangs
        pause = 0.001
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                break
            if time.monotonic() > end:
                process.send_signal(signal.SIGKILL)
                _, status, usage = os.wait4(process.pid, 0)
                break
            time.sleep(pause)
            pause = min(2 * pause, 0.02)
        hung = time.monotonic() > end
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        text = said.read(100_000).decode(errors="replace")
    return Outcome(
        process.returncode, usage.ru_maxrss / 1024, usage.ru_utime + usage.ru_stime, hung, text
    )


@dataclass
class Bounds:
    """What a run may take, and the exit codes that are answers."""

    megabytes: float
    seconds: float
    codes: tuple = (0, 1, 2)

    def fault(self, outcome):
        """What is wrong with a run, if anything."""
        if outcome.hung:
            return "hangs"
        if outcome.code not in self.codes:
            last = outcome.said.strip().splitlines()[-1:] or [""]
            return f"ends with {outcome.code}: {last[0][:200]}"
        if "panicked at" in outcome.said:
            return f"panics: {outcome.said[:200]}"
        if outcome.megabytes > self.megabytes:
            return f"takes {outcome.megabytes:.0f} MB"
        if outcome.seconds > self.seconds:
            return f"takes {outcome.seconds:.1f} s of processor time"
        return None


class Found:
    """The faults of an attack; what caused them is kept in a folder, if there is one."""

    def __init__(self, keep=None):
        self.keep, self.runs, self.faults = keep, 0, []

    def note(self, name, wrong, cause=b"", suffix=".txt"):
        """Counts a run, and its fault if it has one."""
        self.runs += 1
        if wrong is None:
            return
        self.faults.append((name, wrong))
        print(f"{name}: {wrong}", flush=True)
        if self.keep:
            self.keep.mkdir(parents=True, exist_ok=True)
            safe = "".join(c if c.isalnum() else "_" for c in name)[:100]
            (self.keep / f"{safe}{suffix}").write_bytes(cause)

    def tell(self, what):
        """The last line; the exit code."""
        print(f"{what}: {self.runs} runs, {len(self.faults)} faults", flush=True)
        return 1 if self.faults or not self.runs else 0


def alone(what, about, attack, add=lambda parser: None, more=()):
    """Runs one attack by itself, with what its command line says; gives the exit code. `add` makes further options, which
    go to the attack by the names in `more`."""
    parser = argparse.ArgumentParser(description=about, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("katydid")
    parser.add_argument("--seconds", type=float, help="stop after so long; the order is then by chance")
    parser.add_argument("--keep", type=Path, help="a folder for what failed")
    add(parser)
    args = parser.parse_args()
    found = Found(args.keep)
    attack(args.katydid, found, args.seconds, *(getattr(args, name) for name in more))
    return found.tell(what)
