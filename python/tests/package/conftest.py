"""The package with its extension module. Where that was not built its tests are skipped; `make test` builds it."""

import os

import pytest

try:
    import katydid._katydid  # noqa: F401
    BUILT = True
except ImportError:
    if os.environ.get("KATYDID_REQUIRE_MODULE"):
        raise
    BUILT = False

collect_ignore_glob = [] if BUILT else ["test_*.py"]


def pytest_report_header():
    return None if BUILT else "katydid: the extension module is not built, so the package is not tested"


@pytest.fixture
def definition(tmp_path):
    """Opens a definition of some text."""
    import katydid

    def make(text, **more):
        file = tmp_path / "definition.kd"
        file.write_text("katydid 1\n" + text)
        return katydid.open(file, **more)
    return make


@pytest.fixture
def shared():
    """The folder of shared test data."""
    here = os.path.dirname(os.path.abspath(__file__))
    folder = os.path.join(here, "..", "..", "..", "..", "shared", "data")
    if not os.path.isdir(folder):
        if os.environ.get("KATYDID_REQUIRE_SHARED"):
            pytest.fail("../shared is absent")
        pytest.skip("../shared is absent")
    return os.path.normpath(folder)
