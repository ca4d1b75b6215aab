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


def output(reply):
    """What the one output gives, branch after branch."""
    assert reply.status_code == 200, reply.text
    [tree] = reply.json()["values"]
    return [json.loads(item["data"]) for branch in tree["InnerTree"].values() for item in branch]


def everything(own):
    """Each route as pages use it."""

    def get(path):
        return requests.get(own + path, timeout=60)

    def post(body):
        return requests.post(f"{own}/solve", json=body, timeout=60)

    assert set(NAMES) <= {one["name"] for one in get("/").json()}
    assert {"rhino", "compute", "appserver"} <= get("/version").json().keys()
    for name in NAMES:
        # Asked for twice: the second time it is from appserver's own memory.
        for _ in range(2):
            described = get(f"/{name}").json()
            assert {"A", "B"} <= {one["name"].removeprefix("RH_IN:") for one in described["inputs"]}
            assert all(one["paramType"] == "Number" for one in described["inputs"] + described["outputs"])
        assert 'type="number"' in get(f"/view/{name}").text
        assert output(get(f"/solve/{name}")) == [5]
        assert output(get(f"/solve/{name}?A=4&B=6")) == [10]
        assert requests.head(f"{own}/solve/{name}?A=4&B=7", timeout=60).status_code == 200
        for _ in range(2):
            assert output(post({"definition": name, "inputs": {"A": 4, "B": 5}})) == [9]
        tree = {"ParamName": "A", "InnerTree": {"0": [{"type": "System.Double", "data": "4"}]}}
        assert post({"pointer": name, "values": [tree]}).status_code == 200
    # A list goes where the definition takes one.
    assert output(post({"definition": "mini_groups.gh", "inputs": {"A": 4, "B": [5, 6]}})) == [9, 10]
    assert "solve;dur=" in get("/solve/mini_sum.gh?A=1").headers.get("Server-Timing", "solve;dur=")
    assert get("/solve/nothing.gh").status_code == 500
    assert get("/view/nothing.gh").status_code == 404


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
            everything(own)
        finally:
            process.terminate()
            process.wait(timeout=20)
