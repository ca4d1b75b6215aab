"""appserver, as web teams run it, with the server behind it."""

import os
import shutil
import socket
import subprocess
import time

import pytest
import requests
from conftest import serving


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


@pytest.fixture(scope="module")
def appserver(tmp_path_factory, tools):
    folder = tmp_path_factory.mktemp("appserver")
    package = os.environ.get("APPSERVER_PACKAGE", "compute-rhino3d-appserver@0.1.12")
    packed = subprocess.run(["npm", "install", "--no-audit", "--no-fund", "--prefix", folder, package], capture_output=True, text=True)
    if packed.returncode != 0:
        pytest.skip(f"appserver cannot be had: {packed.stderr[-300:]}")
    home = next(path.parent for path in folder.glob("node_modules/*/package.json") if "appserver" in path.parent.name)
    for name in ["mini_sum.gh", "mini_groups.gh"]:
        shutil.copy(tools / "fixtures" / "defs" / name, home / "src" / "files" / name)
    port = free_port()
    with serving("--allow-url", f"127.0.0.1:{port}", "--allow-url", f"localhost:{port}") as (url, _):
        env = {**os.environ, "RHINO_COMPUTE_URL": url + "/", "PORT": str(port), "APP_URL": f"http://127.0.0.1:{port}/"}
        process = subprocess.Popen(["node", "src/bin/www"], cwd=home, env=env, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            own = f"http://127.0.0.1:{port}"
            for _ in range(100):
                try:
                    requests.get(own + "/", timeout=1)
                    break
                except requests.ConnectionError:
                    time.sleep(0.2)
            yield own
        finally:
            process.terminate()
            process.wait(timeout=20)


def test_definitions_are_described_and_solved(appserver):
    described = requests.get(f"{appserver}/mini_sum.gh", headers={"Accept": "application/json"}, timeout=60)
    assert described.status_code == 200, described.text
    names = [one["name"] for one in described.json()["inputs"]]
    assert "A" in names and "B" in names
    solved = requests.post(f"{appserver}/solve", json={"definition": "mini_sum.gh", "inputs": {"A": 4, "B": 5}}, timeout=60)
    assert solved.status_code == 200, solved.text
    data = next(iter(solved.json()["values"][0]["InnerTree"].values()))[0]["data"]
    assert float(data) == 9
    by_address = requests.get(f"{appserver}/solve/mini_sum.gh?A=4&B=6", timeout=60)
    assert by_address.status_code == 200, by_address.text
