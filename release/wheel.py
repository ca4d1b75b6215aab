"""The wheel of the Python package, for every Python from 3.9 on."""

import os
import re
import shutil
import sys
from pathlib import Path

from place import OUT, PROFILE, ROOT, Missing, run

#: maturin names the oldest system that the wheel runs on after looking at its symbols: a bare `linux` says that it did not.
TAGS = r"-cp39-abi3-(manylinux_\d+_\d+|manylinux\d+|macosx_\d+_\d+|win)(_|\.|$)"


def make():
    """Builds it with its licences, and checks its tag."""
    given = os.environ.get("KATYDID_WHEEL")
    tools = ROOT / ".venv-packages"
    folder = ROOT / "target" / "wheel"
    if given:
        found = [Path(given)]
    else:
        shutil.rmtree(folder, ignore_errors=True)
        run(sys.executable, "-m", "venv", tools)
        python = tools / ("Scripts" if sys.platform == "win32" else "bin") / "python"
        run(python, "-m", "pip", "install", "-q", "maturin>=1.9,<2")
        run(sys.executable, "python/third_party.py")
        run(python, "-m", "maturin", "build", "--locked", "--profile", PROFILE, "--out", folder, cwd=ROOT / "python")
        found = list(folder.glob("*.whl"))
    if len(found) != 1:
        raise Missing(f"{len(found)} wheels in {folder}")
    if not re.search(TAGS, found[0].name):
        raise SystemExit(f"{found[0].name}: its tag promises no system")
    return [Path(shutil.copy(found[0], OUT))]
