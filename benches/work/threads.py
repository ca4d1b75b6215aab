"""What a second thread is worth: rows of few, costly items by one thread and by two.

    python benches/work/threads.py target/release/katydid [--only "Lofts"] [--rounds 7]

Each row runs at 4N by `katydid run FILE --threads 1` and `--threads 2` in turns; the median of the seconds on the clock
counts, of the whole command and of the solve as the command itself tells it. Two processors must be free for it.
"""

import argparse
import re
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from definitions import ROWS

COSTLY = ["Capped pipes", "Lofts", "Mesh Brep, straight pipes", "Mesh Brep, curved pipes", "Variable pipes"]


def once(katydid, file, threads):
    """Seconds on the clock, of the command and of its solve."""
    start = time.perf_counter()
    command = [katydid, "run", file, "--threads", str(threads)]
    said = subprocess.run(command, capture_output=True, text=True, check=True).stderr
    whole = time.perf_counter() - start
    return whole, float(re.search(r"in ([\d.]+) ms", said)[1]) / 1e3


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("katydid")
    parser.add_argument("--only", action="append", help="rows with this in their name; may be given again")
    parser.add_argument("--rounds", type=int, default=7)
    args = parser.parse_args()
    wanted = args.only or COSTLY
    print("| row | items | 1 thread: command, solve (ms) | 2 threads | ratio of commands | of solves |")
    print("| --- | --- | --- | --- | --- | --- |")
    for row in ROWS:
        if not any(part.lower() in row.name.lower() for part in wanted):
            continue
        size = row.sizes()[-1]
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "work.kd"
            file.write_text("katydid 1\n" + row.definition(size))
            runs = {1: [], 2: []}
            for _ in range(args.rounds):
                for threads, times in runs.items():
                    times.append(once(args.katydid, file, threads))
        middle = {n: [1e3 * statistics.median(column) for column in zip(*times)] for n, times in runs.items()}
        texts = [", ".join(f"{ms:.0f}" for ms in middle[n]) for n in (1, 2)]
        ratios = [f"{one / two:.2f}" for one, two in zip(middle[1], middle[2])]
        print("| " + " | ".join([row.name, f"{size:,}", *texts, *ratios]) + " |", flush=True)


if __name__ == "__main__":
    sys.exit(main())
