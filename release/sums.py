"""The sums of all packages."""

import hashlib

from place import OUT


def make():
    """SHA256SUMS, as `sha256sum --check` takes it."""
    path = OUT / "SHA256SUMS"
    path.unlink(missing_ok=True)
    files = sorted(file for file in OUT.rglob("*") if file.is_file())
    lines = [f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.relative_to(OUT).as_posix()}\n" for file in files]
    path.write_text("".join(lines), encoding="utf-8", newline="\n")
    return [path]
