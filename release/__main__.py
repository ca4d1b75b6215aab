"""Everything that a version needs, and whether it works where nothing else is.

    python release packages            all steps, into target/packages
    python release packages deb sums   some of them
    python release test                each package in an empty environment, the README's example run in it
    python release changes 0.2.0       what the changelog says of a version

`make packages` and `make packages-test` call it. Variables:

    KATYDID_PROFILE   the profile of the program and the wheel: dist without it; release for a quick try
    KATYDID_PROGRAM   a program that is built already
    KATYDID_WHEEL     a wheel that is built already
"""

import argparse
import subprocess
import sys

import archive
import changes
import crates
import debian
import image
import npm
import program
import sbom
import sums
import third
import trials
import wheel
from place import OUT, Missing

#: In the order in which they need each other.
STEPS = {
    "licences": third.make,
    "program": program.make,
    "archive": archive.make,
    "wheel": wheel.make,
    "crates": crates.make,
    "npm": npm.make,
    "deb": debian.make,
    "image": image.make,
    "sbom": sbom.make,
    "sums": sums.make,
}


def packages(wanted):
    """Makes packages; what a step has not got here is said, and the others are made. Gives the code to end with."""
    OUT.mkdir(parents=True, exist_ok=True)
    failed = []
    for name, step in STEPS.items():
        if wanted and name not in wanted:
            continue
        try:
            made = step()
        except Missing as why:
            print(f"{name}: skipped: {why}", flush=True)
            continue
        except subprocess.CalledProcessError as error:
            print(f"{name}: FAILS: {error}", flush=True)
            failed.append(name)
            continue
        for file in made:
            print(f"{name}: {file.relative_to(OUT)}, {file.stat().st_size:,} bytes", flush=True)
    return 1 if failed else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("packages").add_argument("steps", nargs="*", metavar="STEP", choices=[[], *STEPS])
    commands.add_parser("test").add_argument("packages", nargs="*", metavar="PACKAGE", choices=[[], *trials.TRIALS])
    commands.add_parser("changes").add_argument("version")
    words = parser.parse_args()
    if words.command == "packages":
        sys.exit(packages(words.steps))
    elif words.command == "test":
        sys.exit(trials.run(words.packages))
    else:
        print(changes.of(words.version))


if __name__ == "__main__":
    main()
