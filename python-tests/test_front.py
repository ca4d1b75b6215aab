"""What the site's front page says is what the documents say."""

import json
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
RESULTS = (ROOT / "benches" / "RESULTS.md").read_text(encoding="utf-8")
MEASURED = json.loads((ROOT / "wasm" / "front" / "measured.json").read_text(encoding="utf-8"))


@pytest.mark.parametrize("entry", MEASURED, ids=lambda entry: entry["what"])
def test_ratios_stand_in_the_results(entry):
    rows = [line for line in RESULTS.splitlines() if line.startswith(entry["row"])]
    assert len(rows) == 1, rows
    cells = [cell.strip() for cell in rows[0].split("|")]
    assert entry["ratio"] in cells
    # The section, or the paragraph before the table, has its day.
    before = RESULTS[:RESULTS.index(rows[0])]
    assert re.findall(r"\b2026-\d\d-\d\d\b", before)[-1] == entry["date"]


def test_slower_ones_are_told_too():
    assert any(float(entry["ratio"]) > 1 for entry in MEASURED)


def test_what_the_page_takes_from_the_readme_is_there():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    section = readme.split("\n## What works, and what does not\n")[1].split("\n## ")[0]
    rows = [line for line in section.splitlines() if line.startswith("|")]
    assert rows[0] == "| | works | does not |" and len(rows) > 6
    assert all(row.count("|") == 4 for row in rows)
    assert "cargo run --release -- run examples/attractor.ghx" in readme.split("\n## First command\n")[1].split("\n## ")[0]


def test_the_first_command_is_seen_at_once_and_the_picture_is_small():
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert readme[:readme.index("cargo run")].count("\n") < 20 and readme.count("\n") < 90
    assert (ROOT / "docs" / "pictures" / "studio.png").stat().st_size < 300_000
