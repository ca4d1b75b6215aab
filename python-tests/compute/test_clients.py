"""The clients that are in use, against the server."""

import base64
import json
import os
import subprocess
import sys

import pytest
import requests

# The calls that fail, and why. One that is answered must leave the table: it only shrinks.
REFUSED = {
    "Mesh.QuadRemesh": "not there yet: 501",
    "SubD.ToBrep": "it sends a mesh: 400",
    "PythonEvaluate": "scripts are not run: 501",
}


def calls(output):
    return [json.loads(line) for line in output.splitlines() if line.startswith("{")]


def test_python_client(url, tools):
    done = subprocess.run(
        [sys.executable, tools / "smoke_py.py", url, tools / "fixtures" / "defs", "--strict"],
        capture_output=True, text=True, timeout=600,
    )
    all_calls = calls(done.stdout)
    assert len(all_calls) >= 53, done.stderr
    failed = {call["call"]: call for call in all_calls if not call["ok"]}
    assert failed.keys() == REFUSED.keys(), failed


def test_javascript_client(url, tools, node):
    done = subprocess.run(
        ["node", tools / "smoke_js.js", url, tools / "fixtures" / "defs"],
        capture_output=True, text=True, timeout=600, env={**os.environ, "NODE_MODULES": str(node)},
    )
    all_calls = calls(done.stdout)
    assert len(all_calls) >= 21, done.stderr
    failed = [call for call in all_calls if not call["ok"]]
    assert not failed, "\n".join(map(str, failed))


RECORDED = [
    "compute_rhino3d_0.12.2_requests.json",
    "compute-rhino3d_npm_0.12.1_requests.json",
    "appserver_0.1.12_requests.json",
]


@pytest.mark.parametrize("name", RECORDED)
def test_recorded_requests(url, tools, name):
    """Each is answered: with what was asked for, or with a refusal that says why."""
    session = requests.Session()
    for recorded in json.loads((tools / "fixtures" / name).read_text()):
        body = recorded["body"].encode() if recorded["body"] else base64.b64decode(recorded["body_base64"] or "")
        left = {"host", "content-length", "connection", "transfer-encoding"}
        headers = {key: value for key, value in recorded["headers"] if key.lower() not in left}
        got = session.request(recorded["method"], url + recorded["path"], data=body, headers=headers, timeout=60)
        where = f"{recorded['path']}: {got.status_code} {got.text[:300]}"
        assert got.headers["Content-Length"], where
        assert got.status_code < 500 or got.status_code == 501 or "values" in got.json(), where
        if got.status_code >= 400 and got.status_code != 500:
            assert got.json()["error"], where
        if recorded["path"] == "/grasshopper" and b'"algo": "' in body:
            assert got.json()["pointer"].startswith("md5_"), where


def solve(url, algo, *values, **more):
    return requests.post(f"{url}/grasshopper", json={"algo": algo, "pointer": None, "values": values, **more}, timeout=60)


def tree(name, *data, path="{0}"):
    return {"ParamName": name, "InnerTree": {path: [{"type": "System.Double", "data": str(x)} for x in data]}}


def test_hops_requests(url, tools):
    """As Hops sends them: what a definition asks for, then a solve by the key that came with it."""
    algo = base64.b64encode((tools / "fixtures" / "defs" / "mini_groups.gh").read_bytes()).decode()
    headers = {"Content-Type": "application/json; charset=utf-8"}
    io = requests.post(f"{url}/io", json={"algo": algo, "dataversion": 8}, headers=headers, timeout=60).json()
    assert io["CacheKey"] == "md5_17A9D08BA33AC5C23D0EB03F86873E0D"
    body = {
        "absolutetolerance": 0.001, "angletolerance": 1.0, "modelunits": "Millimeters", "dataversion": 8, "algo": None,
        "pointer": io["CacheKey"], "cachesolve": False, "recursionlevel": 1,
        "values": [tree(name, 4, path="{0;0}") for name in io["InputNames"]],
    }
    got = requests.post(f"{url}/grasshopper", json=body, headers=headers, timeout=60)
    assert got.status_code == 200, got.text
    assert [value["ParamName"] for value in got.json()["values"]] == io["OutputNames"]


def test_state_does_not_bleed(url, tools):
    algo = base64.b64encode((tools / "fixtures" / "defs" / "mini_sum.gh").read_bytes()).decode()
    first = solve(url, algo, tree("A", 7)).json()
    assert first["pointer"] == "md5_922DBA670C19CC935C3C9EB28D81A405"
    plain = [solve(url, algo).json()["values"] for _ in range(2)]
    assert plain[0] == plain[1] != first["values"]
