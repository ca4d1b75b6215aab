"""Studies from Python: the table of `katydid sweep` byte for byte, points that a program asks for, problems for optimisers."""

import json
import math
import os
import subprocess
import sys

import pytest

import katydid
from katydid.studies import Problem, cma_objective
from katydid.studies.schedule import ATTEMPTS, Lost, Schedule

TEXT = ("x = Number Slider(1, 0.00..2.00)\nn = Number Slider(3, 1..5)\non = Boolean Toggle(true)\n"
        "root = Expression(\"Sqrt(x - 1) * n\", x = x, n = n)\nsum = Addition(x, n)\nsize = Multiplication(sum, on)\n")
PLAN = {"inputs": {"x": {"steps": 21}, "n": {}}, "outputs": ["sum", "root"]}
SPACE = {"inputs": {"x": {}, "n": {}}, "outputs": ["sum", "root"]}
TABLES = ("table.parquet", "data.csv", "failed.csv")


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "definition.kd"
    path.write_text("katydid 1\n" + TEXT)
    return path


def tables(folder):
    found = {}
    for name in TABLES:
        with open(os.path.join(folder, name), "rb") as table:
            found[name] = table.read()
    return found


def command(file, folder, plan, *words):
    return subprocess.run([sys.executable, "-m", "katydid", "sweep", str(file), "--plan", str(plan), "-o", str(folder), *words],
                          capture_output=True, text=True, env={**os.environ, "PYTHONPATH": package()})


def package():
    return os.path.dirname(os.path.dirname(os.path.abspath(katydid.__file__)))


def test_a_study_writes_the_tables_of_the_command(file, tmp_path):
    plan = tmp_path / "plan.json"
    plan.write_text(json.dumps(PLAN))
    assert command(file, tmp_path / "a", plan).returncode == 1
    seen = []
    summary = katydid.study(file, PLAN, tmp_path / "b").run(workers=2, progress=seen.append)
    assert (summary.points, summary.solved, summary.had, summary.failed) == (105, 105, 0, 50)
    assert seen[-1].solved <= 105 and tables(tmp_path / "a") == tables(tmp_path / "b")
    # The command goes on with what Python has begun, and the other way round.
    again = command(file, tmp_path / "b", tmp_path / "b" / "plan.json")
    assert "0 solved now, 105 known before" in again.stderr, again.stderr
    assert katydid.study(file, plan, tmp_path / "a").run().solved == 0


def test_points_that_are_asked_for_are_rows_of_the_table(file, tmp_path):
    folder = tmp_path / "s"
    with katydid.study(file, SPACE, folder) as study:
        assert [(given.name, given.low, given.high, given.step) for given in study.inputs] == [
            ("x", 0.0, 2.0, None), ("n", 1.0, 5.0, 1.0)]
        table = study.evaluate([{"x": 1.25, "n": 2}, {"x": 0.5, "n": 2}, {"x": 1.254, "n": 2.2}, {"x": 9, "n": 1}])
        assert list(table["in.x"]) == [1.25, 0.5, 1.25, 9.0] and list(table["n"]) == [2, 2, 2, 1]
        assert table["root"][0] == 1.0 and table["sum"][0] == 3.25 and table.ok == [True, False, True, False]
        assert table.status[3] == "refused" and "0 to 2" in table.reason[3] and math.isnan(table["sum"][3])
        more = study.evaluate({"x": [1.25, 1.0], "n": [2, 5]})
        assert list(more["sum"]) == [3.25, 6.0] and list(study.table()["x"]) == [1.25, 0.5, 9.0, 1.0]
        assert study.evaluate([[2, 1]])["sum"][0] == 3.0
    first = tables(folder)
    assert first["data.csv"].count(b"\n") == 6
    # Another process goes on with it: what it asks for again is not solved, and what is new comes behind.
    with katydid.study(file, SPACE, folder) as study:
        study.evaluate([[2, 1], [1.25, 2]])
    assert tables(folder) == first
    with katydid.study(file, SPACE, folder) as study:
        study.evaluate([[2, 2]])
    assert tables(folder)["data.csv"].splitlines()[:6] == first["data.csv"].splitlines()


def test_what_is_wrong_is_named(file, tmp_path):
    study = katydid.study(file, SPACE, tmp_path / "s")
    for points, word in (([{"x": 1}], "no value for 'n'"), ([{"x": 1, "n": 1, "z": 2}], "no input 'z'"), ([[1]], "has 1 values"),
                         ([[math.nan, 1]], "'x'"), ({"x": [1], "n": [1, 2]}, "one length")):
        with pytest.raises(katydid.InputError, match=word):
            study.evaluate(points)
    with pytest.raises(katydid.InputError, match="no points"):
        study.run()
    with pytest.raises(katydid.NotSupportedError, match="spark"):
        katydid.study(file, PLAN, tmp_path / "p").run(engine="spark")
    with pytest.raises(katydid.InputError, match="nobody"):
        katydid.study(file, {**PLAN, "outputs": ["nobody"]}, tmp_path / "q")
    with pytest.raises(katydid.KatydidError, match="there is no such file"):
        katydid.study(tmp_path / "gone.kd", PLAN, tmp_path / "r")
    (tmp_path / "full").write_text("a file, no folder")
    with pytest.raises(katydid.FileError, match="full"):
        katydid.study(file, PLAN, tmp_path / "full" / "s")
    definition = katydid.open(file)
    definition.set("x", 1.5)
    with pytest.raises(katydid.InputError, match="save it"):
        katydid.study(definition, PLAN, tmp_path / "s")


def test_an_exception_of_progress_ends_a_study_that_goes_on_later(file, tmp_path):
    plan = {"inputs": {"x": {"steps": 201}, "n": {}}, "outputs": ["sum"]}

    def stop(now):
        raise ZeroDivisionError
    study = katydid.study(file, plan, tmp_path / "s")
    with pytest.raises(ZeroDivisionError):
        study.run(progress=stop)
    summary = study.run()
    assert summary.had + summary.solved == 1005


def test_goals_and_constraints(file, tmp_path):
    study = katydid.study(file, {**SPACE, "inputs": {"x": {}, "n": {}, "on": {}}, "outputs": ["sum", "root", "size"]}, tmp_path / "s")
    problem = Problem(study, minimise="sum", maximise=["root"], at_most={"size": 4.0})
    goals, misses = problem.evaluate([{"x": 1.25, "n": 2, "on": True}, {"x": 2, "n": 5, "on": True}, {"x": 0, "n": 1, "on": False}])
    assert goals[0] == [3.25, -1.0] and misses[0] == [-0.75] and misses[1] == [3.0]
    assert goals[2] == [math.inf, math.inf] and misses[2] == [math.inf]
    with pytest.raises(katydid.NotSupportedError, match="'on'"):
        cma_objective(study, "sum")
    with pytest.raises(katydid.InputError, match="no output 'area'"):
        Problem(study, "area")
    with pytest.raises(katydid.NotSupportedError, match="2 goals"):
        problem.scalar([])
    numbers = katydid.study(file, SPACE, tmp_path / "t")
    objective = cma_objective(numbers, minimise="root", at_least={"sum": 4.0})
    # root is 0 at x = 1, where sum is 1 + n: it misses 4 by 2 for n = 1, and holds for n = 3.
    assert objective([[0.5, 0.0], [0.5, 0.5], [1.0, 1.0]]) == [5.0 + 2.0, 0.0, 5.0]
    assert objective([0.5, 0.5]) == 0.0 and objective.point([0.5, 0.5]) == {"x": 1.0, "n": 3.0}


class Pool:
    """Workers in this process. `kills` ends one, `hangs` leaves it without an answer."""

    def __init__(self, workers=2, kills=lambda points: False, hangs=lambda points: False):
        self.count, self.kills, self.hangs = workers, kills, hangs
        self.running, self.done, self.lost, self.ended = {}, [], 0, 0

    def workers(self):
        return self.count

    def room(self):
        return self.count - len(self.running)

    def begin(self, points):
        handle = object()
        self.running[handle] = points
        return handle

    def wait(self, seconds):
        for handle, points in list(self.running.items()):
            if self.hangs(points):
                continue
            del self.running[handle]
            if self.kills(points):
                self.lost += 1
                yield handle, Lost("killed")
            else:
                self.done += points
                yield handle, (points, [], 1e-6 * len(points))

    def end(self, handle):
        self.ended += 1
        self.running.pop(handle)


def scheduled(pool, count, **more):
    rest, kept, given_up = list(range(count)), [], {}

    def take(most):
        taken = rest[:most]
        del rest[:most]
        return taken
    Schedule(pool, take, lambda records, files: kept.extend(records), lambda point, why, seconds: given_up.update({point: why}),
             left=lambda: len(rest), **more).run()
    return kept, given_up


def test_batches_of_workers_that_end_are_solved_again():
    deaths = iter([True, False, True, True, False, False, True])
    pool = Pool(kills=lambda points: next(deaths, False))
    kept, given_up = scheduled(pool, 5000)
    assert sorted(kept) == list(range(5000)) and not given_up and pool.lost == 4


def test_a_point_that_ends_its_worker_each_time_is_given_up_alone():
    pool = Pool(kills=lambda points: 777 in points)
    kept, given_up = scheduled(pool, 2000)
    assert sorted(kept) == [point for point in range(2000) if point != 777]
    assert list(given_up) == [777] and "%d times" % ATTEMPTS in given_up[777]


def test_a_point_that_hangs_is_given_up_alone():
    pool = Pool(hangs=lambda points: 50 in points)
    kept, given_up = scheduled(pool, 100, limit=0.01, grace=0.02)
    assert sorted(kept) == [point for point in range(100) if point != 50]
    assert list(given_up) == [50] and "no answer" in given_up[50] and pool.ended >= ATTEMPTS


def test_an_engine_that_is_not_installed_is_named(file, tmp_path):
    code = ("import sys\nsys.modules[%r] = None\nimport katydid\n"
            "katydid.study(sys.argv[1], {'inputs': {'n': {}}, 'sample': 'grid', 'outputs': ['sum']}, sys.argv[2]).run(engine=%r)\n")
    for engine, module in (("ray", "ray"), ("dask", "distributed")):
        run = subprocess.run([sys.executable, "-c", code % (module, engine), str(file), str(tmp_path / engine)],
                             capture_output=True, text=True, env={**os.environ, "PYTHONPATH": package()})
        assert "NotSupportedError" in run.stderr and "pip install \"katydid[%s]\"" % engine in run.stderr


def test_the_command_says_what_its_cluster_lacks(file, tmp_path):
    pytest.importorskip("katydid._katydid")
    try:
        import ray  # noqa: F401
        pytest.skip("ray is installed")
    except ImportError:
        pass
    plan = tmp_path / "plan.json"
    plan.write_text(json.dumps(PLAN))
    run = command(file, tmp_path / "a", plan, "--ray", "auto")
    assert run.returncode == 2 and "no package ray" in run.stderr and "katydid[ray]" in run.stderr
