"""Studies with Dask: processes on this machine, one killed half way."""

import logging
import os
import signal
import time

import pytest
from conftest import plan, sweep, tables, work

import katydid

distributed = pytest.importorskip("distributed")

POINTS = int(os.environ.get("KATYDID_STUDY_POINTS", "10000"))
ITEMS = int(os.environ.get("KATYDID_STUDY_ITEMS", "3000"))


@pytest.fixture(scope="module")
def client():
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=logging.ERROR) as cluster:
        with distributed.Client(cluster) as made:
            yield made


def test_a_killed_worker_and_the_table_of_the_sweep(client, tmp_path):
    file, points = work(tmp_path, ITEMS), plan(tmp_path, POINTS)
    begun = time.monotonic()
    sweep(file, "--plan", points, "-o", tmp_path / "local", "--workers", "2")
    local = time.monotonic() - begun
    killed = []

    def kill(now):
        if now.solved >= POINTS // 2 and not killed:
            killed.append(list(client.run(os.getpid).values())[0])
            os.kill(killed[0], signal.SIGKILL)
    study = katydid.study(file, points, tmp_path / "dask")
    begun = time.monotonic()
    summary = study.run(engine="dask", address=client, progress=kill)
    seconds = time.monotonic() - begun
    assert killed and (summary.solved, summary.had, summary.failed) == (POINTS, 0, 0)
    assert tables(tmp_path / "dask") == tables(tmp_path / "local")
    print("\ndask %.1f s, local %.1f s: %.2f times" % (seconds, local, seconds / local))


def test_a_scheduler_by_its_address_and_a_local_one(client, tmp_path):
    file, points = work(tmp_path, 10), plan(tmp_path, 500)
    first = katydid.study(file, points, tmp_path / "a").run(engine="dask", address=client.scheduler.address)
    second = katydid.study(file, points, tmp_path / "b").run(engine="dask", workers=2)
    assert first.solved == second.solved == 500
    assert tables(tmp_path / "a") == tables(tmp_path / "b")


def test_an_error_of_a_worker_ends_the_study(client, tmp_path):
    study = katydid.study(work(tmp_path, 10), plan(tmp_path, 500), tmp_path / "s")
    study._words = study._words + ["--limit-seconds", "no number"]
    with pytest.raises(katydid.KatydidError, match="limit-seconds"):
        study.run(engine="dask", address=client)
