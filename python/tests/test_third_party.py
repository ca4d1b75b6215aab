"""The licences of what is linked into the wheel."""

import importlib.util
import os
import shutil

import pytest
from hosts import PACKAGE

SOURCE = os.path.join(os.path.dirname(PACKAGE), "third_party.py")


def test_every_crate_is_named_and_has_a_text():
    if shutil.which(os.environ.get("CARGO", "cargo")) is None:
        pytest.skip("there is no cargo: the licences were not looked at")
    spec = importlib.util.spec_from_file_location("third_party", SOURCE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    found = module.packages()
    names = {one["name"] for one in found}
    # What the module cannot be without is there; what is ours, builds or tests only is not.
    assert {"pyo3", "uuid", "serde_json"} <= names and not names & {"katydid-geometry", "proptest", "pyo3-build-config"}
    npm = module.page()
    text = module.document("extension module", found, npm)
    for one in [*found, *npm]:
        assert "\n%s %s: " % (one["name"], one["version"]) in text, one["name"]
        own = module.texts(one)
        # Nothing but a name is no text.
        assert not own or max(map(len, own.values())) > 500, one["name"]
    # One whose archive has only the path of its text stands over the words that all texts of its licence have.
    lone = next(one for one in found if one["name"] == "plotters")
    assert "Hao Hou" in module.common(lone)["LICENSE-MIT"] and not module.texts(lone)
    # Names stand at the top, and each crate over a text.
    for one in found:
        assert text.count("%s %s" % (one["name"], one["version"])) >= 2, one["name"]


def test_the_wheel_has_the_licences_of_the_project(tmp_path, monkeypatch):
    spec = importlib.util.spec_from_file_location("third_party", SOURCE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    monkeypatch.setattr(module, "packages", list)
    monkeypatch.setattr(module.sys, "argv", ["third_party.py", str(tmp_path / "THIRD-PARTY")])
    module.main()
    for name in ("THIRD-PARTY", "LICENSE-APACHE", "LICENSE-MIT"):
        assert (tmp_path / name).stat().st_size > 0, name
        # What is not named is not taken into the wheel.
        with open(os.path.join(os.path.dirname(PACKAGE), "pyproject.toml"), encoding="utf-8") as file:
            assert '"katydid/%s"' % name in file.read(), name
