"""The version is written in several files: they agree, and the changelog has a section for it."""

import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
VERSION = re.search(r'^version = "(.*)"', (ROOT / "Cargo.toml").read_text(encoding="utf-8"), flags=re.M).group(1)


@pytest.mark.parametrize("name", ["studio/package.json", "studio/package-lock.json", "wasm/package.json"])
def test_npm_packages_have_it(name):
    assert json.loads((ROOT / name).read_text(encoding="utf-8"))["version"] == VERSION


def test_the_tool_for_pages_has_it():
    assert f'\nversion = "{VERSION}"\n' in (ROOT / "wasm/tool/Cargo.toml").read_text(encoding="utf-8")


def test_the_changelog_begins_with_what_is_not_released_and_then_the_newest_version():
    headings = re.findall(r"^## \[(.*?)\](?: - (.*))?$", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), flags=re.M)
    assert headings[0] == ("Unreleased", "")
    assert headings[1][0] == VERSION
    assert all(re.fullmatch(r"\d{4}-\d\d-\d\d", date) for _, date in headings[1:])
