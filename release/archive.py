"""The program in an archive for any machine: .tar.gz, and .zip on Windows."""

import gzip
import io
import tarfile
import zipfile

import program
import third
from place import EXE, OUT, ROOT, VERSION, date, triple

TEXTS = ("README.md", "CHANGELOG.md", "LICENSE-APACHE", "LICENSE-MIT")


def files():
    """What is in it: names, bytes and whether it is run."""
    beside = program.written()
    yield f"katydid{EXE}", program.made().read_bytes(), True
    for name in TEXTS:
        yield name, (ROOT / name).read_bytes(), False
    yield "THIRD-PARTY", third.text().encode(), False
    yield "examples/attractor.ghx", (ROOT / "examples" / "attractor.ghx").read_bytes(), False
    for folder in ("man", "completions"):
        for file in sorted((beside / folder).iterdir()):
            yield f"{folder}/{file.name}", file.read_bytes(), False


def make():
    """Writes it; the same files at the same commit give the same bytes."""
    name = f"katydid-{VERSION}-{triple()}"
    if EXE:
        return [zipped(name)]
    path = OUT / f"{name}.tar.gz"
    with open(path, "wb") as raw, gzip.GzipFile("", "wb", 9, raw, mtime=date()) as packed, \
            tarfile.open(fileobj=packed, mode="w", format=tarfile.PAX_FORMAT) as tar:
        for file, data, is_run in files():
            entry = tarfile.TarInfo(f"{name}/{file}")
            entry.size, entry.mtime, entry.mode = len(data), date(), 0o755 if is_run else 0o644
            tar.addfile(entry, io.BytesIO(data))
    return [path]


def zipped(name):
    """The same as .zip."""
    path = OUT / f"{name}.zip"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as folder:
        for file, data, _ in files():
            folder.writestr(f"{name}/{file}", data)
    return path
