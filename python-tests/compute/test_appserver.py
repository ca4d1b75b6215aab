"""appserver, which web teams put before a compute server: it has the definitions, and names its own address as pointer.

It is not in npm's registry. With APPSERVER naming a checkout (`npm install` done), the real one is run; what it sends, as it
was recorded, is sent in either case.
"""

import hashlib
import json
import os
import shutil
import socket
import subprocess
import time
from pathlib import Path

import pytest
import requests
from conftest import serving

KEY = {"RhinoComputeKey": "my-key"}
NAMES = ["mini_sum.gh", "mini_groups.gh"]


@pytest.fixture
def host(tools, files):
    """Serves definitions by the MD5 of their files, as appserver does."""
    own, held = files
    for name in NAMES:
        data = (tools / "fixtures" / "defs" / name).read_bytes()
        held["/definition/" + hashlib.md5(data).hexdigest()] = data
    return own, list(held)


def test_what_it_sends(host, tools):
    own, paths = host
    recorded = json.loads((tools / "fixtures" / "appserver_0.1.12_requests.json").read_text())
    with serving("--allow-url", own, "--key", "my-key") as (url, _):
        for path in paths:
            pointer = f"http://{own}{path}"
            for one in recorded:
                body = json.loads(one["body"]) if one["body"] else None
                if body and "pointer" in body:
                    body["pointer"] = pointer
                got = requests.request(one["method"], url + one["path"], json=body, headers=KEY, timeout=60)
                assert got.status_code == 200, f"{one['path']}: {got.text}"
                if one["path"] == "/io":
                    assert got.json()["Inputs"] and got.json()["Outputs"]
                if one["path"] == "/grasshopper":
                    assert got.json()["values"]
    with serving("--key", "my-key") as (url, _):
        got = requests.post(f"{url}/io", json={"pointer": f"http://{own}{paths[0]}"}, headers=KEY, timeout=60)
        assert got.status_code == 403 and got.json()["cause"] == "refused"


@pytest.mark.skipif("APPSERVER" not in os.environ, reason="APPSERVER names no checkout of appserver")
def test_the_real_one(tools):
    home = Path(os.environ["APPSERVER"])
    for name in NAMES:
        shutil.copy(tools / "fixtures" / "defs" / name, home / "src" / "files" / name)
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        port = one.getsockname()[1]
    with serving("--allow-url", f"127.0.0.1:{port}", "--allow-url", f"localhost:{port}") as (url, _):
        env = {**os.environ, "RHINO_COMPUTE_URL": url + "/", "PORT": str(port), "APP_URL": f"http://127.0.0.1:{port}/"}
        process = subprocess.Popen(["node", "src/bin/www"], cwd=home, env=env, stdout=subprocess.DEVNULL)
        try:
            own = f"http://127.0.0.1:{port}"
            for _ in range(100):
                try:
                    requests.get(own + "/", timeout=1)
                    break
                except requests.ConnectionError:
                    time.sleep(0.2)
            described = requests.get(f"{own}/mini_sum.gh", headers={"Accept": "application/json"}, timeout=60)
            assert {"A", "B"} <= {one["name"] for one in described.json()["inputs"]}
            solved = requests.post(
                f"{own}/solve", json={"definition": "mini_sum.gh", "inputs": {"A": 4, "B": 5}}, timeout=60
            )
            assert solved.status_code == 200, solved.text
            data = next(iter(solved.json()["values"][0]["InnerTree"].values()))[0]["data"]
            assert float(data) == 9
            assert requests.get(f"{own}/solve/mini_sum.gh?A=4&B=6", timeout=60).status_code == 200
        finally:
            process.terminate()
            process.wait(timeout=20)
