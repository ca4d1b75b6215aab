"""The crates that others use have all that crates.io asks for; the others say that they are not published."""

import json
import os
import re
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
FOUND = json.loads(subprocess.run(
    [os.environ.get("CARGO", "cargo"), "metadata", "--offline", "--locked", "--no-deps", "--format-version", "1"],
    cwd=ROOT, capture_output=True, check=True, text=True).stdout)["packages"]
OURS = {package["name"]: package for package in FOUND}
PUBLISHED = {name: package for name, package in OURS.items() if package["publish"] is None}
#: Of https://crates.io/category_slugs, those that fit.
CATEGORIES = {
    "compilers", "data-structures", "development-tools::procedural-macro-helpers", "encoding", "graphics", "mathematics",
    "memory-management", "parser-implementations", "rendering", "science",
}


def test_some_are_published_and_some_are_not():
    assert "katydid-geometry" in PUBLISHED and "katydid-server" not in PUBLISHED


@pytest.mark.parametrize("name", sorted(PUBLISHED))
def test_what_the_registry_asks_for(name):
    package = PUBLISHED[name]
    folder = Path(package["manifest_path"]).parent
    assert 10 <= len(package["description"]) <= 200
    assert package["license"] == "MIT OR Apache-2.0"
    assert package["documentation"] == f"https://docs.rs/{name}"
    assert 1 <= len(package["keywords"]) <= 5
    assert all(re.fullmatch(r"[a-z0-9][a-z0-9_+-]{0,19}", word) for word in package["keywords"])
    assert package["categories"] and set(package["categories"]) <= CATEGORIES
    assert (folder / package["readme"]).read_text(encoding="utf-8").startswith(f"# {name}\n")
    for licence in ("LICENSE-MIT", "LICENSE-APACHE"):
        assert (folder / licence).read_bytes() == (ROOT / licence).read_bytes()


@pytest.mark.parametrize("name", sorted(PUBLISHED))
def test_they_need_none_that_is_not_published_and_name_versions(name):
    for need in PUBLISHED[name]["dependencies"]:
        if need["name"] in OURS and need["kind"] != "dev":
            assert need["name"] in PUBLISHED, need["name"]
            assert need["req"] == f"^{OURS[need['name']]['version']}", need["name"]


@pytest.mark.parametrize("name", sorted(PUBLISHED))
def test_they_take_no_file_from_outside_of_their_folder(name):
    folder = Path(PUBLISHED[name]["manifest_path"]).parent
    source = [*folder.glob("src/**/*.rs"), *folder.glob("build.rs")]
    assert source
    for file in source:
        for path in re.findall(r'include_(?:str|bytes)!\("([^"]+)"\)|#\[folder = "\$CARGO_MANIFEST_DIR/([^"]+)"\]',
                               file.read_text(encoding="utf-8")):
            here = file.parent if path[0] else folder
            assert (here / (path[0] or path[1])).resolve().is_relative_to(folder), f"{file}: {path}"
