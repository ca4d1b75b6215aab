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
