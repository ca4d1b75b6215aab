#!/usr/bin/env python3
"""Runs every program of tests/programs through Mono: writes NAME.out, or NAME.err with the numbers of the errors
where Mono refuses it. With --check it only compares. Needs the Debian packages mono-mcs and mono-runtime."""

import pathlib
import re
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).parent / "programs"


def outcome(source, folder):
    program = pathlib.Path(folder) / (source.stem + ".exe")
    made = subprocess.run(["mcs", "-langversion:latest", "-r:Microsoft.CSharp", "-nowarn:0168,0219,0162,0164,0414,0649,0661,0659,0665,0183,0184,0108,0169,0472,0219,1717,0642,0251", f"-out:{program}", str(source)],
                          capture_output=True, text=True)
    if made.returncode:
        return "err", " ".join(sorted(set(re.findall(r"error (CS\d+)", made.stdout + made.stderr)))) + "\n"
    ran = subprocess.run(["mono", str(program)], capture_output=True, text=True, timeout=60)
    return "out", ran.stdout


def main():
    check = "--check" in sys.argv
    wrong = 0
    with tempfile.TemporaryDirectory() as folder:
        # What Mono's compiler does not know has its output worked out by hand; csc_color.out was made with
        # -r:System.Drawing, which is a package of its own (libmono-system-drawing4.0-cil).
        for source in sorted(p for p in FOLDER.glob("*.cs") if not p.name.startswith("csc_")):
            kind, text = outcome(source, folder)
            place = source.with_suffix("." + kind)
            if check and (not place.exists() or place.read_text() != text):
                print(f"{source.name}: Mono gives another {kind}")
                wrong += 1
            elif not check:
                if place.exists() and place.read_text() == text:
                    continue
                place.write_text(text)
                print(f"{source.name}: {kind} {text.strip()[:60] if kind == 'err' else ''}")
    sys.exit(1 if wrong else 0)


main()
