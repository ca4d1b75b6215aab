"""What the packages of a version are tried by: it must tell what is wrong."""

import hashlib
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
sys.path.append(str(ROOT / "release"))

import changes
import expected
import sums
import trial_sums
from place import VERSION


def test_radii_run_from_the_largest_at_the_nearest_point_to_the_smallest():
    radii = expected.radii()
    # The grid has the point (30, 50), 7.07 away, the nearest with three others; the corner (120, 0) is the farthest.
    assert len(radii) == 13 * 10
    assert max(radii) == pytest.approx(4.6) and radii.count(max(radii)) == 4
    assert min(radii) == pytest.approx(0.8)


def test_other_radii_are_told():
    right = expected.radii(columns=20)
    assert expected.compare(right[::-1], columns=20) is None
    assert "not 210" in expected.compare(right[1:], columns=20)
    assert "differ" in expected.compare([right[0] + 1e-6, *right[1:]], columns=20)


def test_sums_are_whole_and_right(tmp_path, monkeypatch):
    for module in (sums, trial_sums):
        monkeypatch.setattr(module, "OUT", tmp_path)
    (tmp_path / "crates").mkdir()
    (tmp_path / "crates" / "a.crate").write_bytes(b"a")
    (tmp_path / "b.deb").write_bytes(b"b")
    sums.make()
    assert f"{hashlib.sha256(b'a').hexdigest()}  crates/a.crate" in (tmp_path / "SHA256SUMS").read_text()
    assert trial_sums.run(tmp_path) == "2 files"
    (tmp_path / "b.deb").write_bytes(b"c")
    with pytest.raises(RuntimeError, match="b.deb"):
        trial_sums.run(tmp_path)
    (tmp_path / "more").write_bytes(b"")
    with pytest.raises(RuntimeError, match="more"):
        trial_sums.run(tmp_path)


def test_the_changes_of_a_version_are_its_section_alone():
    text = changes.of(VERSION)
    assert text and "\n## [" not in text
    with pytest.raises(SystemExit):
        changes.of("999.0.0")
