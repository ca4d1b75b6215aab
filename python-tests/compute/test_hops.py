"""Hops components: they ask the real ghhops-server, definitions that lie elsewhere, and other servers of ours."""

import base64
import json
import socket
import subprocess
import sys
import time

import pytest
import requests
from conftest import BINARY, serving

HOPS = "@c69bb52c-88ba-4640-b69f-188d111029e8"
DOUBLE = 'katydid 1\nn = Number()\nd = Addition(n, n)\n"RH_IN:N": n\n"RH_OUT:D": d\n'


def kd(location, inputs, output):
    """A definition with one Hops component, whose inputs are its own by name."""
    ports = ", ".join(f"{name} = {name.lower()}" for name, _ in inputs)
    lines = [f"{name.lower()} = {kind}()" for name, kind in inputs]
    lines.append(f"h = Hops {HOPS}({ports}) variable -> {output} {{ RemoteDefinitionLocation = {json.dumps(location)} }}")
    lines.append(f"x = Data(h.{output})")
    lines += [f'"RH_IN:{name}": {name.lower()}' for name, _ in inputs]
    return "katydid 1\n" + "\n".join(lines) + '\n"RH_OUT:x": x\n'


@pytest.fixture
def gh(tmp_path):
    """Makes definitions of Grasshopper's own form."""

    def make(text, name="definition"):
        source, target = tmp_path / f"{name}.kd", tmp_path / f"{name}.gh"
        source.write_text(text)
        done = subprocess.run([BINARY, "convert", source, target], capture_output=True, text=True)
        assert done.returncode == 0, f"{done.stderr}\n{text}"
        return target

    return make


@pytest.fixture(scope="module")
def hops(tools):
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        port = one.getsockname()[1]
    server = subprocess.Popen([sys.executable, tools / "hops_echo_server.py", str(port)], stderr=subprocess.DEVNULL)
    try:
        for _ in range(100):
            try:
                requests.get(f"http://127.0.0.1:{port}/", timeout=1)
                break
            except requests.ConnectionError:
                time.sleep(0.1)
        yield f"127.0.0.1:{port}"
    finally:
        server.terminate()
        server.wait(timeout=20)


def solve(url, definition, **values):
    trees = [
        {"ParamName": f"RH_IN:{name}", "InnerTree": {path: [{"data": item} for item in items] for path, items in tree.items()}}
        for name, tree in values.items()
    ]
    algo = base64.b64encode(definition.read_bytes()).decode()
    return requests.post(f"{url}/grasshopper", json={"algo": algo, "values": trees}, timeout=60)


def output(reply):
    assert reply.status_code == 200, reply.text
    [tree] = reply.json()["values"]
    return {path: [json.loads(item["data"]) for item in items] for path, items in tree["InnerTree"].items()}


def test_the_real_server_of_components(hops, gh):
    with serving("--allow-url", hops) as (url, _):
        add = gh(kd(f"http://{hops}/add", [("A", "Number"), ("B", "Number")], "Sum"))
        assert output(solve(url, add, A={"{0}": [1, 2, 3]}, B={"{0}": [10]})) == {"{0}": [11, 12, 13]}
        assert output(solve(url, add, A={"{2;1}": [4]}, B={"{2;1}": [0.5]})) == {"{2;1}": [4.5]}
        tree = gh(kd(f"http://{hops}/tree", [("N", "Number")], "S"))
        assert output(solve(url, tree, N={"{0;0}": [1, 2], "{0;1}": [3, 4, 5]})) == {"{0;0}": [3], "{0;1}": [12]}
        at = gh(kd(f"http://{hops}/pointat", [("Curve", "Curve"), ("t", "Number")], "P"))
        line = json.dumps({"From": {"X": 0, "Y": 0, "Z": 0}, "To": {"X": 4, "Y": 2, "Z": 0}})
        [point] = output(solve(url, at, Curve={"{0}": [line]}, t={"{0}": [0]}))["{0}"]
        assert (point["X"], point["Y"], point["Z"]) == (0, 0, 0)
        gone = solve(url, gh(kd(f"http://{hops}/nobody", [("A", "Number")], "S")), A={"{0}": [1]})
        assert gone.status_code == 500 and gone.json()["errors"]
    with serving() as (url, _):
        refused = solve(url, add, A={"{0}": [1]}, B={"{0}": [1]})
        assert refused.status_code == 500 and "fetched from elsewhere" in refused.json()["errors"][0]


def test_the_command_line(hops, gh):
    add = gh(kd(f"http://{hops}/add", [("A", "Number"), ("B", "Number")], "Sum"))
    run = [BINARY, "run", add, "--set", "A=4", "--set", "B=[1, 2]", "--json=values"]
    done = subprocess.run([*run, "--allow-url", hops], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    objects = {one["nickname"]: one for one in json.loads(done.stdout)["objects"]}
    assert objects["x"]["outputs"][0]["branches"][0]["items"] == [5, 6]
    assert subprocess.run(run, capture_output=True, timeout=60).returncode == 1


def test_definitions_that_lie_elsewhere(files, gh):
    host, held = files
    held["/double.gh"] = gh(DOUBLE, "double").read_bytes()
    definition = gh(kd(f"http://{host}/double.gh", [("N", "Number")], "D"))
    with serving("--allow-url", host) as (url, _):
        assert output(solve(url, definition, N={"{0}": [1, 2]})) == {"{0}": [2, 4]}
        # Another server solves them where one is named.
        with serving("--allow-url", host, "--hops-server", url) as (asking, _):
            assert output(solve(asking, definition, N={"{0}": [1, 2]})) == {"{0}": [2, 4]}
    # A file that lies beside the definition is read by who runs it here, and by no server.
    beside = gh(kd("C:\\gone\\double.gh", [("N", "Number")], "D"), "beside")
    done = subprocess.run([BINARY, "run", beside, "--set", "N=4", "--json=values"], capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    with serving() as (url, _):
        assert "may not be read" in solve(url, beside, N={"{0}": [1]}).text


def test_definitions_that_call_themselves_end(files, gh):
    host, held = files
    itself = gh(kd(f"http://{host}/self.gh", [("N", "Number")], "x"))
    held["/self.gh"] = itself.read_bytes()
    with serving("--allow-url", host) as (url, _):
        reply = solve(url, itself, N={"{0}": [1]})
        assert reply.status_code == 500 and "more than 10 times" in reply.text
        # Through the port too: each level is a request of its own.
        with serving("--allow-url", host, "--hops-server", url) as (asking, _):
            assert "more than 10 times" in solve(asking, itself, N={"{0}": [1]}).text
        assert requests.get(f"{url}/healthcheck", timeout=60).text == "Healthy"
