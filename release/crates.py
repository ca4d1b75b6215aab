"""The crates that are of use to others, as crates.io takes them."""

import json
import shutil
from pathlib import Path

from place import OUT, TARGET, VERSION, run, told


def published():
    """The names of the crates that are not kept back by `publish = false`."""
    found = json.loads(told("cargo", "metadata", "--locked", "--no-deps", "--format-version", "1"))["packages"]
    return sorted(package["name"] for package in found if package["publish"] is None)


def make():
    """Packages them together: cargo orders them by their needs, and lets each have the others that are not published yet."""
    folder = OUT / "crates"
    folder.mkdir(exist_ok=True)
    words = [word for name in published() for word in ("-p", name)]
    # They are built by the test of the packages, from what was packaged.
    run("cargo", "package", "--locked", "--no-verify", *words)
    return [Path(shutil.copy2(TARGET / "package" / f"{name}-{VERSION}.crate", folder)) for name in published()]
