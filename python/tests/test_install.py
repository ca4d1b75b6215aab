"""The modules in a program of one's own: installed, used, and taken away again."""

import subprocess
import sys

import pytest
from hosts import PACKAGE, program

CODE = """
import sys
sys.path.insert(0, %r)
import katydid.rhino
try:
    import Rhino
    raise SystemExit("Rhino is there before it is installed")
except ImportError:
    pass
katydid.rhino.install()
import Rhino.Geometry as rg
from System import Array
import System.Array as again
assert again is Array and Array[float]([1, 2]) == [1.0, 2.0] and len(Array.CreateInstance(int, 3)) == 3
print(rg.Point3d(1, 2, 3).DistanceTo(rg.Point3d(1, 2, 5)))
%s
katydid.rhino.uninstall()
try:
    import Rhino
    raise SystemExit("Rhino is there after it was taken away")
except ImportError:
    pass
"""


def run(code, **environment):
    made = subprocess.run([sys.executable, "-I", "-B", "-c", CODE % (PACKAGE.rpartition("/")[0], code)], env=environment,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=60)
    assert made.returncode == 0, made.stderr.decode()
    return made.stdout.decode().split()


def test_value_types_need_no_program():
    assert run("", KATYDID="/no/such/program") == ["2.0"]


def test_geometry_without_a_program_says_what_is_missing():
    code = "try:\n    rg.LineCurve(rg.Line(0, 0, 0, 1, 0, 0))\nexcept NotImplementedError as error:\n    print(error)"
    assert " ".join(run(code, KATYDID="/no/such/program")[1:]).startswith("geometry needs Katydid's program")


@pytest.mark.skipif(program() is None, reason="KATYDID names no program: geometry was not tested")
def test_geometry_with_the_program():
    assert run("print(rg.LineCurve(rg.Line(0, 0, 0, 3, 4, 0)).GetLength())", KATYDID=program()) == ["2.0", "5.0"]
