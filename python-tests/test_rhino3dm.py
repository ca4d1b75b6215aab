"""rhino3dm, the official reader of .3dm, opens what Katydid writes."""

import math
import xml.etree.ElementTree as xml

import pytest
import rhino3dm

from program import ROOT, katydid


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    out = tmp_path_factory.mktemp("baked") / "attractor.3dm"
    katydid("run", "examples/attractor.ghx", "-o", out)
    model = rhino3dm.File3dm.Read(str(out))
    assert model is not None
    return model


def slider(name):
    for container in xml.parse(ROOT / "examples" / "attractor.ghx").getroot().iter("chunk"):
        if container.get("name") != "Container":
            continue
        names = [i.text for i in container.iterfind("items/item") if i.get("name") == "NickName"]
        if names == [name]:
            for item in container.iterfind("chunks/chunk[@name='Slider']/items/item"):
                if item.get("name") == "Value":
                    return float(item.text)
    raise AssertionError(f"no slider {name}")


def test_the_model_is_of_version_7_in_millimetres(model):
    assert model.ArchiveVersion == 70
    assert model.Settings.ModelUnitSystem == rhino3dm.UnitSystem.Millimeters


def test_the_circles_stand_on_the_grid_and_grow_towards_the_attractor(model):
    spacing, columns, rows = slider("spacing"), int(slider("columns")), int(slider("rows"))
    center = (slider("attractor x"), slider("attractor y"))
    small, large = slider("smallest"), slider("largest")
    points = [(i * spacing, j * spacing) for i in range(columns + 1) for j in range(rows + 1)]
    distances = [math.dist(p, center) for p in points]
    low, high = min(distances), max(distances)

    assert len(model.Objects) == len(points)
    for item, point, distance in zip(model.Objects, points, distances):
        curve = item.Geometry
        assert isinstance(curve, rhino3dm.ArcCurve) and curve.IsCompleteCircle
        circle = curve.Arc
        assert math.dist((circle.Center.X, circle.Center.Y), point) < 1e-12
        radius = large + (distance - low) / (high - low) * (small - large)
        assert circle.Radius == pytest.approx(radius, rel=1e-13)


def test_each_object_has_a_layer_of_its_name(model):
    assert [layer.Name for layer in model.Layers] == ["Circles"]
    assert {item.Attributes.LayerIndex for item in model.Objects} == {0}
    assert {item.Attributes.Name for item in model.Objects} == {"Circles"}


SUBDS = """katydid 1
rectangle = Rectangle(XY Plane(), 3, 2)
plane = Mesh Plane(rectangle, 3, 2)
box = Center Box(XY Plane(), 2, 2, 2)
hull = Mesh Box(box, 2, 2, 2)
flat = SubD from Mesh(plane, 1, 1)
cornered = SubD from Mesh(plane, 2, 2)
solid = SubD from Mesh(hull, 1, 1)
creased = SubD from Mesh(hull, 2, 1)
x = Line SDL((0, 0, 0), (1, 0, 0), 5)
y = Line SDL((0, 0, 0), (0, 1, 0), 5)
z = Line SDL((0, 0, 0), (0, 0, 1), 5)
ends = MultiPipe([x, y, z], 0.5)
capped = MultiPipe([x, y, z], 0.5, Caps = 2)
"""


def test_subds_are_valid_with_borders_creases_and_corners(tmp_path):
    definition, out = tmp_path / "subds.kd", tmp_path / "subds.3dm"
    definition.write_text(SUBDS)
    katydid("run", definition, "-o", out)
    subds = [item.Geometry for item in rhino3dm.File3dm.Read(str(out)).Objects if isinstance(item.Geometry, rhino3dm.SubD)]
    assert len(subds) == 6
    for subd in subds:
        assert subd.IsValid
        # What rhino3dm works out itself is what is written.
        written = subd.Encode()["data"]
        subd.UpdateAllTagsAndSectorCoefficients()
        assert subd.Encode()["data"] == written
