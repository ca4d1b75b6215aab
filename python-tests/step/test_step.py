"""Open CASCADE reads the STEP files that Katydid writes, and Katydid reads those of Open CASCADE."""

import math

import pytest
import rhino3dm
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepFilletAPI import BRepFilletAPI_MakeFillet
from OCP.BRepGProp import BRepGProp
from OCP.BRepPrimAPI import (
    BRepPrimAPI_MakeBox,
    BRepPrimAPI_MakeCone,
    BRepPrimAPI_MakeCylinder,
    BRepPrimAPI_MakeSphere,
    BRepPrimAPI_MakeTorus,
)
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt
from OCP.GProp import GProp_GProps
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_AsIs, STEPControl_Reader, STEPControl_Writer
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

from program import ROOT, katydid


def opened(path):
    reader = STEPControl_Reader()
    assert reader.ReadFile(str(path)) == IFSelect_RetDone
    assert reader.TransferRoots() > 0
    return reader.OneShape()


def parts(shape, kind):
    explorer, found = TopExp_Explorer(shape, kind), []
    while explorer.More():
        found.append(explorer.Current())
        explorer.Next()
    return found


def volume(shape):
    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties, 1e-10, False, False)
    return properties.Mass()


def checked(path, solids):
    shape = opened(path)
    assert BRepCheck_Analyzer(shape).IsValid()
    assert len(parts(shape, TopAbs_SOLID)) == solids
    return shape


def origin_circle(radius):
    return rhino3dm.Circle(rhino3dm.Point3d(0, 0, 0), radius)


def box():
    return rhino3dm.Brep.CreateFromBox(
        rhino3dm.Box(rhino3dm.BoundingBox(rhino3dm.Point3d(1, 2, 3), rhino3dm.Point3d(4, 6, 8)))
    )


def ball():
    return rhino3dm.Brep.CreateFromSphere(rhino3dm.Sphere(rhino3dm.Point3d(1, 2, 3), 5))


def can():
    return rhino3dm.Brep.CreateFromCylinder(rhino3dm.Cylinder(origin_circle(3), 7), True, True)


CLOSED_FORMS = {
    "box": (box, 60.0),
    "sphere": (ball, 4 / 3 * math.pi * 125),
    "cylinder": (can, math.pi * 9 * 7),
}


@pytest.mark.parametrize("name", sorted(CLOSED_FORMS))
def test_solids_have_the_volume_of_their_closed_form(name, tmp_path):
    make, wanted = CLOSED_FORMS[name]
    model = rhino3dm.File3dm()
    model.Settings.ModelUnitSystem = rhino3dm.UnitSystem.Millimeters
    model.Objects.AddBrep(make())
    source, target = tmp_path / "solid.3dm", tmp_path / "solid.step"
    model.Write(str(source), 7)
    katydid("convert", source, target)
    shape = checked(target, 1)
    assert volume(shape) == pytest.approx(wanted, rel=1e-9)
    # And back again: the solid in the model is closed, and its volume the same.
    again, twice = tmp_path / "again.3dm", tmp_path / "again.step"
    katydid("convert", target, again)
    (brep,) = [thing.Geometry for thing in rhino3dm.File3dm.Read(str(again)).Objects]
    assert brep.IsValid and brep.IsSolid
    katydid("convert", again, twice)
    assert volume(checked(twice, 1)) == pytest.approx(wanted, rel=1e-9)


def drilled():
    block = BRepPrimAPI_MakeBox(10, 20, 30).Shape()
    drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(5, 10, -5), gp_Dir(0, 0, 1)), 3, 50).Shape()
    corner = BRepPrimAPI_MakeSphere(gp_Pnt(10, 20, 30), 6).Shape()
    return BRepAlgoAPI_Cut(BRepAlgoAPI_Cut(block, drill).Shape(), corner).Shape()


def crossed():
    upright = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, -10), gp_Dir(0, 0, 1)), 4, 20).Shape()
    across = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-10, 0, 0), gp_Dir(1, 0, 0)), 3, 20).Shape()
    return BRepAlgoAPI_Fuse(upright, across).Shape()


def rounded():
    block = BRepPrimAPI_MakeBox(10, 20, 30).Shape()
    fillet = BRepFilletAPI_MakeFillet(block)
    as_edge = getattr(TopoDS, "Edge_s", None) or TopoDS.Edge
    for edge in parts(block, TopAbs_EDGE):
        fillet.Add(2.0, as_edge(edge))
    return fillet.Shape()


def hollow():
    block = BRepPrimAPI_MakeBox(10, 20, 30).Shape()
    return BRepAlgoAPI_Cut(block, BRepPrimAPI_MakeSphere(gp_Pnt(5, 10, 15), 3).Shape()).Shape()


THEIRS = {
    "cone": lambda: BRepPrimAPI_MakeCone(5, 0, 12).Shape(),
    "torus": lambda: BRepPrimAPI_MakeTorus(10, 3).Shape(),
    "part of a torus": lambda: BRepPrimAPI_MakeTorus(10, 3, 2.0).Shape(),
    "drilled": drilled,
    "crossed": crossed,
    "rounded": rounded,
    "hollow": hollow,
}


@pytest.mark.parametrize("name", THEIRS)
def test_solids_of_open_cascade_make_the_round_trip(name, tmp_path):
    theirs = THEIRS[name]()
    source, model, target = (tmp_path / file for file in ("theirs.step", "ours.3dm", "ours.step"))
    writer = STEPControl_Writer()
    writer.Transfer(theirs, STEPControl_AsIs)
    writer.Write(str(source))
    katydid("convert", source, model)
    (brep,) = [thing.Geometry for thing in rhino3dm.File3dm.Read(str(model)).Objects]
    assert brep.IsValid and brep.IsSolid
    katydid("convert", model, target)
    ours = checked(target, 1)
    assert volume(ours) == pytest.approx(volume(theirs), rel=1e-6)
    assert len(parts(ours, TopAbs_FACE)) == len(parts(theirs, TopAbs_FACE))
