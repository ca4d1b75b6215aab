"""What the changelog says."""

import re

from place import ROOT


def of(version):
    """The section of a version, without its heading."""
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    found = re.search(rf"^## \[{re.escape(version)}\].*?$(.*?)(?=^## \[|\Z)", text, flags=re.M | re.S)
    if not found:
        raise SystemExit(f"CHANGELOG.md has no version {version}")
    return found.group(1).strip()
