"""Scripts of real definitions, each with inputs for which its outputs follow by hand or by formula.

A script is named by the first digits of the SHA-1 of its text: the texts are no part of the project. As in
`test_corpus.py`, KATYDID_TEST_DEFINITIONS names the folder, and KATYDID the program.
"""

import hashlib

import corpus
import pytest
from hosts import Members, WorkerProcess, codec, errors, program
from katydid.values import BoundingBox, Box, Interval, Line, Plane, Point3d, Vector3d

FOLDER = corpus.folder()
pytestmark = pytest.mark.skipif(FOLDER is None or program() is None,
                                reason="KATYDID_TEST_DEFINITIONS and KATYDID are not both set: nothing was run")

TREE = codec.Tree([((0, 1), [1, 2]), ((3,), ["z"])])
#: Geometry that the host makes for an input.
LINE, BOX, PLATE, SQUARES = "line", "box", "plate", "squares"

#: By script: inputs by name, then what outputs give by name. `out` is what is printed. A text that begins with "=" is a
#: question in Python about `x`, the output, and stands for what it should answer.
VALUES = {
    "eea30c1e": ({"Run": True}, {"out": "Hello World!\n"}),
    "33650aa2": ({"Filename": "a.txt"}, {"Path": "/tmp/a.txt", "out": "/tmp/a.txt\n"}),
    "d19d7ed5": ({}, {"path": "/tmp"}),
    "78e09f8c": ({"x": [1.0, 2.0, 3.5]}, {"a": 6.5}),
    "e9c0d2cc": ({"values": [3.0, 5.0], "offset": 1.0}, {"a": [2.0, 4.0]}),
    # Two squares, of side 2 and 1, apart.
    "4e44aa21": ({"M": SQUARES}, {"M": ("sorted(rg.AreaMassProperties.Compute(m).Area for m in x)", [1.0, 4.0])}),
    "d06be108": ({"x": 1, "y": 2}, {"a": 13}),
    "dea15f5c": ({"x": 1}, {"out": "<class 'int'>\n"}),
    "73ce48b7": ({"x": 1, "y": 2}, {"a": None}),
    "5aee562f": ({"x": "you"}, {"a": "Hello you"}),
    "b787e0f0": ({"x": 1, "y": 2}, {"a": 3}),
    "715322bc": ({"x": 1, "y": 2}, {"a": 53}),
    "dbc655ee": ({"x": 1, "y": 2}, {"a": "Hello IronPython 2 in Grasshopper!", "out": "Hello IronPython 2 in Grasshopper!\n"}),
    "a5c3d1eb": ({"x": 1, "y": 2}, {"a": "Hello Python 3 in Grasshopper!"}),
    "93f98605": ({"x": 1, "y": 2}, {"a": "Hello Python 3 in Grasshopper!"}),
    "a800d580": ({"x": TREE}, {"a": ["{0;1}[0] int: 1", "{0;1}[1] int: 2", "{3}[0] str: z"]}),
    "bb7014ac": ({"x": codec.Tree([((0, 0), [1, 2]), ((0, 1), ["z"])])}, {"a": ["0[0] int: 1", "0[1] int: 2", "1[0] str: z"]}),
    "acbfe06d": ({"fp_in": None}, {"fp_read": "/tmp/definition.py"}),
    "891c0093": ({"Crv": LINE, "N": 3}, {"CrvCopies": ("[c.PointAtStart.X for c in x]", [0.0, 1.0, 2.0])}),
    "6d727b88": ({"_": None, "Set": False, "Panels": ["a"], "Input": None}, {"panelname": [], "panelvalue": []}),
    "14e43110": ({"dataTree1": TREE, "dataTree2": TREE}, {"a": [((4, 102, 60), [1, 2, "z"])], "b": [((0,), [1, 2, "z"])]}),
    "4c6dd0f7": ({"crv": LINE}, {"a": "Degree = 1"}),
    # Four corners of a square: four cells of one size.
    "f4bfc1d2": ({"points": [Point3d(0, 0, 0), Point3d(4, 0, 0), Point3d(4, 4, 0), Point3d(0, 4, 0)]},
                 {"areas": ("[len(x), max(x) - min(x) < 1e-6]", [4, True])}),
    # A box of 2 by 3 cut across its height.
    "c5b03e87": ({"planes": [Plane(Point3d(0, 0, 1), Vector3d.ZAxis)], "brep": BOX, "parallel": False},
                 {"slices": ("sum(c.GetLength() for c in x)", 10.0)}),
    "a47adb49": ({"list": [1, 2]}, {"tree_out": [((0,), [1]), ((1,), [2])]}),
    "c28f861e": ({}, {"out": "[1, [2, 3], [1, [10, 11, 12], 3], [1, 2, 3], [1, 2, 3]]\n"}),
    "50063f6c": ({"list": [1, 2]}, {"tree_out": [((0,), [1, 2])]}),
    "e42cc12e": ({"x": "/nowhere"}, {"p": ("x[-1]", "/nowhere")}),
    "ce43c53b": ({"_": None}, {"layers": ["Default"]}),
    # With m = 4 and all exponents 2 it is the circle of radius 2.
    "624f83b6": ({"_width": 2.0, "_height": 2.0, "_nRot": 1, "_nIter": 4, "_n1": 2.0, "_n2": 2.0, "_n3": 2.0, "_m": 4.0},
                 {"p_": ("[v for p in x for v in (p.X, p.Y)]", [2.0, 0.0, 0.0, 2.0, -2.0, 0.0, 0.0, -2.0])}),
    # How high a point is above a plane.
    "400a0116": ({"pt": Point3d(1, 1, 3), "srf": PLATE}, {"A": 3.0}),
    "e0a89606": ({"pt": Point3d(1, 1, 3), "srf": PLATE}, {"A": 3.0}),
    # Spheres over the two parts of a line that is cut at 0.4.
    "f356e831": ({"A": Point3d(0, 0, 0), "B": Point3d(10, 0, 0), "t": 0.4},
                 {"S1": ("[x[0].Center.X, x[0].Radius]", [2.0, 2.0]), "S2": ("[x[0].Center.X, x[0].Radius]", [7.0, 3.0])}),
    # Each face's middle was 1, 1.5 or 2 from the box's, twice each, and is 1 farther.
    "f73da924": ({"box": BOX, "dis": 1.0}, {"A": (
        "sum(rg.AreaMassProperties.Compute(f).Centroid.DistanceTo(rg.Point3d(1, 1.5, 2)) for f in x)", 15.0)}),
}


@pytest.fixture(scope="module")
def stage():
    members = Members(program())
    worker = WorkerProcess(members)
    pts = [Point3d(0, 0, 0), Point3d(2, 0, 0), Point3d(2, 2, 0), Point3d(0, 2, 0), Point3d(5, 0, 0), Point3d(6, 0, 0),
           Point3d(6, 1, 0), Point3d(5, 1, 0)]
    made = {LINE: members.call("LineCurve.new", Line(0, 0, 0, 3, 0, 0)),
            BOX: members.call("Brep.CreateFromBox", Box(BoundingBox(0, 0, 0, 2, 3, 4))),
            PLATE: members.call("PlaneSurface.new", Plane.WorldXY, Interval(0, 4), Interval(0, 2)),
            SQUARES: members.call("Mesh.new", pts, [codec.MeshFace(0, 1, 2, 3), codec.MeshFace(4, 5, 6, 7)])}
    scripts = {hashlib.sha1(one["code"].encode("utf-8", "replace")).hexdigest()[:8]: one for one in corpus.all_scripts(FOLDER)}
    yield worker, made, scripts
    worker.close()
    members.close()


def same(got, wanted):
    if isinstance(got, codec.Tree):
        got = [(tuple(path), list(items)) for path, items in got.branches]
    if isinstance(wanted, (list, tuple)):
        return isinstance(got, (list, tuple)) and len(got) == len(wanted) and all(map(same, got, wanted))
    if isinstance(wanted, float):
        return isinstance(got, (int, float)) and abs(got - wanted) < 1e-6
    return got == wanted


@pytest.mark.parametrize("digits", sorted(VALUES))
def test_a_real_script_gives_what_follows_by_hand(stage, digits):
    worker, made, scripts = stage
    script = scripts.get(digits)
    if script is None:
        pytest.skip("the folder has no such script")
    inputs, wanted = VALUES[digits]
    ports = [dict(port, hint="ghdoc" if port["hint"].startswith("87f87f55") else port["hint"]) for port in script["inputs"]]
    assert {port["name"] for port in ports} == set(inputs)
    names = [port["name"] for port in script["outputs"] if port["name"] != "out"]
    names += [name for name in wanted if name not in names and name != "out"]

    def geometry(value):
        return made.get(value, value) if isinstance(value, str) else value
    message = {"run": 0, "code": script["code"], "language": script["language"], "key": digits, "name": "", "nickname": "",
               "inputs": ports, "outputs": [{"name": name} for name in names],
               "iterations": [[geometry(inputs[port["name"]]) for port in ports]],
               "doc": {"tolerance": 0.001, "angle_tolerance": 0.0174, "units": "Millimeters", "path": "/tmp/definition.gh",
                       "name": "definition"}}
    result = worker.ask(message)
    assert not errors(result), errors(result)
    outputs = dict(zip(names, result["iterations"][0]), out=result["out"][0])
    for name, value in wanted.items():
        got = outputs[name]
        if isinstance(value, tuple):
            question, value = value
            got = got if isinstance(got, list) else [got]
            answers, said = worker.run("import Rhino.Geometry as rg\na = " + question, {"x": got}, key="q")
            assert not errors(said), errors(said)
            got = answers["a"]
        assert same(got, value), "%s: %r, not %r" % (name, got, value)


def test_thirty_scripts_are_checked(stage):
    assert len([digits for digits in VALUES if digits in stage[2]]) >= 30
