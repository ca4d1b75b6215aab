"""Whole work: definitions run as users run them, beside what they would use instead.

    python benches/work target/release/katydid
    python benches/work target/release/katydid --only "Region Union" --only Voronoi --write table.md

Every row of `definitions.py` is run by `katydid run FILE --threads 1` at the sizes N, 2N and 4N, each three times; the
least counts. Seconds are of processor time, user and system, of the whole process; behind them in brackets stand the
same without start-up, which is the seconds of the definition at a size near zero. The exponent is the slope of these,
by least squares over the logarithms of the three. It is marked where it is above 1.1; where no better way is known than
one of n log n, as where things are sorted or searched for, what the logarithm adds between N and 4N is allowed on top.

The answer at 4N is verified first: the definition's own outputs are those of the peer, or what is known beforehand
where there is no peer, within 1e-9 of the largest or what the row allows and says why. A row whose answers differ is
not timed. The peer runs in a process of its own, on one thread, and is timed around its work alone; of some runs the
least counts. Its inputs are made before, while what a definition makes first, such as the points that are searched,
counts as the definition's own. The ratio is that of the seconds in brackets to the peer's. The peer's exponent is that
between N and 4N: where it is high too, the inputs may be why.

Memory is the most that the process held, and bytes an item are what it held beyond start-up.
"""

import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import table
from definitions import ROWS
from measure import Failed, least

RUNS = 3
JUDGE = Path(__file__).with_name("judge.py")


def judged(katydid, row):
    """What the judge says of a row: how its answers differ, if they do, and the peer's seconds."""
    command = [sys.executable, JUDGE, katydid, row.name]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failed(f"no answer: {(done.stderr.strip() or '-').splitlines()[-1]}")
    return json.loads(done.stdout)


def taken(katydid, row, n, folder):
    file = Path(folder) / "work.kd"
    file.write_text("katydid 1\n" + row.definition(n))
    save = ["-o", file.with_suffix("." + row.saves)] if row.saves else []
    return least([katydid, "run", file, "--threads", "1", *save], RUNS)


def measured(katydid, row):
    """The row's line of the table, and whether it holds."""
    try:
        said = judged(katydid, row)
        if said["wrong"] is not None:
            return table.failed(row, f"differs: {said['wrong']}"), False
        with tempfile.TemporaryDirectory() as folder:
            start = taken(katydid, row, row.smallest, folder)
            runs = [taken(katydid, row, size, folder) for size in row.sizes()]
    except Failed as why:
        return table.failed(row, str(why)), False
    return table.line(table.cells(table.Measured(row, runs, start, said["seconds"]))), True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("katydid")
    parser.add_argument("--only", action="append", help="rows with this in their name; may be given again")
    parser.add_argument("--write", type=Path, help="a file for the table as well")
    args = parser.parse_args()
    katydid = str(Path(args.katydid).resolve())
    chosen = [row for row in ROWS if not args.only or any(part.lower() in row.name.lower() for part in args.only)]
    lines, all_hold = [table.head()], True
    print(lines[0], flush=True)
    for row in chosen:
        text, holds = measured(katydid, row)
        all_hold &= holds
        lines.append(text)
        print(text, flush=True)
    if args.write:
        args.write.write_text("\n".join(lines) + "\n")
    return 0 if chosen and all_hold else 1


if __name__ == "__main__":
    sys.exit(main())
