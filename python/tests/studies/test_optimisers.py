"""Our NSGA-II beside pymoo's and our CMA-ES beside cma, on the same definitions with the same number of solves."""

import csv
import os
import statistics
import subprocess

import pytest
from conftest import program

import katydid
from katydid import studies

SEEDS = range(1, 6)
#: Where a population may end at one end of the front, as with 30 inputs, medians of five runs say little.
MORE_SEEDS = range(1, 12)
NAMES = {6: "abcdeh", 30: ["v%d" % k for k in range(30)]}
#: Behind (1.1, 1.1): the square of 1.1 less what lies below the front and beside it.
WHOLE = {1: 1.21 - 1 / 3, 2: 1.21 - 2 / 3, 3: 1.33176}


def zdt(folder, kind, n):
    """Zitzler, Deb, Thiele 2000: fronts 1 - sqrt(f), 1 - f^2, and five pieces of 1 - sqrt(f) - f sin(10 pi f)."""
    names = list(NAMES[n])
    first, rest = names[0], names[1:]
    g = "(1 + 9*(%s)/%d)" % (" + ".join(rest), n - 1)
    second = {1: "{g}*(1 - Sqrt({a}/{g}))", 2: "{g}*(1 - ({a}/{g})^2)",
              3: "{g}*(1 - Sqrt({a}/{g}) - {a}/{g}*Sin(31.41592653589793*{a}))"}[kind].format(g=g, a=first)
    text = "katydid 1\n" + "".join("%s = Number Slider(0.5, 0.000000..1.000000)\n" % name for name in names)
    text += "f = Expression(\"%s\", %s = %s)\n" % (first, first, first)
    text += "z = Expression(\"%s\", %s)\n" % (second, ", ".join("%s = %s" % (name, name) for name in names))
    file = os.path.join(str(folder), "zdt%d-%d.kd" % (kind, n))
    with open(file, "w", encoding="utf-8") as out:
        out.write(text)
    return file, {"inputs": {name: {} for name in names}, "outputs": ["f", "z"]}


def volume(points):
    """The area between a front of two goals and (1.1, 1.1)."""
    top, area = 1.1, 0.0
    for x, y in sorted(points):
        if x < 1.1 and y < top:
            area += (1.1 - x) * (top - y)
            top = y
    return area


def rows(folder):
    with open(os.path.join(str(folder), "data.csv"), encoding="utf-8", newline="") as table:
        return list(csv.DictReader(table))


def optimise(file, folder, *words):
    run = subprocess.run([program(), "optimise", file, "-o", str(folder), *map(str, words)], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return rows(folder)


@pytest.mark.parametrize("n, size, solves", [(6, 100, 8000), (6, 60, 6000), (30, 100, 8000)])
@pytest.mark.parametrize("kind", [1, 2, 3])
def test_nsga2_reaches_the_front_that_pymoo_reaches(tmp_path, kind, n, size, solves):
    pytest.importorskip("pymoo")
    from pymoo.algorithms.moo.nsga2 import NSGA2
    from pymoo.optimize import minimize
    file, space = zdt(tmp_path, kind, n)
    ours, theirs = [], []
    for seed in SEEDS if n < 30 else MORE_SEEDS:
        table = optimise(file, tmp_path / ("ours%d" % seed), "--minimise", "f", "--minimise", "z", "--method", "nsga2",
                         "--population", size, "--evaluations", solves, "--seed", seed)
        assert len(table) <= solves
        ours.append(volume((float(row["out:f"]), float(row["out:z"])) for row in table) / WHOLE[kind])
        with katydid.study(file, space, tmp_path / ("theirs%d" % seed)) as study:
            minimize(studies.pymoo_problem(study, minimise=["f", "z"]), NSGA2(pop_size=size), ("n_eval", solves), seed=seed)
        # Both by all points that were solved.
        table = rows(study.folder)
        theirs.append(volume((float(row["out:f"]), float(row["out:z"])) for row in table) / WHOLE[kind])
    a, b = statistics.median(ours), statistics.median(theirs)
    print("\nzdt%d, %d inputs, population %d, %d solves: ours %.4f (%.4f to %.4f), pymoo %.4f (%.4f to %.4f)"
          % (kind, n, size, solves, a, min(ours), max(ours), b, min(theirs), max(theirs)))
    assert a >= 0.98 * b


@pytest.mark.parametrize("n, solves", [(2, 600), (5, 4000), (10, 12000)])
def test_cma_es_finds_the_least_of_rosenbrocks_function_as_cma_does(tmp_path, n, solves):
    cma = pytest.importorskip("cma")
    names = ["x%d" % k for k in range(n)]
    terms = " + ".join("100*(%s - %s^2)^2 + (1 - %s)^2" % (b, a, a) for a, b in zip(names, names[1:]))
    text = "katydid 1\n" + "".join("%s = Number Slider(0, -2.0000000..2.0000000)\n" % name for name in names)
    text += "f = Expression(\"%s\", %s)\n" % (terms, ", ".join("%s = %s" % (name, name) for name in names))
    file = tmp_path / "rosenbrock.kd"
    file.write_text(text)
    space = {"inputs": {name: {} for name in names}, "outputs": ["f"]}
    ours, theirs = [], []
    for seed in SEEDS:
        table = optimise(file, tmp_path / ("ours%d" % seed), "--minimise", "f", "--evaluations", solves, "--seed", seed)
        ours.append(min(float(row["out:f"]) for row in table))
        with katydid.study(file, space, tmp_path / ("theirs%d" % seed)) as study:
            objective = studies.cma_objective(study, minimise="f")
            cma.fmin2(None, objective.x0, objective.sigma0,
                      {**objective.options, "seed": seed, "maxfevals": solves, "verbose": -9}, restarts=4, bipop=False,
                      parallel_objective=objective)
        theirs.append(min(float(row["out:f"]) for row in rows(study.folder)))
    a, b = statistics.median(ours), statistics.median(theirs)
    print("\nRosenbrock, %d inputs, %d solves: ours %.3g (%.3g to %.3g), cma %.3g (%.3g to %.3g)"
          % (n, solves, a, min(ours), max(ours), b, min(theirs), max(theirs)))
    # The least is 0; sliders of seven digits do not get below the square of a hundred of theirs.
    assert a <= 1.02 * b + 1e-9


def test_pymoo_moves_whole_numbers_and_choices(tmp_path):
    pytest.importorskip("pymoo")
    from pymoo.core.mixed import MixedVariableGA
    from pymoo.optimize import minimize
    file = tmp_path / "mixed.kd"
    file.write_text("katydid 1\nx = Number Slider(0.5, 0.000..2.000)\nn = Number Slider(1, 1..9)\non = Boolean Toggle(false)\n"
                    "f = Expression(\"x*n + If(on, 1, 0)\", x = x, n = n, on = on)\ns = Addition(x, n)\n")
    space = {"inputs": {"x": {}, "n": {}, "on": {}}, "outputs": ["f", "s"]}
    with katydid.study(file, space, tmp_path / "s") as study:
        problem = studies.pymoo_problem(study, maximise="f", at_most={"s": 7.0})
        found = minimize(problem, MixedVariableGA(pop_size=20), ("n_eval", 1000), seed=1)
    # x = 2 by its range, n = 5 by the constraint, and the toggle on.
    assert found.X["on"] and found.X["n"] == 5 and -found.F[0] > 10.95
    assert max(float(row["out:f"]) for row in rows(study.folder) if float(row["out:s"]) <= 7.0) == pytest.approx(-found.F[0])


def test_optuna_is_told_what_its_trials_gave(tmp_path):
    optuna = pytest.importorskip("optuna")
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    file = tmp_path / "f.kd"
    file.write_text("katydid 1\nx = Number Slider(0.5, 0.000..2.000)\nn = Number Slider(1, 1..9)\n"
                    "f = Expression(\"Sqrt(x - 0.5) + (n - 4)^2\", x = x, n = n)\n")
    space = {"inputs": {"x": {}, "n": {}}, "outputs": ["f"]}
    with katydid.study(file, space, tmp_path / "s") as study:
        search = optuna.create_study(sampler=optuna.samplers.TPESampler(seed=1))
        studies.optuna_trials(search, study, minimise="f", trials=120, batch=8)
        with pytest.raises(katydid.InputError, match="maximize"):
            studies.optuna_trials(search, study, maximise="f")
    states = {trial.state.name for trial in search.trials}
    assert len(search.trials) == 120 and states == {"COMPLETE", "FAIL"}
    assert search.best_params["n"] == 4 and search.best_value < 0.5
    assert len(rows(study.folder)) <= 120
