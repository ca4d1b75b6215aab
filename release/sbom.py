"""What the program is made of, for machines: CycloneDX."""

import os
import shutil
from pathlib import Path

from place import OUT, ROOT, VERSION, Missing, run


def make():
    """Asks cargo-cyclonedx, where it is installed; it takes ten minutes to compile."""
    tool = shutil.which("cargo-cyclonedx") or shutil.which(str(ROOT / ".tools/bin/cargo-cyclonedx"))
    if not tool:
        raise Missing("cargo-cyclonedx is not installed: `cargo install cargo-cyclonedx --locked --root .tools`")
    name = f"katydid-{VERSION}.cdx"
    # It writes beside the manifest of every crate of the workspace.
    run(tool, "cyclonedx", "--format", "json", "--spec-version", "1.5", "--manifest-path", "crates/cli/Cargo.toml",
        "--override-filename", name, env={**os.environ, "CARGO_NET_OFFLINE": "true"})
    for other in ROOT.glob(f"*/*/{name}.json"):
        if other.parent != ROOT / "crates/cli":
            other.unlink()
    return [Path(shutil.move(ROOT / "crates/cli" / f"{name}.json", OUT / f"{name}.json"))]
