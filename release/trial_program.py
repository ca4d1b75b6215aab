"""The program in its archive and its Debian package."""

import json
import os
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import expected
from place import EXE, VERSION, Missing, needed, only, told


def radii(report):
    """The radii in what `katydid run --json=values` prints."""
    circles = next(one for one in report["objects"] if one["nickname"] == "Circles")
    return [item["radius"] for branch in circles["outputs"][0]["branches"] for item in branch["items"]]


def example(program, folder, before=()):
    """Runs the first two commands of the README; `before` are the words that put the program where it is alone."""
    # Nothing of this machine's environment.
    bare = {"PATH": "/usr/bin:/bin"} if not EXE else {"SYSTEMROOT": os.environ["SYSTEMROOT"]}

    def command(*words):
        done = subprocess.run([*before, str(program), *words], cwd=folder, env=bare, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, text=True, encoding="utf-8")
        if done.returncode:
            raise RuntimeError(f"{' '.join(words)}: {done.returncode}: {done.stderr.strip()[:2000]}")
        return done.stdout

    if command("--version").split() != ["katydid", VERSION]:
        raise RuntimeError("another version")
    command("run", "attractor.ghx", "-o", "attractor.3dm")
    info = command("info", "attractor.3dm")
    if "130" not in info:
        raise RuntimeError(f"not 130 circles: {info}")
    report = json.loads(command("run", "attractor.ghx", "--set", "columns=20", "--set", "attractor x=80", "--json=values"))
    wrong = expected.compare(radii(report), columns=20, at=(80.0, 55.0))
    if wrong:
        raise RuntimeError(wrong)
    return "the README's two commands; 210 radii are those of the formula"


def archive(folder):
    """Unpacks the archive into an empty folder, and runs the program there."""
    if EXE:
        with zipfile.ZipFile(only("katydid-*.zip")) as packed:
            packed.extractall(folder)
    else:
        with tarfile.open(only("katydid-*.tar.gz")) as packed:
            packed.extractall(folder, filter="data")
    inside = next(Path(folder).iterdir())
    for name in ("THIRD-PARTY", "LICENSE-MIT", "LICENSE-APACHE", "man/katydid-run.1", "completions/katydid.bash"):
        if not (inside / name).stat().st_size:
            raise RuntimeError(f"{name} is empty")
    return example(inside / f"katydid{EXE}", inside / "examples")


def deb(folder):
    """Unpacks the package and those that it depends on into an empty folder, which becomes the root of the program."""
    package = only("*.deb")
    if sys.platform != "linux":
        raise Missing("there is no Debian here")
    needed("dpkg", "it is a part of Debian")
    if os.geteuid() != 0:
        raise Missing("another root asks for the rights of root")
    root = Path(folder, "root")
    root.mkdir()
    names = told("dpkg-deb", "-f", package, "Depends").strip()
    needs = [name.split()[0] for name in names.split(",")]
    told("apt-get", "download", "-qq", *needs, cwd=folder)
    for file in sorted(Path(folder).glob("*.deb")):
        told("dpkg", "-x", file, root)
    # What a package may own, and what must be in it.
    told("dpkg", "-x", package, root)
    for place in ("usr/share/man/man1/katydid.1.gz", "usr/share/bash-completion/completions/katydid",
                  "usr/share/doc/katydid/copyright", "lib/systemd/system/katydid-serve.service"):
        if not (root / place).stat().st_size:
            raise RuntimeError(f"{place} is empty")
    work = root / "work"
    work.mkdir()
    (work / "attractor.ghx").write_bytes((root / "usr/share/doc/katydid/examples/attractor.ghx").read_bytes())
    done = example("/usr/bin/katydid", folder, chrooted(root))
    return f"{done}; with {names} and nothing else"


def chrooted(root):
    """The words that put a program into another root, in its folder /work."""
    return (sys.executable, "-c", "import os, sys; os.chroot(sys.argv[1]); os.chdir('/work'); os.execv(sys.argv[2], sys.argv[2:])",
            str(root))
