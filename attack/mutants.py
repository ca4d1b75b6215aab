"""Damaged files of every format, read by the program.

    python attack/mutants.py target/release/katydid                     200 of each format
    python attack/mutants.py target/release/katydid --seconds 60        what fits into a minute
    python attack/mutants.py target/release/katydid --only 3dm --count 5000

Whatever a file holds, the program tells what is wrong with it or reads it: it does not crash, and takes neither more
than 320 MB nor more than 5 s of processor time.
"""

import random
import sys
import tempfile
import time
from pathlib import Path

import damage
import seeds
from bounded import Bounds, alone, run

BOUNDS = Bounds(320, 5.0)
LIMITS = ["--limit-bytes", str(256 << 20), "--limit-seconds", "2", "--threads", "1"]
DEFINITIONS = {"gh", "ghx", "kd"}
# Components that read a file, where no command does.
READERS = {"shp": "Import SHP", "pdb": "Import PDB", "png": "Import Image", "bmp": "Import Image", "gif": "Import Image"}
# What models are converted to.
TARGETS = ["obj", "3dm", "glb"]


def command(suffix, path, folder, dice):
    """The words with which the program reads a file, after its name."""
    if suffix in DEFINITIONS:
        to = Path(folder) / f"out.{dice.choice(['kd', 'gh', 'ghx'])}"
        return dice.choice([["run", path, *LIMITS], ["check", path], ["convert", path, to], ["run", path, *LIMITS]])
    if suffix in READERS:
        reader = Path(folder) / "reader.kd"
        more = ", Rectangle(plane((0, 0, 0)), 4, 3)" if READERS[suffix] == "Import Image" else ""
        reader.write_text(f'katydid 1\nx = {READERS[suffix]}("{path}"{more})\n')
        return ["run", reader, *LIMITS]
    to = ["convert", path, Path(folder) / f"out.{dice.choice(TARGETS)}"]
    if suffix == "3dm":
        return dice.choice([["info", path], ["info", "--lenient", path], ["info", "--tree", path], to, [*to, "--lenient"]])
    return to


def attack(katydid, found, seconds=None, seed=1, only=None, count=200, bounds=BOUNDS):
    """Reads `count` damaged files of each format, in turn; fewer when the time is over before."""
    end = time.monotonic() + seconds if seconds else None
    with tempfile.TemporaryDirectory() as folder:
        sound = {s: d for s, d in seeds.all_of(katydid, folder).items() if not only or s == only}
        for number in range(count):
            for suffix, files in sorted(sound.items()):
                if end and time.monotonic() > end:
                    return
                dice = random.Random(f"{seed} {suffix} {number}")
                data = damage.damaged(suffix, files, dice)
                path = Path(folder) / f"damaged.{suffix}"
                path.write_bytes(data)
                words = [str(word) for word in command(suffix, path, folder, dice)]
                outcome = run([katydid, *words])
                found.note(f"{suffix} {number} by {words[0]}", bounds.fault(outcome), data, f".{suffix}")


def options(parser):
    parser.add_argument("--only", help="one format, by the end of its files' names")
    parser.add_argument("--count", type=int, default=200)
    parser.add_argument("--seed", type=int, default=1)


if __name__ == "__main__":
    sys.exit(alone("mutants", __doc__, attack, options, ["seed", "only", "count"]))
