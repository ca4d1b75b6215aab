"""The program, and what it writes for a system's packages."""

import os
import shutil
from pathlib import Path

from place import EXE, PROFILE, ROOT, TARGET, Missing, run

#: Folders of the profiles below cargo's target.
FOLDERS = {"dev": "debug"}
#: The manual pages and completions, beside the packages.
BESIDE = ROOT / "target" / "beside"
SHELLS = {"bash": "katydid.bash", "zsh": "_katydid", "fish": "katydid.fish", "powershell": "katydid.ps1"}


def built():
    """Where the program is, or will be."""
    given = os.environ.get("KATYDID_PROGRAM")
    return Path(given).resolve() if given else TARGET / FOLDERS.get(PROFILE, PROFILE) / f"katydid{EXE}"


def made():
    """The program; the step `program` builds it."""
    if not built().exists():
        raise Missing(f"{built()} is not there: run the step `program` first")
    return built()


def make():
    """Builds the program, and has it write its manual pages and completions."""
    if not (ROOT / "studio" / "dist" / "index.html").exists():
        raise Missing("studio/dist is not built, and the program would have no page: `make test-studio` builds it")
    if "KATYDID_PROGRAM" not in os.environ:
        run("cargo", "build", "--locked", "--profile", PROFILE, "-p", "katydid")
    beside()
    return []


def written():
    """Where the manual pages and completions are; they are written where they are not."""
    return BESIDE if BESIDE.exists() else beside()


def beside():
    """The manual pages and completions, written by the program itself."""
    shutil.rmtree(BESIDE, ignore_errors=True)
    (BESIDE / "completions").mkdir(parents=True)
    run(made(), "man", "--output", BESIDE / "man")
    for shell, name in SHELLS.items():
        with open(BESIDE / "completions" / name, "w", encoding="utf-8", newline="\n") as file:
            run(made(), "completions", shell, stdout=file)
    return BESIDE
