"""Models in files, and geometry of other packages."""

import math

import numpy as np
import pytest

import katydid as k


@pytest.mark.parametrize("ending", ["3dm", "step"])
def test_exact_forms_keep_solids_and_curves(tmp_path, ending):
    path = tmp_path / ("model." + ending)
    things = [k.ModelObject(k.sphere((1, 2, 3), 2), name="ball", layer="Shapes"), k.Curve.circle(None, 3), k.Point(1, 2, 3)]
    assert k.write(path, things) == []
    model = k.read(path)
    assert len(model) == 3 and model.units == "Millimeters" and model[0].name == "ball"
    assert model[0].geometry.volume == pytest.approx(32 / 3 * math.pi, rel=1e-8)
    assert model.geometry[1].length == pytest.approx(6 * math.pi, rel=1e-9)
    assert model[-1].geometry == k.Point(1, 2, 3)


@pytest.mark.parametrize("ending, scale", [("obj", 1), ("stl", 1), ("ply", 1), ("glb", 1e-3), ("gltf", 1e-3), ("3dm", 1)])
def test_forms_of_meshes_keep_meshes(tmp_path, ending, scale):
    box = k.Box(None, (0, 1), (0, 2), (0, 3)).to_brep().to_mesh()
    k.write(tmp_path / ("mesh." + ending), box)
    (mesh,) = k.read(tmp_path / ("mesh." + ending)).geometry
    assert mesh.area == pytest.approx(22 * scale ** 2, rel=1e-6)


def test_files_that_are_none_are_refused(tmp_path):
    for name in ("a.3dm", "a.step", "a.obj", "a.glb"):
        with pytest.raises(k.FileError, match=name):
            k.read(tmp_path / name)
        (tmp_path / name).write_bytes(b"\x00\xff nonsense" * 10)
        if name != "a.obj":
            with pytest.raises(k.FileError, match=name):
                k.read(tmp_path / name)
    with pytest.raises(k.FileError):
        k.write(tmp_path / "a.doc", k.Point())
    with pytest.raises(TypeError):
        k.write(tmp_path / "a.3dm", [object()])
    with pytest.raises(ValueError, match="cubits"):
        k.write(tmp_path / "a.3dm", [k.Point()], units="cubits")
    assert not (tmp_path / "a.doc").exists()


def test_rhino3dm_has_the_same_geometry():
    r = pytest.importorskip("rhino3dm")
    sphere = k.to_rhino3dm(k.sphere((1, 2, 3), 2))
    assert isinstance(sphere, r.Brep) and sphere.IsSolid
    box = sphere.GetBoundingBox()
    assert (box.Min.X, box.Max.Z) == pytest.approx((-1, 5))
    assert k.from_rhino3dm(sphere).volume == pytest.approx(32 / 3 * math.pi, rel=1e-8)
    circle = k.to_rhino3dm(k.Curve.circle(None, 2))
    assert circle.PointAt(circle.Domain.T0).X == 2
    assert k.from_rhino3dm(r.Circle(r.Point3d(0, 0, 0), 3)).length == pytest.approx(6 * math.pi)
    assert k.from_rhino3dm(r.Point3d(1, 2, 3)) == k.Point(1, 2, 3)
    mesh = k.to_rhino3dm(k.Box(None, (0, 1), (0, 1), (0, 1)).to_brep().to_mesh())
    assert len(mesh.Faces) == 6 and k.from_rhino3dm(mesh).volume == pytest.approx(1)
    assert k.to_rhino3dm(k.Plane((1, 2, 3))).Origin.Z == 3
    with pytest.raises(k.NotSupportedError):
        k.from_rhino3dm(3)


def test_trimesh_has_the_same_mesh():
    pytest.importorskip("trimesh")
    mesh = k.Box(None, (0, 1), (0, 2), (0, 3)).to_brep().to_mesh()
    there = k.to_trimesh(mesh)
    assert there.volume == pytest.approx(6) and k.from_trimesh(there).volume == pytest.approx(6)


def test_compas_has_the_same_geometry():
    g = pytest.importorskip("compas.geometry")
    assert k.from_compas(g.Point(1, 2, 3)) == k.Point(1, 2, 3) and k.to_compas(k.Vector(1, 2, 3)) == g.Vector(1, 2, 3)
    frame = k.to_compas(k.Plane((1, 2, 3), normal=(1, 0, 0)))
    assert k.from_compas(frame).normal == k.Vector(1, 0, 0)
    assert k.from_compas(g.Polyline([(0, 0, 0), (3, 4, 0), (3, 4, 5)])).length == 10
    assert k.from_compas(g.Circle(2, frame=g.Frame.worldXY())).length == pytest.approx(4 * math.pi)
    mesh = k.Box(None, (0, 1), (0, 2), (0, 3)).to_brep().to_mesh().welded()
    assert k.from_compas(k.to_compas(mesh)).volume == pytest.approx(6)
    turn = k.Transform.rotation(0.5, (1, 2, 3))
    np.testing.assert_allclose(k.from_compas(k.to_compas(turn)).rows, turn.rows)


def test_rhinos_modules_stand_on_the_extension(monkeypatch):
    from katydid import backend
    monkeypatch.delenv("KATYDID", raising=False)
    before = backend.use(None)
    try:
        from katydid import rhino
        rhino.install()
        assert isinstance(backend.current(), backend.Extension)
        import Rhino.Geometry as rg
        assert rg.LineCurve(rg.Point3d(0, 0, 0), rg.Point3d(3, 4, 0)).GetLength() == 5
        with pytest.raises(Exception, match="Nonsense"):
            rg.Nonsense()
    finally:
        rhino.uninstall()
        backend.use(before)
