"""The worker process: inputs, outputs, prints, errors, state, interrupts."""

import os
import signal
import time

import pytest
from hosts import WorkerProcess, codec, errors
from katydid.values import Guid, Point3d, Vector3d


@pytest.fixture()
def worker():
    made = WorkerProcess()
    yield made
    made.close()


def test_a_sum_and_a_print(worker):
    values, result = worker.run("a = x + y\nprint('sum', a)", {"x": 3, "y": 4.5})
    assert values == {"a": 7.5}
    assert result["out"] == ["sum 7.5\n"]
    assert result["messages"] == [] and result["error"] is None and result["seconds"] > 0


def test_an_output_that_is_not_set_is_null(worker):
    assert worker.run("b = 1")[0] == {"a": None}


def test_lists_tuples_generators_and_ranges_are_lists(worker):
    code = "a = [1, 'x', None]\nb = (i * i for i in range(4))\nc = range(3)\nd = (1.5, 2.5)\ne = 'abc'\nf = {3}"
    values, _ = worker.run(code, outputs="abcdef")
    assert values == {"a": [1, "x", None], "b": [0, 1, 4, 9], "c": [0, 1, 2], "d": [1.5, 2.5], "e": "abc", "f": [3]}


def test_nested_lists_and_dictionaries_are_one_object(worker):
    values, _ = worker.run("a = [[1, 2], [3]]\nb = {'k': 1}", outputs="ab")
    assert [type(one) for one in values["a"]] == [codec.Token, codec.Token]
    assert isinstance(values["b"], codec.Token)
    back, _ = worker.run("a = x[1] + y", {"x": values["a"][0], "y": 5}, key="other")
    assert back == {"a": 7}


def test_objects_come_back_as_themselves_until_forgotten(worker):
    token = worker.run("class Part:\n    size = 3\na = Part()")[0]["a"]
    assert worker.run("a = x.size", {"x": token}, key="2")[0] == {"a": 3}
    worker.send({"forget": [token.number]})
    assert worker.run("a = x is None", {"x": token}, key="2")[0] == {"a": True}


def test_trees_in_and_out(worker):
    tree = codec.Tree([((0, 1), [1, 2]), ((3,), ["z"])])
    values, _ = worker.run("x.Add(9, x.Path(1))\na = x\nb = x.BranchCount", {"x": tree}, outputs="ab")
    assert values["a"].branches == [((0, 1), [1, 2]), ((3,), ["z", 9])]
    assert values["b"] == 2


def test_an_error_names_the_line_and_the_kind(worker):
    values, result = worker.run("def f(n):\n    return n + 'x'\n\na = f(1)")
    kind, text, line = result["messages"][0]
    assert values == {"a": None} and kind == "error" and line == 2
    assert text.startswith("Runtime error (TypeError): unsupported operand")
    assert "line 4, in script" in text and "line 2, in f" in text


def test_an_error_of_memory_says_more_than_its_name(worker):
    _, result = worker.run("raise MemoryError()")
    first = errors(result)[0].splitlines()[0]
    assert first.startswith("Runtime error (MemoryError): the") and first.endswith(("memory left", "(--script-memory)"))


def test_a_module_that_is_missing_names_the_command(worker):
    _, result = worker.run("import yaml_that_nobody_has\na = 1")
    assert "to install it: katydid python add yaml_that_nobody_has" in errors(result)[0]
    _, result = worker.run("# r: some-package-nobody-has==1.2\nimport some_package\na = 1")
    assert 'to install it: katydid python add "some-package-nobody-has==1.2"' in errors(result)[0]
    _, result = worker.run("import Rhino.Nonsense\na = 1")
    assert "python add" not in errors(result)[0]


def test_assemblies_that_scripts_import_and_do_not_use_are_there(worker):
    code = "import clr\nclr.AddReference('GH_IO')\nimport GH_IO as io\na = 1"
    assert worker.run(code)[0]["a"] == 1
    _, result = worker.run(code + "\nb = io.Serialization")
    assert "GH_IO.Serialization is not supported" in errors(result)[0]


def test_a_syntax_error_names_the_line(worker):
    _, result = worker.run("a = 1\nb = = 2")
    assert result["messages"][0][2] == 2 and "Syntax error" in result["messages"][0][1]


def test_one_failing_iteration_does_not_stop_the_others(worker):
    _, result = worker.run("a = 1.0 / x", {"x": 0}, iterations=[[2], [0], [4]])
    assert result["iterations"] == [[0.5], [None], [0.25]]
    assert len(result["messages"]) == 1 and "ZeroDivisionError" in result["messages"][0][1]
    assert [text.partition(":")[0] for text in result["out"]] == ["", "Runtime error (ZeroDivisionError)", ""]


def test_variables_live_between_runs_and_sticky_across_components(worker):
    code = "import scriptcontext as sc\ncount = globals().get('count', 0) + 1\na = count\nsc.sticky['n'] = count"
    assert [worker.run(code)[0]["a"] for _ in range(3)] == [1, 2, 3]
    other = "import scriptcontext as sc\na = sc.sticky['n']"
    assert worker.run(other, key="other")[0] == {"a": 3}


def test_a_runtime_message(worker):
    code = ("from Grasshopper.Kernel import GH_RuntimeMessageLevel as L\n"
            "ghenv.Component.AddRuntimeMessage(L.Warning, 'mind')\nghenv.Component.Message = 'm'\na = str(L.Warning)")
    values, result = worker.run(code)
    assert result["messages"] == [["warning", "mind", -1]] and values == {"a": "Warning"}


def test_component_classes(worker):
    code = ("from ghpythonlib.componentbase import executingcomponent as component\n"
            "class C(component):\n"
            "    def __init__(self):\n        super(C, self).__init__()\n        self.n = 0\n"
            "    def RunScript(self, x):\n        self.n += 1\n        return x * 2, self.n\n")
    assert worker.run(code, {"x": 4}, outputs="ab")[0] == {"a": 8, "b": 1}
    assert worker.run(code, {"x": 5}, outputs="ab")[0] == {"a": 10, "b": 2}
    modern = ("import Grasshopper\nclass M(Grasshopper.Kernel.GH_ScriptInstance):\n"
              "    def RunScript(self, x: int):\n        return x + 1\n")
    assert worker.run(modern, {"x": 4}, key="m")[0] == {"a": 5}


def test_points_cross_as_points(worker):
    values, _ = worker.run("import Rhino.Geometry as rg\na = [p + rg.Vector3d(1, 0, 0) for p in x]\nb = x[1] - x[0]",
                           {"x": [Point3d(0, 0, 0), Point3d(0, 2, 0)]}, outputs="ab")
    assert values == {"a": [Point3d(1, 0, 0), Point3d(1, 2, 0)], "b": Vector3d(0, 2, 0)}


def test_the_document_hint_gives_guids_and_takes_geometry_back(worker):
    code = "import scriptcontext as sc\nb = type(x).__name__\nc = sc.doc.Objects.Find(x).Geometry.Location.X\na = x"
    values, _ = worker.run(code, {"x": Point3d(3, 4, 5)}, outputs="abc", hints={"x": "ghdoc Object"})
    assert values == {"a": Point3d(3, 4, 5), "b": "Guid", "c": 3.0}
    unknown = Guid("c9b2d725-6f87-4b07-af90-bd9aefef68eb")
    assert worker.run("a = x", {"x": unknown})[0] == {"a": unknown}


def test_python_2_source_runs_with_its_own_division(worker):
    values, result = worker.run("print 'half', 1/2\na = 7/2, 7/2.0, {1: 2}.keys()[0]\nexec 'b = 5'", language="python2",
                                outputs="ab")
    assert values == {"a": [3, 3.5, 1], "b": 5} and result["out"] == ["half 0\n"]


def test_what_goes_to_the_rhino_document_is_told_to_be_lost(worker):
    _, result = worker.run("import Rhino\nRhino.RhinoDoc.ActiveDoc.Objects.AddPoint(1, 2, 3)")
    assert result["messages"] == [["warning", "objects added to the Rhino document are not kept: there is no model", -1]]


def test_a_component_sees_its_ports(worker):
    code = "p = ghenv.Component.Params\na = [p.Input[0].NickName, p.Input[0].VolatileDataCount, p.Input[0].VolatileData[0][1]]"
    values, _ = worker.run(code, {"x": 1}, iterations=[[5], [6]])
    assert values["a"] == ["x", 2, 6]


def test_a_message_box_is_a_remark(worker):
    _, result = worker.run("import System.Windows.Forms as f\nf.MessageBox.Show('hello')")
    assert result["messages"] == [["remark", "hello", -1]]


def test_what_is_not_there_is_named(worker):
    _, result = worker.run("import Rhino\na = Rhino.Geometry.Brep.CreateFromMagic(1)")
    assert "Rhino.Geometry.Brep.CreateFromMagic is not supported by Katydid yet" in errors(result)[0]


def test_an_endless_loop_is_cancelled_and_the_worker_lives_on(worker):
    worker.run("a = 0")
    worker.send({"run": 1, "code": "while True: pass", "language": "python3", "key": "e", "inputs": [],
                 "outputs": [{"name": "a"}], "iterations": [[]], "doc": {}})
    time.sleep(0.3)
    os.kill(worker.process.pid, signal.SIGINT)
    request = worker.read()
    assert request[0] == "done" and request[1]["error"] == "cancelled" and request[1]["iterations"] == [[None]]
    assert worker.run("a = 1")[0] == {"a": 1}


def test_an_interrupt_during_a_call_keeps_the_messages_in_step():
    def answer(request):
        if request[0] == "members":
            return ["ok", ["Curve.Slow(Double t) -> Double"]]
        if request[0] == "changing":
            return ["ok", []]
        os.kill(worker.process.pid, signal.SIGINT)
        time.sleep(0.2)
        return ["ok", 5.0]
    worker = WorkerProcess(answer)
    code = "import Rhino.Geometry as rg\nfor i in range(1000): a = rg.Curve.Slow(1.0)"
    values, result = worker.run(code)
    assert result["error"] == "cancelled"
    assert len([request for request in worker.requests if request[0] == "call"]) == 1
    assert worker.run("a = 3")[0] == {"a": 3}
    worker.close()


def test_an_interrupt_between_runs_does_nothing(worker):
    worker.run("a = 1")
    os.kill(worker.process.pid, signal.SIGINT)
    time.sleep(0.1)
    assert worker.run("a = 2")[0] == {"a": 2}


def test_a_script_cannot_reach_the_pipes(worker):
    values, _ = worker.run("import os, sys\nos.write(1, b'x')\nos.system('echo y')\na = sys.stdin.read()")
    assert values == {"a": ""}


def test_prints_are_limited(worker):
    _, result = worker.run("for i in range(400):\n    print('x' * 10000)")
    assert len(result["out"][0]) < (1 << 20) + 100


def test_a_generator_without_end_is_an_error(worker):
    _, result = worker.run("import itertools\na = itertools.count()")
    assert "an output has more than 10000000 items" in errors(result)[0]


def test_objects_that_misbehave_do_not_end_the_worker(worker):
    code = ("class Bad(object):\n    def __getattr__(self, name): raise RuntimeError(name)\n"
            "    def __eq__(self, other): raise RuntimeError('eq')\n    __hash__ = None\n"
            "class Iter(object):\n    def __iter__(self): return self\n    def __next__(self): raise KeyError('x')\n"
            "a = Bad()\nb = Iter()\nc = [Bad]\nd = float('nan')\ne = '\\ud800'\nf = 10 ** 30")
    _, result = worker.run(code, outputs="abcdef")
    assert len(result["messages"]) <= 1
    assert worker.run("a = 1")[0] == {"a": 1}
    deep = "a = []\nfor i in range(3000): a = [a]\n"
    worker.run(deep)
    assert worker.run("def f(n): return f(n + 1)\na = f(0)")[1]["messages"][0][1].startswith("Runtime error (RecursionError)")
    assert worker.run("a = 2")[0] == {"a": 2}


def test_sys_exit_ends_the_script_alone(worker):
    values, result = worker.run("import sys\na = 1\nsys.exit()")
    assert values == {"a": 1} and result["messages"] == []


def test_a_warm_run_is_quick(worker):
    code = "\n".join("v%d = x + %d" % (i, i) for i in range(12)) + "\na = v11"
    worker.run(code, {"x": 1})
    times = []
    for _ in range(30):
        began = time.perf_counter()
        worker.run(code, {"x": 1})
        times.append(time.perf_counter() - began)
    # The bar is 0.5 ms on a quiet machine; the machine of a test is not.
    assert sorted(times)[5] < 0.01


def test_a_package_learns_that_python_3_runs_it(worker):
    """Packages for both languages ask for itertools.izip to learn which one runs them; converted scripts find it."""
    asked = "try:\\n    from itertools import izip\\n    old = True\\nexcept ImportError:\\n    old = False\\n"
    probe = "package = {}\neval(compile('%s', 'package', 'exec'), package)\n" \
            "from itertools import izip, imap\n" \
            "a = repr([package['old'], list(izip([1], [2])), list(imap(str, [3]))])" % asked
    values, result = worker.run(probe, language="python2")
    assert not errors(result), errors(result)[0]
    assert values["a"] == "[False, [(1, 2)], ['3']]"
    _, result = worker.run("from itertools import izip", key="new")
    assert "ImportError" in errors(result)[0]


def test_a_wrapper_of_ones_own_travels_without_a_call_of_the_constructor(worker):
    code = "import Grasshopper as gh\n" \
           "class Own(gh.Kernel.Types.GH_GeometricGoo[object], gh.Kernel.IGH_PreviewData):\n" \
           "    def __init__(self, held): self.m_value = held\n" \
           "    def ToString(self): return 'own'\n" \
           "a = Own(4.5)\nb = a.Value"
    values, result = worker.run(code, outputs=("a", "b"))
    assert not errors(result), errors(result)[0]
    assert values == {"a": 4.5, "b": 4.5}
