"""The compute server as a program on this machine, and the clients' tools in the shared folder."""

import os
import subprocess
from contextlib import contextmanager
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SHARED = Path(os.environ.get("KATYDID_SHARED", ROOT.parent / "shared"))
TOOLS = SHARED / "tools" / "compute-clients"
BINARY = Path(os.environ.get("KATYDID", ROOT / "target" / "release" / "katydid"))


@contextmanager
def serving(*options):
    process = subprocess.Popen(
        [BINARY, "serve", "--port", "0", *map(str, options)], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True
    )
    try:
        yield process.stdout.readline().strip().rstrip("/"), process
    finally:
        process.terminate()
        process.wait(timeout=60)


@pytest.fixture(scope="session")
def tools():
    if not TOOLS.is_dir():
        if os.environ.get("KATYDID_REQUIRE_SHARED"):
            pytest.fail(f"{TOOLS} is missing")
        pytest.skip("the shared data is not here")
    return TOOLS


@pytest.fixture(scope="session")
def url():
    with serving() as (url, _):
        yield url


@pytest.fixture(scope="session")
def node(tmp_path_factory):
    """A folder outside of the repository with the clients from npm; none of it stays."""
    folder = tmp_path_factory.mktemp("npm")
    packages = ["compute-rhino3d@0.12.1", "rhino3dm@8.35.0"]
    installed = subprocess.run(
        ["npm", "install", "--no-audit", "--no-fund", "--prefix", folder, *packages], capture_output=True, text=True
    )
    assert installed.returncode == 0, installed.stderr
    return folder / "node_modules"
