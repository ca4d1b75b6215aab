"""The command line that comes with the package."""

import os
import subprocess
import sys

import katydid

FOLDER = os.path.dirname(os.path.dirname(os.path.abspath(katydid.__file__)))


def command(*words):
    return subprocess.run([sys.executable, "-m", "katydid", *words], cwd=FOLDER, capture_output=True, text=True)


def test_the_command_runs_a_definition_and_says_how_it_went(tmp_path):
    file = tmp_path / "a.kd"
    file.write_text("katydid 1\nx = Number Slider(2, 0..10)\ny = Multiplication(x, 3)\n")
    run = command("run", str(file), "--set", "x=5", "--json")
    assert run.returncode == 0 and '"15"' in run.stdout
    assert command("run", str(tmp_path / "none.gh")).returncode == 2
    assert command("--version").stdout.startswith("katydid ")
    assert command("nonsense").returncode == 2


def test_a_server_starts_its_second_process_through_python():
    import http.client
    import re
    import signal
    server = subprocess.Popen([sys.executable, "-m", "katydid", "serve", "--port", "0"], cwd=FOLDER,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    try:
        port = int(re.search(r":(\d+)/", server.stdout.readline()).group(1))
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=30)
        connection.request("GET", "/version")
        answer = connection.getresponse()
        assert answer.status == 200 and b"rhino" in answer.read()
        # A function of geometry is computed by the process behind.
        connection.request("POST", "/rhino/geometry/curve/getlength-curve",
                           body="[%s]" % katydid.Curve.line((0, 0, 0), (3, 4, 0)).to_json())
        answer = connection.getresponse()
        assert (answer.status, float(answer.read())) == (200, 5)
    finally:
        server.send_signal(signal.SIGTERM)
        assert server.wait(30) in (0, -signal.SIGTERM, 130, 143)
