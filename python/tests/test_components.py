"""Components as functions, over a registry of three that answers by hand."""

import math

import pytest
from hosts import WorkerProcess, codec, errors
from katydid.values import Point3d

REGISTRY = [
    {"id": "1", "name": "Addition", "nickname": "A+B", "inputs": [{"name": "First", "nickname": "A", "access": "item"},
     {"name": "Second", "nickname": "B", "access": "item"}], "outputs": [{"name": "Result", "nickname": "R"}]},
    {"id": "2", "name": "Curve | Curve", "nickname": "CCX", "inputs": [{"name": "Curve A", "nickname": "A", "access": "item"}],
     "outputs": [{"name": "Points"}, {"name": "UV Point"}, {"name": "class"}]},
    {"id": "3", "name": "Series", "nickname": "Series", "inputs": [{"name": "Count", "nickname": "C", "access": "item"}],
     "outputs": [{"name": "Series"}]},
]


def answer(request):
    """What a host answers."""
    if request[0] == "components":
        return ["ok", REGISTRY]
    if request[0] == "component":
        name, inputs = request[1], request[2]
        if len(inputs) > 2:
            return codec.Error("argument", "Addition takes 2 inputs, not 3")
        if name == "1":
            a, b = [part if isinstance(part, list) else [part] for part in inputs]
            size = max(len(a), len(b))
            rows = [a[min(i, len(a) - 1)] + b[min(i, len(b) - 1)] for i in range(size)]
            return ["ok", [codec.Tree([((0,), rows)])]]
        if name == "2":
            return ["ok", [codec.Tree([((0, 0), [Point3d(1, 0, 0)])]), codec.Tree([((0, 0), [2.0, 3.0])]), codec.Tree([])]]
        return ["ok", [codec.Tree([((0, 0), [float(i) for i in range(inputs[0])])])]]
    return ["ok", []] if request[0] == "members" else codec.Error("not_supported", str(request))


@pytest.fixture(scope="module")
def run():
    worker = WorkerProcess(answer)

    def go(code):
        values, result = worker.run("import ghpythonlib.components as ghc\n" + code)
        return values["a"], errors(result)
    yield go
    worker.close()


def test_items_and_lists(run):
    assert run("a = ghc.Addition(1, 2)") == (3, [])
    assert run("a = ghc.Addition([1, 2], 10)") == ([11, 12], [])
    assert run("a = ghc.Addition(A=1, second=5)") == (6, [])
    assert run("a = ghc.Series(3)") == ([0.0, 1.0, 2.0], []) and run("a = ghc.Series(1)") == (0.0, [])


def test_several_outputs_are_a_named_tuple(run):
    assert run("r = ghc.CurveXCurve(5)\na = [r.points.X, r.uv_point[1], r[1][0], r.uvPoint[0], r.oclass is None]") == (
        [1.0, 3.0, 2.0, 2.0, True], [])
    assert run("points, uv, none = ghc.CCX(5)\na = points") == (Point3d(1, 0, 0), [])


def test_what_is_not_there_is_named(run):
    assert "ghpythonlib.components.Wombat is not supported by Katydid yet" in run("ghc.Wombat(1)")[1][0]
    assert "Addition takes 2 inputs, not 3" in run("ghc.Addition(1, 2, 3)")[1][0]
    assert "Addition has no input C" in run("ghc.Addition(C=1)")[1][0]


def test_treehelpers_and_parallel(run):
    assert run("import ghpythonlib.treehelpers as th\nt = th.list_to_tree([[1, 2], [3]])\n"
               "a = [str(t.Paths[1]), t.Branch(0)[1], th.tree_to_list(t) == [[1, 2], [3]]]")[0] == ["{0;1}", 2, True]
    assert run("import ghpythonlib.parallel as p\na = p.run(lambda x: [x, x * x], [1, 2], True)") == ([1, 1, 2, 4], [])
    assert run("import System.Threading.Tasks as t, math\nr = []\nt.Parallel.ForEach([1, 4], lambda x: r.append(math.sqrt(x)))\n"
               "a = r") == ([1.0, math.sqrt(4)], [])
