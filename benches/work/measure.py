"""Runs a command to its end, and gives what it took, as the system counts it."""

import os
import subprocess
import tempfile
from dataclasses import dataclass


class Failed(Exception):
    """A run did not end as it should, with the first line of what it said."""


@dataclass
class Taken:
    """Seconds of processor time, user and system, and the most memory held at once, in MB of a million bytes."""

    seconds: float
    megabytes: float


def run(command):
    """Runs a command once, its output thrown away.

    The system counts the memory of the process that starts another as that of the other until its program is loaded, so
    this must be called from a small process: nothing in this folder but the peers and the answers loads much.
    """
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=said)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        text = said.read(100_000).decode(errors="replace")
    if process.returncode != 0:
        raise Failed(f"ends with {process.returncode}: {(text.strip() or '-').splitlines()[0]}")
    return Taken(usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024 / 1e6)


def least(command, times):
    """The least seconds and the least memory of several runs: what other work on the machine adds is never negative."""
    runs = [run(command) for _ in range(times)]
    return Taken(min(one.seconds for one in runs), min(one.megabytes for one in runs))
