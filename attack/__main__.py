"""All attacks, one after another, each with its share of the time.

    python attack target/release/katydid                   all of it: some hours
    python attack target/release/katydid --minutes 10      a sample
    python attack target/debug/katydid --minutes 2 --slow  a program without optimisation: time is not looked at closely
"""

import argparse
import sys
from pathlib import Path

import abuse
import components
import definitions
import ends
import mutants
from bounded import Bounds, Found

# What part of the time each has.
SHARES = {"components": 0.4, "mutants": 0.25, "definitions": 0.15, "abuse": 0.1, "ends": 0.1}
# Without optimisation everything takes about so many times as long.
SLOWER = 20.0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("katydid")
    parser.add_argument("--minutes", type=float)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--slow", action="store_true", help="the program is not optimised")
    parser.add_argument("--keep", type=Path, help="a folder for what failed")
    args = parser.parse_args()
    katydid = str(Path(args.katydid).resolve())
    times = SLOWER if args.slow else 1.0

    def bounds(module):
        own = module.BOUNDS
        return Bounds(own.megabytes, own.seconds * times, own.codes)

    codes = []
    for name, part in SHARES.items():
        found = Found(args.keep and args.keep / name)
        seconds = args.minutes and 60 * args.minutes * part
        match name:
            case "components":
                components.attack(katydid, found, seconds, args.seed, bounds=bounds(components))
            case "mutants":
                mutants.attack(katydid, found, seconds, args.seed, count=1000, bounds=bounds(mutants))
            case "definitions":
                definitions.attack(katydid, found, seconds, bounds(definitions))
            case "abuse":
                abuse.attack(katydid, found, seconds)
            case "ends":
                ends.attack(katydid, found, seconds)
        codes.append(found.tell(name))
    return max(codes)


if __name__ == "__main__":
    sys.exit(main())
