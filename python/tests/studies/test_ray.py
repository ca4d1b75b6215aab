"""Studies on Ray: two nodes on this machine, a worker killed half way, the command line, a point that ends its worker."""

import os
import signal
import subprocess
import sys
import time

import pytest
from conftest import plan, program, sweep, tables, work

import katydid

ray = pytest.importorskip("ray")
psutil = pytest.importorskip("psutil")

POINTS = int(os.environ.get("KATYDID_STUDY_POINTS", "10000"))
ITEMS = int(os.environ.get("KATYDID_STUDY_ITEMS", "3000"))


@pytest.fixture(scope="module")
def cluster():
    """Two nodes with a processor each, both on this machine. Ray takes no address of the loopback for a node."""
    from ray.cluster_utils import Cluster
    made = Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
    made.add_node(num_cpus=1)
    yield made
    ray.shutdown()
    made.shutdown()


def actors():
    """The processes of our actors that are running."""
    found = []
    for process in psutil.process_iter(["cmdline"]):
        words = process.info["cmdline"] or []
        if words and words[0].startswith("ray::PointWorker"):
            found.append(process)
    return found


def test_two_nodes_and_a_killed_worker_give_the_table_of_the_sweep(cluster, tmp_path):
    file, points = work(tmp_path, ITEMS), plan(tmp_path, POINTS)
    begun = time.monotonic()
    sweep(file, "--plan", points, "-o", tmp_path / "local", "--workers", "2")
    local = time.monotonic() - begun
    killed = []

    def kill(now):
        if now.solved >= POINTS // 2 and not killed:
            victim = actors()[0]
            killed.append(victim.pid)
            os.kill(victim.pid, signal.SIGKILL)
    study = katydid.study(file, points, tmp_path / "ray")
    begun = time.monotonic()
    summary = study.run(engine="ray", address=cluster.address, progress=kill)
    seconds = time.monotonic() - begun
    assert killed and (summary.solved, summary.had, summary.failed) == (POINTS, 0, 0)
    assert tables(tmp_path / "ray") == tables(tmp_path / "local")
    print("\nray %.1f s, local %.1f s: %.2f times" % (seconds, local, seconds / local))
    # Nothing is solved again, and a larger plan has only its new points solved.
    assert study.run(engine="ray", address=cluster.address).solved == 0


def test_a_cluster_that_grows_has_its_new_processors_used(tmp_path):
    from ray.cluster_utils import Cluster
    ray.shutdown()
    made = Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
    file, points = work(tmp_path, ITEMS), plan(tmp_path, POINTS)
    most = []

    def watch(now):
        if not most:
            made.add_node(num_cpus=1)
        most.append(len(actors()))
    try:
        summary = katydid.study(file, points, tmp_path / "s").run(engine="ray", address=made.address, progress=watch)
        assert summary.solved == POINTS and most[0] == 1 and max(most) == 2
    finally:
        ray.shutdown()
        made.shutdown()


def test_the_command_solves_on_a_cluster(tmp_path):
    file, points = work(tmp_path, 10), plan(tmp_path, 500)
    environment = {**os.environ, "KATYDID_PYTHON": sys.executable}
    run = subprocess.run([program(), "sweep", file, "--plan", points, "-o", str(tmp_path / "a"), "--ray", "local", "--workers", "2"],
                         capture_output=True, text=True, env=environment)
    assert run.returncode == 0, run.stderr
    assert "500 points: 500 solved now" in run.stderr
    sweep(file, "--plan", points, "-o", tmp_path / "b")
    assert tables(tmp_path / "a") == tables(tmp_path / "b")
    gone = subprocess.run([program(), "sweep", file, "--plan", points, "-o", str(tmp_path / "c"), "--ray", "127.0.0.1:1"],
                          capture_output=True, text=True, env=environment)
    assert gone.returncode == 2 and "127.0.0.1:1 cannot be reached" in gone.stderr, gone.stderr
    wrong = subprocess.run([program(), "sweep", file, "--plan", points, "-o", str(tmp_path / "c"), "--ray", "auto"],
                           capture_output=True, text=True, env={**os.environ, "KATYDID_PYTHON": "/nowhere/python3"})
    assert wrong.returncode == 2 and "/nowhere/python3" in wrong.stderr


def test_asked_points_are_solved_on_a_cluster(tmp_path):
    ray.shutdown()
    space = {"inputs": {"a": {}, "b": {}}, "outputs": ["total.Result"]}
    with katydid.study(work(tmp_path, 10), space, tmp_path / "s") as study:
        near = study.evaluate([[0.25, 1], [0.5, 2]])
        far = study.evaluate([[0.5, 2], [0.75, 3]], engine="ray", address="local", workers=2)
        assert far["total.Result"][0] == near["total.Result"][1] and far.ok == [True, True]
        assert study.evaluate([[0.1, 3]], engine="ray", address="local", workers=2).ok == [True]
        assert study.table().rows == 4
    assert not ray.is_initialized()


def test_a_definition_that_workers_cannot_open_ends_the_study(tmp_path):
    ray.shutdown()
    file, points = work(tmp_path, 10), plan(tmp_path, 500)
    study = katydid.study(file, points, tmp_path / "s")
    study._words = study._words + ["--limit-seconds", "no number"]
    with pytest.raises(katydid.KatydidError, match="limit-seconds"):
        study.run(engine="ray", address="local", workers=2)


def test_pictures_and_geometry_come_back(tmp_path):
    file = tmp_path / "circle.kd"
    file.write_text("katydid 1\nr = Number Slider(2, 1..9)\nc = Circle(plane((0, 0, 0)), r)\n")
    whole = {"inputs": {"r": {}}, "sample": "grid", "pictures": True, "geometry": "glb"}
    names = []
    for engine, how in (("local", {}), ("ray", {"address": "local", "workers": 2})):
        folder = tmp_path / engine
        assert katydid.study(file, whole, folder).run(engine=engine, **how).failed == 0
        names.append([sorted(os.listdir(folder / kind)) for kind in ("pictures", "geometry")])
    assert names[0] == names[1] and names[0][0] and len(names[0][1]) == 9
    assert tables(tmp_path / "local") == tables(tmp_path / "ray")
