"""The documents: words that are misspelt, and links between files that lead nowhere."""

import re
import subprocess
import sys
from collections import Counter
from pathlib import Path
from urllib.parse import unquote

import pytest

ROOT = Path(__file__).resolve().parent.parent
TEXTS = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md"), *ROOT.glob("benches/*.md"), *ROOT.glob("crates/*/*.md"),
                *ROOT.glob("wasm/*.md"), *ROOT.glob("python/*.md")])


def test_words_are_spelt_right():
    found = subprocess.run(
        [Path(sys.executable).with_name("typos"), "--format", "brief", "book", "docs", *[text.name for text in ROOT.glob("*.md")]],
        cwd=ROOT, capture_output=True, text=True, check=False)
    assert found.returncode == 0, found.stdout + found.stderr


def anchors(text):
    """What GitHub makes of headings, and what HTML in the text names."""
    headings = re.findall(r"^#+ +(.*?) *#*$", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S), flags=re.M)
    plain = (re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading) for heading in headings)
    slugs, seen = set(re.findall(r'(?:id|name)="([^"]+)"', text)), Counter()
    for heading in plain:
        slug = re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-")
        slugs.add(f"{slug}-{seen[slug]}" if seen[slug] else slug)
        seen[slug] += 1
    return slugs


@pytest.mark.parametrize("text", TEXTS, ids=lambda path: str(path.relative_to(ROOT)))
def test_links_lead_somewhere(text):
    content = text.read_text(encoding="utf-8")
    # Code shows links and does not have them.
    prose = re.sub(r"`[^`\n]*`", "", re.sub(r"^```.*?^```", "", content, flags=re.M | re.S))
    wrong = []
    for link in re.findall(r"\]\(<?([^)\s>]+)>?(?: \"[^\"]*\")?\)", prose):
        if re.match(r"(https?|mailto):", link):
            continue
        name, _, anchor = unquote(link).partition("#")
        target = (text.parent / name).resolve() if name else text
        if not target.is_relative_to(ROOT) or not target.exists():
            wrong.append(link)
        elif anchor and target.suffix == ".md" and anchor not in anchors(target.read_text(encoding="utf-8")):
            wrong.append(link)
    assert not wrong, f"{text.relative_to(ROOT)}: {wrong}"


def test_the_walk_through_the_code_names_files_that_are_there():
    text = (ROOT / "docs" / "a-day-in-the-code.md").read_text(encoding="utf-8")
    named = re.findall(r"`((?:crates|studio|wasm|examples)/[^`\s]+)`", text)
    assert len(named) > 25
    assert not [name for name in named if not (ROOT / name).is_file()]


def test_decisions_are_numbered_and_listed():
    files = sorted((ROOT / "docs" / "decisions").glob("*.md"))
    listed = re.findall(r"\]\(docs/decisions/([^)#]+)\)", (ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8").split("## Decisions")[1])
    assert [file.name for file in files] == listed
    for number, file in enumerate(files, 1):
        assert file.name.startswith(f"{number:04d}-")
        assert file.read_text(encoding="utf-8").startswith(f"# {number}. ")
