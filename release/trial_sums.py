"""The list of sums is whole and right."""

import hashlib

from place import OUT, Missing


def run(_folder):
    """Reads it, and every file."""
    path = OUT / "SHA256SUMS"
    if not path.exists():
        raise Missing("there is no SHA256SUMS")
    sums = dict(reversed(line.split("  ", 1)) for line in path.read_text(encoding="utf-8").splitlines())
    files = {file.relative_to(OUT).as_posix(): file for file in OUT.rglob("*") if file.is_file() and file != path}
    if set(sums) != set(files):
        raise RuntimeError(f"listed or there, but not both: {sorted(set(sums) ^ set(files))}")
    wrong = [name for name, file in files.items() if hashlib.sha256(file.read_bytes()).hexdigest() != sums[name]]
    if wrong:
        raise RuntimeError(f"other bytes than listed: {wrong}")
    return f"{len(files)} files"
