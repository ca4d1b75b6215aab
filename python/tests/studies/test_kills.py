"""`katydid sweep` under kill -9, full disks and points that fail: what is solved stays, the rest goes on."""

import json
import os
import random
import re
import signal
import subprocess
import sys
import time

import pytest
from conftest import plan, program, sweep, tables, work

POINTS = int(os.environ.get("KATYDID_STUDY_POINTS", "10000"))
ITEMS = int(os.environ.get("KATYDID_STUDY_ITEMS", "3000"))


def test_ten_kills_and_no_finished_point_is_solved_again(tmp_path):
    file, points = work(tmp_path, ITEMS), plan(tmp_path, POINTS)
    begun = time.monotonic()
    sweep(file, "--plan", points, "-o", tmp_path / "whole", "--workers", "2")
    seconds = time.monotonic() - begun
    numbers = random.Random(7)
    words = [program(), "sweep", file, "--plan", points, "-o", str(tmp_path / "killed"), "--workers", "2"]
    killed = 0
    for _ in range(10):
        process = subprocess.Popen(words, stderr=subprocess.DEVNULL)
        time.sleep(numbers.uniform(0.02, seconds / 6))
        killed += process.poll() is None
        process.send_signal(signal.SIGKILL)
        process.wait()
    cache, = (tmp_path / "killed" / "cache").glob("*.kdstudy")
    before = cache.read_bytes()
    last = subprocess.run(words, capture_output=True, text=True)
    solved, had = map(int, re.search(r"(\d+) solved now, (\d+) known before", last.stderr).groups())
    assert killed >= 5 and solved + had == POINTS and had > 0, (killed, last.stderr)
    assert tables(tmp_path / "killed") == tables(tmp_path / "whole")
    # The file of results only grew, by a record for each point that was not in it: no point has two.
    after = cache.read_bytes()
    whole, = (tmp_path / "whole" / "cache").glob("*.kdstudy")
    assert len(after) == whole.stat().st_size
    # What the last kill cut off may be the end of one record.
    assert os.path.commonprefix([before, after]) >= before[:-4096]


def mounted(options, code, *words):
    """Python code in a mount namespace of its own, where /mnt is a small disk in memory."""
    script = "mount -t tmpfs -o %s none /mnt && exec \"$@\"" % options
    run = subprocess.run(["unshare", "-m", "sh", "-c", script, "sh", sys.executable, "-c", code, *map(str, words)],
                         capture_output=True, text=True)
    if "unshare" in run.stderr or "mount" in run.stderr.split("\n")[0]:
        pytest.skip("no file system can be mounted: " + run.stderr)
    return run


FULL = """
import katydid, os, sys
study = katydid.study(sys.argv[1], sys.argv[2], "/mnt/s")
for engine in sys.argv[3:]:
    try:
        study.run(engine=engine, workers=2, **({"address": "local"} if engine != "local" else {}))
    except katydid.FileError as error:
        print("full:", error)
held = open("/mnt/ballast", "rb")
os.remove("/mnt/ballast")
held.close()
summary = study.run()
print(summary.had > 0, summary.had + summary.solved, summary.failed)
"""


def test_a_full_disk_is_named_and_the_study_goes_on_when_there_is_room(tmp_path):
    file, points = work(tmp_path, 10), plan(tmp_path, 10000)
    code = "open('/mnt/ballast', 'wb').write(bytes(11_600_000))\n" + FULL
    run = mounted("size=12m", code, file, points, "local", "dask")
    lines = run.stdout.splitlines()
    assert len(lines) == 3, run.stdout + run.stderr
    for line in lines[:2]:
        assert line.startswith("full: /mnt/s/") and "No space left" in line, lines
    assert lines[2] == "True 10000 0", lines


def test_a_folder_that_cannot_be_written_is_named(tmp_path):
    code = ("import katydid, sys\ntry:\n    katydid.study(sys.argv[1], sys.argv[2], '/mnt/s').run()\n"
            "except katydid.FileError as error:\n    print(error)\n")
    run = mounted("size=1m,ro", code, work(tmp_path, 10), plan(tmp_path, 100))
    assert "/mnt/s" in run.stdout and "Read-only" in run.stdout, run.stdout + run.stderr


def test_points_that_fail_are_named_and_the_rest_goes_on(tmp_path):
    file = tmp_path / "bad.kd"
    # 1/x is infinite at 0, the logarithm of a negative number is none, and 4 makes a list without end.
    file.write_text("katydid 1\nx = Number Slider(1, -1..4)\nn = Expression(\"If(x = 4, 2000000000, 1)\", x = x)\n"
                    "s = Series(0, 1, n)\nr = Expression(\"1/x\", x = x)\nl = Expression(\"Ln(x)\", x = x)\nc = List Length(s)\n")
    whole = {"inputs": {"x": {}}, "outputs": ["r", "l", "c"]}
    path = tmp_path / "plan.json"
    path.write_text(json.dumps(whole))
    run = sweep(file, "--plan", path, "-o", tmp_path / "s", "--limit-seconds", "5", "--limit-bytes", "200000000")
    rows = [line.split(",") for line in (tmp_path / "s" / "data.csv").read_text().splitlines()]
    status = {row[0]: row[rows[0].index("status")] for row in rows[1:]}
    assert run.returncode == 1 and len(status) == 6
    assert status["1"] == status["2"] == status["3"] == "ok", status
    assert all(status[x] not in ("ok", "warning") for x in ("-1", "0", "4")), status
    failed = (tmp_path / "s" / "failed.csv").read_text()
    assert failed.count("\n") == 4 and "3 without results" in run.stderr, failed
