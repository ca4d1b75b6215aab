"""Each package in an environment that has nothing else, and the README's example run in it."""

import shutil
import tempfile
import traceback
from pathlib import Path

import trial_container
import trial_crates
import trial_npm
import trial_program
import trial_sums
import trial_wheel
from place import Missing

TRIALS = {
    "sums": trial_sums.run,
    "archive": trial_program.archive,
    "deb": trial_program.deb,
    "image": trial_container.image,
    "wheel": trial_wheel.run,
    "crates": trial_crates.run,
    "npm": trial_npm.run,
}


def run(wanted):
    """Runs the trials, and gives the code to end with: a package that is not there is told, and is no failure."""
    lines = []
    for name, trial in TRIALS.items():
        if wanted and name not in wanted:
            continue
        folder = Path(tempfile.mkdtemp(prefix=f"katydid-{name}-"))
        try:
            lines.append((name, "works", trial(folder)))
        except Missing as why:
            lines.append((name, "not tried", str(why)))
        except Exception as error:  # noqa: BLE001 - the others are tried all the same, and all faults are told
            traceback.print_exc()
            lines.append((name, "FAILS", str(error)))
        finally:
            shutil.rmtree(folder, ignore_errors=True)
    print()
    for name, how, told in lines:
        print(f"{name:8} {how:10} {told}")
    return 1 if any(how == "FAILS" for _, how, _ in lines) else 0
