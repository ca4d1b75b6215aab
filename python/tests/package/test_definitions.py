"""Definitions: inputs, outputs, solves, limits, files, differences."""

import os
import pickle
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import katydid

BOX = """
width = Number Slider(2, 0..10)
depth = Number Slider(3, 0..10)
points = Point()
area = Multiplication(width, depth)
moved = Move(points, Vector XYZ(0, 0, width))
shown = Panel(area)
"""

#: Nearest points of a curve, which take long: some seconds for a million.
SLOW = """
points = Point()
curve = Curve()
near = Curve Closest Point(points, curve)
"""


def wild_curve():
    """A curve that winds a lot, so that each nearest point is a search."""
    angles = np.linspace(0, 300, 2000)
    return katydid.Curve.interpolate(np.stack([np.cos(angles), np.sin(3 * angles), 0.01 * angles], axis=1))


def test_inputs_have_names_kinds_and_ranges(definition):
    d = definition(BOX)
    by_name = {i.name: i for i in d.inputs}
    assert (by_name["width"].kind, by_name["width"].minimum, by_name["width"].maximum) == ("Number", 0, 10)
    assert by_name["points"].kind == "Point" and by_name["points"].minimum is None
    assert by_name["width"].value == "2" and not by_name["width"].marked


def test_a_marked_input_is_found_with_and_without_its_mark(definition):
    d = definition('height = Number Slider(2, 0..10)\ndouble = Multiplication(height, 2)\n"RH_IN:h": height\n"RH_OUT:twice": double\n')
    assert [(i.name, i.marked) for i in d.inputs] == [("h", True)]
    assert [(o.name, o.marked) for o in d.outputs] == [("twice", True)]
    assert d.solve(h=4)["twice"].item == 8
    assert d.solve({"RH_IN:h": 4})["RH_OUT:twice"].item == 8


def test_a_solve_takes_numbers_and_leaves_the_definition_as_it_is(definition):
    d = definition(BOX)
    assert d.solve(width=4, depth=2.5)["area"].item == 10
    assert d.solve(depth=1)["area"].item == 2
    assert d.solve()["area"].item == 6


def test_only_what_hangs_on_a_change_is_solved(definition):
    d = definition(BOX)
    d.solve()
    assert d.solve().solved == 0
    assert 0 < d.solve(depth=4).solved < len(d)


def test_points_go_in_and_out_as_arrays(definition):
    points = np.random.default_rng(1).random((1000, 3))
    moved = definition(BOX).solve(width=5, points=points)["moved"]
    assert moved.kind == "Point" and moved.paths == [(0,)]
    np.testing.assert_allclose(moved.array(), points + [0, 0, 5], rtol=0, atol=1e-12)


@pytest.mark.parametrize("given", [
    [(1, 2, 3), (4, 5, 6)],
    [katydid.Point(1, 2, 3), katydid.Point(4, 5, 6)],
    np.array([[1, 2, 3], [4, 5, 6]]),
    np.array([[1, 2, 3], [4, 5, 6]], dtype="float32"),
    np.array([[1, 4], [2, 5], [3, 6]]).T,
    {"{0}": [(1, 2, 3), (4, 5, 6)]},
    {(0,): np.array([[1.0, 2, 3], [4, 5, 6]])},
])
def test_points_may_be_given_in_any_form(definition, given):
    moved = definition(BOX).solve(width=0, points=given)["moved"]
    np.testing.assert_array_equal(moved[0], [[1, 2, 3], [4, 5, 6]])


def test_trees_go_in_and_out(definition):
    d = definition("numbers = Number()\ndouble = Multiplication(numbers, 2)\n")
    tree = d.solve(numbers={(0, 1): [1, 2], (3,): [5, None]})["double"]
    assert tree.paths == [(0, 1), (3,)]
    assert list(tree[0, 1]) == [2, 4] and tree["{3}"] == [10, None]
    assert len(tree) == 2 and (3,) in tree and (4,) not in tree
    nested = d.solve(numbers=[[1, 2], [3]])["double"]
    assert {p: list(b) for p, b in nested.items()} == {(0,): [2, 4], (1,): [6]}
    again = d.solve(numbers=nested)["double"]
    assert again.flat() == [4, 8, 12]
    assert pickle.loads(pickle.dumps(tree)) == tree != nested
    with pytest.raises(KeyError):
        tree[9]


def test_rows_of_numbers_are_branches_where_numbers_are_taken(definition):
    d = definition("numbers = Number()\ndouble = Multiplication(numbers, 2)\n")
    assert d.solve(numbers=np.ones((2, 3)))["double"].paths == [(0,), (1,)]


def test_messages_name_their_component(definition):
    r = definition("x = Number Slider(0, 0..1)\nd = Division(1, x)\n").solve()
    errors = [m for m in r.messages if m.level == "error"]
    assert [m.component for m in errors] == ["Division"] and errors[0].nickname == "d" and len(errors[0].id) == 36
    assert not r.ok
    with pytest.raises(katydid.SolveError, match="d "):
        r.check()


@pytest.mark.parametrize("inputs, said", [
    ({"widht": 1}, "did you mean 'width'"),
    ({"width": 11}, "from 0 to 10"),
    ({"width": float("nan")}, "not a finite number"),
    ({"points": [(0, 0, float("inf"))]}, "not a finite number"),
    ({"points": np.full((2, 3), np.nan)}, "not a finite number"),
    ({"width": "wide"}, "one number"),
    ({"width": [1, 2]}, "one number"),
    ({"points": ["wide"]}, "cannot be a Point"),
    ({"points": object()}, "nothing that a definition takes"),
])
def test_what_an_input_does_not_take_is_refused(definition, inputs, said):
    with pytest.raises(katydid.InputError, match=said):
        definition(BOX).solve(inputs)


def test_files_that_are_none_are_refused(tmp_path):
    with pytest.raises(katydid.FileError, match="nothing.gh"):
        katydid.open(tmp_path / "nothing.gh")
    for name, content in (("noise.gh", os.urandom(500)), ("empty.gh", b""), ("bad.kd", b"katydid 1\nx = (\n")):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(katydid.FileError, match=name):
            katydid.open(tmp_path / name)


def test_limits_of_time_and_memory_are_errors(definition):
    with pytest.raises(katydid.LimitError, match="time limit"):
        definition(SLOW).solve(points=np.random.rand(300_000, 3), curve=wild_curve(), time_limit=0.05)
    with pytest.raises(katydid.LimitError, match="bytes"):
        definition(BOX).solve(points=np.random.rand(300_000, 3), byte_limit=1 << 20)
    r = definition("s = Series(0, 1, 1000)\n").solve(item_limit=100)
    assert "items" in r.messages[0].text and r["s"].item_count == 0


def test_progress_is_told_and_may_end_a_solve(definition):
    told = []
    definition(BOX).solve(progress=lambda *news: told.append(news))
    assert told[-1][0] == told[-1][1] == len(told) and "area" in {name for _, _, name in told}

    def stop(*_):
        raise RuntimeError("enough")
    with pytest.raises(RuntimeError, match="enough"):
        definition(BOX).solve(progress=stop)


def test_control_c_ends_a_solve(tmp_path):
    (tmp_path / "slow.kd").write_text("katydid 1\n" + SLOW)
    code = "\n".join([
        "import sys; sys.path[:0] = %r" % [sys.path[0], os.path.dirname(os.path.dirname(katydid.__file__)), os.path.dirname(__file__)],
        "import katydid, numpy, test_definitions",
        "d = katydid.open(%r)" % str(tmp_path / "slow.kd"),
        "points, curve = numpy.random.rand(3_000_000, 3), test_definitions.wild_curve()",
        "print('begins', flush=True)",
        "try:\n    d.solve(points=points, curve=curve)\nexcept KeyboardInterrupt:\n    print('interrupted')",
        "print(d.solve(points=points[:5], curve=curve)['near.Distance'].item_count)"])
    # A shell that runs a command in the background has it ignore the signal, and what it starts inherits that.
    run = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True,
                           preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    assert run.stdout.readline() == "begins\n"
    time.sleep(0.7)
    begin = time.monotonic()
    run.send_signal(signal.SIGINT)
    out, _ = run.communicate(timeout=60)
    assert out.split() == ["interrupted", "5"], out
    assert time.monotonic() - begin < 30


def test_the_interpreters_lock_is_released(definition):
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.001)
    thread = threading.Thread(target=tick)
    thread.start()
    definition(SLOW).solve(points=np.random.rand(20_000, 3), curve=wild_curve())
    done.set()
    thread.join()
    assert len(ticks) > 5


def test_threads_solve_at_once(definition):
    d = definition(BOX)
    results = {}

    def work(k):
        results[k] = [d.solve(width=k, depth=n % 10)["area"].item for n in range(20)]
    threads = [threading.Thread(target=work, args=(k,)) for k in range(4)]
    [t.start() for t in threads], [t.join() for t in threads]
    assert results == {k: [k * (n % 10) for n in range(20)] for k in range(4)}


@pytest.mark.parametrize("ending", ["gh", "ghx", "kd"])
def test_a_definition_is_changed_saved_and_compared(definition, tmp_path, ending):
    d = definition(BOX)
    d.set("width", 7)
    assert d.save(tmp_path / ("saved." + ending)) == []
    again = katydid.open(tmp_path / ("saved." + ending))
    assert again.solve()["area"].item == 21
    assert [str(change) for change in katydid.diff(d, again)] == []
    changes = katydid.diff(definition(BOX), tmp_path / ("saved." + ending))
    assert [(c.object, c.kind, c.text) for c in changes] == [("width (Number Slider)", "value", "value 2 → 7")]
    with pytest.raises(katydid.FileError, match="saved as"):
        d.save(tmp_path / "saved.txt")


def test_pictures_are_png_and_models_are_files(definition, tmp_path):
    d = definition("c = Circle(XY Plane(), 2)\n")
    r = d.solve()
    for picture in (d.picture(), d.picture((300, 200), canvas=True), r.picture((300, 200), view="top")):
        assert picture.startswith(b"\x89PNG") and len(picture) > 300
    assert r.to_glb()[:4] == b"glTF"
    r.write(tmp_path / "out.3dm")
    (circle,) = katydid.read(tmp_path / "out.3dm").geometry
    assert circle.length == pytest.approx(4 * np.pi, abs=1e-12)
    with pytest.raises(ValueError, match="view"):
        d.picture(view="below")


def test_real_definitions_give_what_the_command_gives(shared, tmp_path):
    """The same objects, messages and data by the package and by the command, which share nothing above the session."""
    import json
    files = sorted(os.path.join(folder, file) for folder, _, files in os.walk(os.path.join(shared, "gh"))
                   for file in files if file.endswith((".gh", ".ghx")))
    compared = 0
    for file in files[::14]:
        run = subprocess.run([sys.executable, "-m", "katydid", "run", file, "--json", "--limit-seconds", "20"],
                             capture_output=True, text=True, cwd=os.path.dirname(os.path.dirname(katydid.__file__)))
        if run.returncode == 2:
            with pytest.raises(katydid.FileError):
                katydid.open(file)
            continue
        objects = {o["id"]: o for o in json.loads(run.stdout)["objects"]}
        r = katydid.open(file).solve(time_limit=60)
        scripts = "script was not run"
        said = sorted((m.id, m.level, m.text) for m in r.messages if scripts not in m.text)
        assert said == sorted((o["id"], m["level"], m["text"]) for o in objects.values()
                              for m in o["messages"] if scripts not in m["text"]), file
        for id, o in objects.items():
            if o["outputs"] and o["kind"] != "annotation":
                branches = o["outputs"][0]["branches"]
                tree = r[id]
                assert ["{%s}" % ";".join(map(str, path)) for path in tree.paths] == [b["path"] for b in branches], (file, id)
                assert [len(branch) for branch in tree.values()] == [len(b["items"]) for b in branches], (file, id)
                compared += 1
    assert compared > 100


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork on this system")
def test_a_forked_process_is_told_that_it_cannot_solve(definition):
    d = definition(BOX)
    d.solve()
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            d.solve()
            os.write(write, b"solved")
        except RuntimeError as error:
            os.write(write, str(error).encode())
        finally:
            os._exit(0)
    os.close(write)
    assert b"spawn" in os.read(read, 1000)
    os.waitpid(child, 0)
    os.close(read)
    assert d.solve()["area"].item == 6
