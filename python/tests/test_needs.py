"""What a script needs is told without running it."""

import pytest
from katydid import backend, objects, rhino
from katydid.needs import needs


@pytest.fixture(autouse=True)
def table():
    """A host with two members."""
    made = backend.Absent(objects.Objects())
    made._table = backend.Table(["Brep.CreateFromBox(Box box) -> Brep", "Curve.get_Domain(this Curve) -> Interval"])
    type(made).table, kept = property(lambda self: made._table), type(made).__dict__["table"]
    before = backend.use(made)
    yield
    backend.use(before)
    backend.Absent.table = kept
    rhino.uninstall()


def test_members_and_modules_are_named_in_full():
    code = """
import Rhino.Geometry as rg
import rhinoscriptsyntax as rs, math, no_such_package.part
from Rhino.Geometry import Point3d, Wombat
from ladybug_rhino.togeometry import to_mesh
a = rg.Brep.CreateFromBox(1), rg.Brep.CreateFromMagic(2), rg.Curve.Domain
rs.AddPoint(0, 0, 0); rs.AddUnicorn()
Point3d.Origin; Point3d.Nowhere
"""
    found = needs(code, "python3")
    assert found["modules"] == ["ladybug_rhino.togeometry", "no_such_package.part"]
    assert found["members"] == ["Rhino.Geometry.Brep.CreateFromMagic", "Rhino.Geometry.Point3d.Nowhere",
                                "Rhino.Geometry.Wombat", "rhinoscriptsyntax.AddUnicorn"]
    assert found["error"] is None


def test_python_2_and_its_modules():
    assert needs("import cPickle, StringIO\nprint 1", "python2") == {
        "modules": [], "members": [], "packages": [], "error": None}


def test_packages_of_comment_lines():
    assert needs("# r: nobody-has-this, nor_this==1.10, pytest\nimport os", "python3")["packages"] == ["nobody-has-this", "nor_this==1.10"]


def test_source_that_cannot_be_read_names_the_line():
    assert needs("a = 1\nb = = 2", "python3")["error"].startswith("line 2")
    assert needs("def f((a, b)): pass", "python2")["error"].startswith("line 1")


def test_a_class_imported_as_a_module_is_there():
    assert needs("import System.Array as array\nimport Rhino.RhinoDoc as d\nd.ActiveDoc", "python3")["modules"] == []
