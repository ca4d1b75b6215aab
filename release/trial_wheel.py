"""The wheel in a fresh environment, with the README's lines of Python as they stand there."""

import re
import subprocess
import sys
from pathlib import Path

import expected
from place import ROOT, only, told

#: What the README's lines leave: the radii, and what was written.
AFTER = """
import pathlib, sys
print([circle.length / 6.283185307179586 for circle in r["Circles"].flat()])
assert pathlib.Path("attractor.3dm").stat().st_size > 1000
assert "site-packages" in katydid.__file__, katydid.__file__
"""


def run(folder):
    """Installs it alone, without any index, and compares the radii."""
    told(sys.executable, "-m", "venv", folder / "venv")
    python = folder / "venv" / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
    told(python, "-m", "pip", "install", "-q", "--no-index", only("*.whl"))
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    lines = re.search(r"^```python\n(.*?)^```", text, flags=re.M | re.S).group(1)
    work = folder / "work"
    (work / "examples").mkdir(parents=True)
    (work / "examples/attractor.ghx").write_bytes((ROOT / "examples/attractor.ghx").read_bytes())
    (work / "readme.py").write_text(lines + AFTER, encoding="utf-8")
    done = subprocess.run([python, "-I", "readme.py"], cwd=work, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise RuntimeError(done.stderr.strip())
    found = [float(word) for word in re.findall(r"[\d.e-]+", done.stdout.strip().splitlines()[-1])]
    wrong = expected.compare(found, columns=20, at=(80.0, 55.0))
    if wrong:
        raise RuntimeError(wrong)
    licences = list(Path(folder, "venv").rglob("katydid/THIRD-PARTY"))
    if not licences or not licences[0].stat().st_size:
        raise RuntimeError("no THIRD-PARTY in it")
    return "the README's lines of Python; 210 radii are those of the formula"
