"""The programs under test. Nothing is built here: variables name what is tested, and `make` builds it and sets them."""

import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def named(variable, like):
    """The absolute path that a variable of the environment holds."""
    value = os.environ.get(variable)
    if not value:
        raise RuntimeError(
            f"{variable} is not set. It names what is tested, as in {variable}={like}; nothing is built behind your back. "
            "`make test-python`, `make test-step` and `make test-compute` build it and set it."
        )
    return os.path.abspath(value)


def binary():
    """The command line program, which `KATYDID` names."""
    return named("KATYDID", "target/debug/katydid")


def example(name):
    """An example program of one of the crates; `KATYDID_EXAMPLES` names their folder."""
    return os.path.join(named("KATYDID_EXAMPLES", "target/debug/examples"), name)


def katydid(*words):
    command = [binary(), *map(str, words)]
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
