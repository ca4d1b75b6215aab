"""Where things lie, and how commands are run."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TARGET = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")).resolve()
#: Where packages go, wherever cargo's own files are.
OUT = ROOT / "target" / "packages"
VERSION = re.search(r'^version = "(.*)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), flags=re.M).group(1)
#: What is published is optimised in one piece, which takes long.
PROFILE = os.environ.get("KATYDID_PROFILE", "dist")
EXE = ".exe" if sys.platform == "win32" else ""


class Missing(Exception):
    """A step that cannot be done here, with the reason and what would help."""


def run(*words, **options):
    """Runs a command, and ends with its words where it fails."""
    print("+", *words, flush=True)
    subprocess.run([str(word) for word in words], check=True, **{"cwd": ROOT, **options})


def told(*words, **options):
    """What a command prints."""
    done = subprocess.run([str(word) for word in words], check=True, stdout=subprocess.PIPE, text=True,
                          encoding="utf-8", **{"cwd": ROOT, **options})
    return done.stdout


def needed(tool, why):
    """Where a tool is; a step that needs it is left out without."""
    found = shutil.which(tool)
    if not found:
        raise Missing(f"{tool} is not installed: {why}")
    return found


def triple():
    """The system that programs are built for, in Rust's words."""
    return re.search(r"^host: (.*)$", told("rustc", "-vV"), flags=re.M).group(1)


def date():
    """The time of the last commit, in seconds: packages of one commit have the same bytes."""
    if "SOURCE_DATE_EPOCH" in os.environ:
        return int(os.environ["SOURCE_DATE_EPOCH"])
    return int(told("git", "log", "-1", "--format=%ct").strip())

def only(pattern):
    """The one package that a pattern names."""
    found = sorted(OUT.glob(pattern))
    if not found:
        raise Missing(f"there is no {pattern} in {OUT}")
    if len(found) > 1:
        raise RuntimeError(f"several: {', '.join(file.name for file in found)}; empty {OUT} and make them anew")
    return found[0]
