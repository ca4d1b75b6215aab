"""A package for Debian and its kin, by Debian's own tools."""

import gzip
import os
import re
import shutil
import tempfile
from pathlib import Path

import program
import third
from place import OUT, ROOT, VERSION, date, needed, told

CONTROL = """\
Package: katydid
Version: {version}-1
Architecture: {architecture}
Maintainer: The Katydid developers <noreply@example.org>
Installed-Size: {size}
Depends: {depends}
Recommends: python3
Section: graphics
Priority: optional
Description: Grasshopper definitions without Rhino
 Opens, runs, edits and saves Grasshopper definitions (.gh, .ghx), reads and
 writes .3dm, STEP, OBJ, STL, PLY and glTF, and has a studio for the browser
 and a server for the clients of Rhino.Compute and Hops.
"""
COPYRIGHT = """\
Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/
Upstream-Name: Katydid

Files: *
Copyright: The Katydid developers
License: MIT or Apache-2.0
Comment: What is linked into the program is in THIRD-PARTY.gz, beside this file.

License: MIT
{mit}

License: Apache-2.0
 On Debian systems it is /usr/share/common-licenses/Apache-2.0.
"""


def packed(path, text):
    """A file as Debian keeps documentation: compressed, without a name or a time in it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_bytes(gzip.compress(text.encode(), 9, mtime=0))


def lay_out(root):
    """The files of the package."""
    shares = root / "usr/share"
    binary = root / "usr/bin/katydid"
    binary.parent.mkdir(parents=True)
    shutil.copyfile(program.made(), binary)
    told("strip", binary)
    binary.chmod(0o755)
    for page in (program.written() / "man").iterdir():
        packed(shares / f"man/man1/{page.name}.gz", page.read_text(encoding="utf-8"))
    places = {"katydid.bash": "bash-completion/completions/katydid", "_katydid": "zsh/vendor-completions/_katydid",
              "katydid.fish": "fish/vendor_completions.d/katydid.fish"}
    for name, place in places.items():
        (shares / place).parent.mkdir(parents=True)
        shutil.copyfile(program.BESIDE / "completions" / name, shares / place)
    documents = shares / "doc/katydid"
    packed(documents / "changelog.gz", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))
    packed(documents / "THIRD-PARTY.gz", third.text())
    mit = (ROOT / "LICENSE-MIT").read_text(encoding="utf-8").strip()
    indented = re.sub(r"^", " ", re.sub(r"^$", ".", mit, flags=re.M), flags=re.M)
    (documents / "copyright").write_text(COPYRIGHT.format(mit=indented), encoding="utf-8")
    (documents / "examples").mkdir()
    shutil.copy(ROOT / "examples/attractor.ghx", documents / "examples")
    unit = (ROOT / "deploy/katydid-serve.service").read_text(encoding="utf-8")
    service = root / "lib/systemd/system/katydid-serve.service"
    service.parent.mkdir(parents=True)
    # It is not switched on: whoever wants a server does that.
    service.write_text(unit.replace("/usr/local/bin/", "/usr/bin/"), encoding="utf-8")


def depends(root):
    """The libraries that the program is linked with, in the versions that have what it uses."""
    with tempfile.TemporaryDirectory() as folder:
        debian = Path(folder, "debian")
        debian.mkdir()
        (debian / "control").write_text("Source: katydid\n\nPackage: katydid\nArchitecture: any\n", encoding="utf-8")
        line = told("dpkg-shlibdeps", "-O", root / "usr/bin/katydid", cwd=folder)
    return re.search(r"^shlibs:Depends=(.*)$", line, flags=re.M).group(1)


def make():
    """Builds it; owners and times are those of the commit, not of who builds."""
    needed("dpkg-deb", "it is a part of Debian")
    needed("dpkg-shlibdeps", "`apt-get install dpkg-dev`")
    architecture = told("dpkg", "--print-architecture").strip()
    path = OUT / f"katydid_{VERSION}-1_{architecture}.deb"
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder, "root")
        root.mkdir()
        lay_out(root)
        root.chmod(0o755)
        size = sum(file.stat().st_size for file in root.rglob("*") if file.is_file()) // 1024
        (root / "DEBIAN").mkdir()
        (root / "DEBIAN/control").write_text(
            CONTROL.format(version=VERSION, architecture=architecture, size=size, depends=depends(root)), encoding="utf-8")
        for file in root.rglob("*"):
            if file != root / "usr/bin/katydid":
                file.chmod(0o755 if file.is_dir() else 0o644)
        # Packing takes a minute: what is stopped in it leaves no half of a package.
        packed_file = Path(folder, path.name)
        told("dpkg-deb", "--root-owner-group", "-Zxz", "--build", root, packed_file,
             env={**os.environ, "SOURCE_DATE_EPOCH": str(date())})
        shutil.move(packed_file, path)
    return [path]
