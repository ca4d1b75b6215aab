"""Runs a program, and measures from outside what it took."""

import os
import resource
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass

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


def limited():
    resource.setrlimit(resource.RLIMIT_AS, (MOST_ADDRESSES, MOST_ADDRESSES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(command, hangs=HANGS):
    """Runs a command to its end, its output thrown away; gives what it took."""
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen(
            command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=said, preexec_fn=limited
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
