"""`katydid info` calls those objects invalid that rhino3dm, the official reader, calls invalid, and no others."""

import json
import subprocess

import pytest
import rhino3dm

from program import ROOT, binary

MODELS = ROOT.parent / "shared" / "data" / "3dm"
FILES = sorted(MODELS.glob("*.3dm")) if MODELS.exists() else []


def report(path):
    """What `katydid info` says; it ends with 1 where something is invalid."""
    done = subprocess.run([binary(), "info", str(path), "--json"], cwd=ROOT, capture_output=True, text=True)
    assert done.returncode in (0, 1), done.stderr
    return json.loads(done.stdout)


NIL = "00000000-0000-0000-0000-000000000000"


def ours(path):
    """The ids of what is invalid; the place in the file where it has none, as in version 1."""
    faults = report(path)["invalid"]
    return sorted(str(fault["object"]) if fault["id"] == NIL else fault["id"].lower() for fault in faults)


def theirs(path):
    # The reader makes up ids where there are none.
    named = rhino3dm.File3dm.ReadArchiveVersion(str(path)) > 1
    objects = enumerate(rhino3dm.File3dm.Read(str(path)).Objects)
    return sorted(str(o.Attributes.Id).lower() if named else str(i) for i, o in objects if not o.Geometry.IsValid)


@pytest.mark.skipif(not FILES, reason="the shared data is not there")
@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_models(path):
    assert ours(path) == theirs(path)


def mesh(vertices, faces, double=False):
    mesh = rhino3dm.Mesh()
    if double:
        mesh.Vertices.UseDoublePrecisionVertices = True
    for vertex in vertices:
        mesh.Vertices.Add(*vertex)
    for face in faces:
        mesh.Faces.AddFace(*face)
    return mesh


def curves():
    point = rhino3dm.Point3d
    yield rhino3dm.LineCurve(point(0, 0, 0), point(1, 0, 0))
    yield rhino3dm.LineCurve(point(1, 1, 1), point(1, 1, 1))
    yield rhino3dm.PolylineCurve([point(0, 0, 0), point(1, 0, 0), point(1, 0, 0), point(2, 2, 0)])
    yield rhino3dm.PolylineCurve([point(0, 0, 0), point(1, 0, 0), point(0, 0, 0)])
    yield rhino3dm.PolylineCurve([point(0, 0, 0), point(1, 0, 0), point(0, 1, 0), point(0, 0, 0)])
    yield rhino3dm.ArcCurve.CreateFromCircle(rhino3dm.Circle(2.0))
    for weights in ([1, 1, 1], [1, 0, 1], [1, -1, 1], [0, 1, 1], [1, 1, -1]):
        curve = rhino3dm.NurbsCurve(3, True, 3, 3)
        for i, weight in enumerate(weights):
            curve.Points[i] = rhino3dm.Point4d(i * weight, i * i * weight, 0, weight)
        for i, knot in enumerate([0, 0, 1, 1]):
            curve.Knots[i] = knot
        yield curve
    for knots in ([0, 0, 1, 1], [0, 0, 0, 1], [0, 1, 1, 1], [1, 0, 1, 1], [0, 0.5, 1, 2], [0, 0, 0, 0]):
        curve = rhino3dm.NurbsCurve(3, False, 3, 3)
        for i in range(3):
            curve.Points[i] = rhino3dm.Point4d(i, i * i, 0, 1)
        for i, knot in enumerate(knots):
            curve.Knots[i] = knot
        yield curve
    yield rhino3dm.NurbsCurve.Create(False, 1, [point(0, 0, 0), point(0, 0, 0)])
    yield rhino3dm.NurbsCurve.Create(False, 3, [point(1, 1, 1)] * 4)
    chain = rhino3dm.PolyCurve()
    chain.AppendSegment(rhino3dm.LineCurve(point(0, 0, 0), point(1, 0, 0)))
    chain.AppendSegment(rhino3dm.LineCurve(point(1, 0, 0), point(1, 1, 0)))
    yield chain


def solids():
    point, line = rhino3dm.Point3d, rhino3dm.Line
    for radius in (1e-6, 1e-3, 1.0, 1e5):
        yield rhino3dm.Sphere(point(1, 2, 3), radius).ToBrep()
        cylinder = rhino3dm.Cylinder(rhino3dm.Circle(point(0, 0, 0), radius), 3 * radius)
        for caps in (True, False):
            yield cylinder.ToBrep(caps, caps)
        yield rhino3dm.Brep.CreateFromBoundingBox(
            rhino3dm.BoundingBox(point(0, 0, 0), point(radius, radius, radius))
        )
        yield rhino3dm.Brep.CreateQuadSphere(rhino3dm.Sphere(point(1, 2, 3), radius))
    axis = line(point(0, 0, 0), point(0, 0, 1))
    profiles = [
        rhino3dm.LineCurve(point(0, 0, 2), point(1, 0, 0)),
        rhino3dm.LineCurve(point(1, 0, 0), point(2, 0, 3)),
        rhino3dm.ArcCurve.CreateFromArc(rhino3dm.Arc(point(2, 0, -1), point(3, 0, 0), point(2, 0, 1))),
        rhino3dm.ArcCurve.CreateFromArc(rhino3dm.Arc(point(0, 0, -1), point(1, 0, 0), point(0, 0, 1))),
        rhino3dm.PolylineCurve([point(0, 0, 0), point(1, 0, 0), point(1, 0, 1), point(0, 0, 2)]),
        rhino3dm.NurbsCurve.Create(False, 3, [point(0, 0, 0), point(2, 0, 1), point(1, 0, 2), point(0, 0, 3)]),
    ]
    for profile in profiles:
        for angles in ((0, 6.283185307179586), (0, 1.0), (0.5, 4.0)):
            surface = rhino3dm.RevSurface.Create(profile, axis, *angles)
            if surface is not None:
                yield surface
                yield surface.ToNurbsSurface()
                for caps in (True, False):
                    brep = rhino3dm.Brep.CreateFromRevSurface(surface, caps, caps)
                    if brep is not None:
                        yield brep
    for height in (1.0, -2.0):
        for cap in (True, False):
            yield rhino3dm.Extrusion.Create(rhino3dm.ArcCurve.CreateFromCircle(rhino3dm.Circle(2.0)), height, cap)


def meshes():
    square = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0), (0, 0, 0)]
    for double in (False, True):
        for faces in (
            [(0, 1, 2, 3)],
            [(0, 1, 4, 4)],
            [(0, 1, 4)],
            [(0, 1, 2), (0, 1, 2)],
            [(0, 1, 2), (0, 5, 1)],
            [(0, 1, 1, 2)],
            [(0, 1, 2, 0)],
            [(0, 1, 2, 1)],
        ):
            yield mesh(square, faces, double)
        yield mesh([(0, 0, 0), (1, 0, 0), (1, 1e-12, 0), (5, 5, 5)], [(0, 1, 2)], double)
        yield mesh(square, [], double)


@pytest.mark.parametrize("version", [4, 5, 6, 7, 8])
@pytest.mark.parametrize("shapes", [curves, solids, meshes], ids=lambda shapes: shapes.__name__)
def test_odd_shapes(tmp_path, shapes, version):
    model = rhino3dm.File3dm()
    for shape in shapes():
        model.Objects.Add(shape)
    path = tmp_path / "shapes.3dm"
    assert model.Write(str(path), version)
    assert ours(path) == theirs(path)


def test_what_is_unlucky_is_a_remark(tmp_path):
    model = rhino3dm.File3dm()
    model.Objects.AddMesh(mesh([(0, 0, 0), (1, 0, 0), (2, 0, 0)], [(0, 1, 2)]))
    path = tmp_path / "flat.3dm"
    assert model.Write(str(path), 7)
    said = report(path)
    assert said["invalid"] == [] and "no area" in said["remarks"][0]["why"]


EXAMPLES = ROOT / "docs" / "components" / "examples"


@pytest.mark.parametrize(
    "path",
    sorted(p for tab in ("surface-primitive", "surface-freeform", "transform-morph") for p in (EXAMPLES / tab).glob("*.kd")),
    ids=lambda path: path.stem,
)
def test_what_definitions_save(tmp_path, path):
    out = tmp_path / "saved.3dm"
    subprocess.run([binary(), "run", str(path), "-o", str(out)], cwd=ROOT, capture_output=True, check=True)
    assert ours(out) == theirs(out) == []
