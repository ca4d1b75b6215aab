"""The compute server as a program on this machine, and the clients' tools in the shared folder."""

import os
import subprocess
import sys
import threading
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))
from program import binary  # noqa: E402 what all tests share lies one folder up

ROOT = Path(__file__).resolve().parents[2]
SHARED = Path(os.environ.get("KATYDID_SHARED", ROOT.parent / "shared"))
TOOLS = SHARED / "tools" / "compute-clients"
BINARY = binary()


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


@pytest.fixture
def files():
    """A host of files: its address, and what it holds by path, to be filled."""
    held = {}

    class Handler(BaseHTTPRequestHandler):
        def do_GET(self):
            data = held.get(self.path)
            self.send_response(200 if data else 404)
            self.send_header("Content-Length", str(len(data or b"")))
            self.end_headers()
            self.wfile.write(data or b"")

        def log_message(self, *_):
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield f"127.0.0.1:{server.server_port}", held
    server.shutdown()


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
