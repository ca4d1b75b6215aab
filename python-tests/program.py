"""The program under test: what `KATYDID` names, or else a release build of this checkout."""

import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def katydid(*words):
    command = os.environ.get("KATYDID")
    command = [command] if command else ["cargo", "run", "--release", "-q", "-p", "katydid", "--"]
    return subprocess.run([*command, *map(str, words)], cwd=ROOT, check=True, capture_output=True, text=True)
