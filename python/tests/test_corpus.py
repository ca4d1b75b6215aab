"""Scripts of real definitions, with plausible inputs.

The definitions are no part of the project: KATYDID_TEST_DEFINITIONS names their folder, KATYDID the program. Without
them these tests say that they did not run.
"""

import re

import corpus
import pytest
from hosts import Members, WorkerProcess, codec, errors, program
from katydid.python2 import compile_python2
from katydid.values import (Arc, BoundingBox, Box, Circle, Color, Guid, Interval, Line, Plane, Point3d, Rectangle3d,
                            Transform, Vector3d)

FOLDER = corpus.folder()
needs_folder = pytest.mark.skipif(FOLDER is None, reason="KATYDID_TEST_DEFINITIONS names no folder: nothing was run")
needs_program = pytest.mark.skipif(program() is None, reason="KATYDID names no program: nothing was run")

#: Modules that a script may import and still need nothing but the API and the library.
API = {"rhinoscriptsyntax", "Rhino", "ghpythonlib", "scriptcontext", "Grasshopper", "System", "clr", "GhPython", "math",
       "random", "copy", "json", "time", "itertools", "sys", "base64", "re", "copy_reg", "struct", "os", "decimal",
       "datetime", "collections", "functools", "__future__", "operator", "string", "inspect", "colorsys"}

#: Values of each kind of input, by the first digits of its hint.
POINTS = [Point3d(0, 0, 0), Point3d(4, 0, 0), Point3d(4, 3, 0), Point3d(1, 2, 0), Point3d(2, 5, 1)]
BY_HINT = {
    "39fbc626": [1.5, 2.0, 3.0], "19ff81a2": [1.5, 2.0], "9d51e32e": [1.5, 2.0], "48d01794": [3, 4, 5],
    "d60527f5": [True, False], "37261734": ["a", "b"], "9e93878a": ["a", "b"], "3aceb454": ["a", "b"],
    "e1937b56": POINTS, "15a50725": [Vector3d(1, 0, 0), Vector3d(0, 1, 2)],
    "3897522d": [Plane.WorldXY, Plane(Point3d(0, 0, 1), Vector3d.ZAxis)], "589748aa": [Interval(0, 2)],
    "f802a8cd": [Line(0, 0, 0, 3, 4, 0), Line(0, 1, 0, 3, 1, 0)], "3c5409a1": [Circle(2)],
    "9c80ec18": [Arc(Plane.WorldXY, 2, 1.5)], "83da014b": [Rectangle3d(Plane.WorldXY, 3, 2)],
    "f29cb021": [Box(BoundingBox(0, 0, 0, 1, 2, 3))], "c4b38e4c": [Transform.Translation(1, 2, 3)],
    "24b1d1a3": [Color.FromArgb(1, 2, 3)], "5325b8e1": [Guid("57da07bd-ecab-415d-9d86-af36d7073abc")],
}
#: Inputs whose name tells more than their hint.
BY_NAME = {"pts": POINTS, "points": POINTS, "tol": [0.5], "path": [None], "seed": [7], "planes": [Plane.WorldXY],
           "custom_dimensions": [], "k": [1], "fp_in": [None], "layer_": ["Default"], "layernames": ["Default"]}


def modules(code):
    """The top-level modules that a script imports."""
    found = set()
    for line in code.splitlines():
        match = re.match(r"\s*(?:from\s+([\w.]+)\s+import|import\s+(.+))", line)
        if match:
            names = match.group(1) or match.group(2).partition("#")[0]
            found |= {name.strip().split(" ")[0].partition(".")[0] for name in names.split(",")}
    return found


def scripts():
    return list(corpus.all_scripts(FOLDER)) if FOLDER else []


class Inputs:
    """Makes inputs; geometry is the host's."""

    def __init__(self, members):
        box = members.call("Brep.CreateFromBox", Box(BoundingBox(0, 0, 0, 2, 3, 4)))
        mesh = members.call("Mesh.new", [Point3d(0, 0, 0), Point3d(2, 0, 0), Point3d(2, 2, 0), Point3d(0, 2, 1)],
                            [codec.MeshFace(0, 1, 2, 3)])
        curves = [members.call("LineCurve.new", Line(0, 0, 0, 3, 0, 0)), members.call("ArcCurve.new", Circle(2))]
        surface = members.call("PlaneSurface.new", Plane.WorldXY, Interval(0, 4), Interval(0, 2))
        self.geometry = {"9ba89ec2": curves, "2ceb0405": [box], "794a1f9d": [mesh], "c37956f4": curves,
                         "f4070a37": [surface]}
        self.named = {"srf": [surface], "box": [box], "brep": [box], "m": [mesh], "pt": POINTS, "crv": curves}
        self.open = [1.0, 2.0, 3.0]

    def of(self, port):
        hint = port["hint"][:8]
        name = port["name"].lower()
        if name in BY_NAME:
            values = BY_NAME[name]
        else:
            values = BY_HINT.get(hint) or self.geometry.get(hint) or self.named.get(name) or self.open
        if port["access"] == "list":
            return list(values)
        if port["access"] == "tree":
            return codec.Tree([((0, 0), list(values)), ((0, 1), list(values[:1]))])
        return values[0]


@needs_folder
@pytest.mark.parametrize("script", scripts(), ids=lambda s: s["file"].rpartition("/")[2] + "/" + s["name"])
def test_every_script_is_read(script):
    if script["language"] == "python2":
        compile_python2(script["code"], "<script>")
    else:
        compile(script["code"], "<script>", "exec")


#: Scripts that ask for what cannot be here, with the words that name it.
EXPECTED = {
    "File3mf": "Rhino.FileIO", "GH_Skin": "Grasshopper.GUI", "Bitmap": "System.Drawing.Bitmap",
    # What the host has not yet.
    "Hatch.Create": "Rhino.Geometry.Hatch.Create",
}


@needs_folder
@needs_program
def test_scripts_of_api_and_library_run():
    members = Members(program())
    worker = WorkerProcess(members)
    inputs = Inputs(members)
    failures, ran = [], 0
    try:
        for number, script in enumerate(scripts()):
            if not modules(script["code"]) <= API:
                continue
            ports = [dict(port, hint="ghdoc" if port["hint"].startswith("87f87f55") else port["hint"])
                     for port in script["inputs"]]
            message = {"run": number, "code": script["code"], "language": script["language"], "key": "s%d" % number,
                       "name": script["name"], "nickname": script["nickname"], "inputs": ports,
                       "outputs": [port for port in script["outputs"] if port["name"] != "out"],
                       "iterations": [[inputs.of(port) for port in ports]],
                       "doc": {"tolerance": 0.001, "angle_tolerance": 0.0174, "units": "Millimeters",
                               "path": "/tmp/definition.gh", "name": "definition"}}
            result = worker.ask(message)
            ran += 1
            for text in errors(result):
                words = next((words for mark, words in EXPECTED.items() if mark in script["code"]), None)
                if words is None or words not in text:
                    failures.append((number, script["file"], text))
    finally:
        worker.close()
        members.close()
    print(ran, "scripts ran")
    assert not failures, "%d of %d:\n" % (len(failures), ran) + "\n\n".join("%d %s\n%s" % one for one in failures)
