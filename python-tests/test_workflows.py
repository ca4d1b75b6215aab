"""The public workflows: what they ask of `make` is there, and every action has a version."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*.yml"))
TARGETS = set(re.findall(r"^([\w-]+):(?!=)", (ROOT / "Makefile").read_text(encoding="utf-8"), flags=re.M))


def test_workflows_are_there():
    assert {file.name for file in WORKFLOWS} >= {"ci.yml", "release.yml"}


@pytest.mark.parametrize("file", WORKFLOWS, ids=lambda file: file.name)
def test_what_they_make_is_in_the_makefile(file):
    lines = re.findall(r"\bmake ((?:[\w-]+ ?)+)", "\n".join(
        line for line in file.read_text(encoding="utf-8").splitlines() if not line.strip().startswith("#")))
    asked = {word for line in lines for word in line.split()}
    assert asked, "no `make` at all"
    assert asked <= TARGETS, asked - TARGETS


@pytest.mark.parametrize("file", WORKFLOWS, ids=lambda file: file.name)
def test_actions_have_a_version(file):
    actions = re.findall(r"uses: *(\S+)", file.read_text(encoding="utf-8"))
    assert actions, "no action at all"
    assert not [action for action in actions if not re.fullmatch(r"[\w.-]+/[\w.-]+@v\d+\.\d+\.\d+", action)]
