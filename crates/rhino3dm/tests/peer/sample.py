"""What the example `write_sample` writes, stated a second time."""

import math
import pathlib
import tempfile

import rhino3dm

from .common import close, example, xyz
from .curves import check_curve
from .geometry import check_geometry
from .meshes import check_stated_mesh
from .surfaces import check_surface


def sample_curves():
    """Name to what `write_sample` states about each curve."""
    x = [1 / math.sqrt(2), 1 / math.sqrt(2), 0]
    z = [0.5 / 1.5, -0.5 / 1.5, 2 / 1.5]
    length = math.sqrt(sum(c * c for c in z))
    z = [c / length for c in z]
    y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]]
    plane = [[1, 2, 3], x, y, z]
    root = math.sqrt(0.5)
    rational = {"kind": "nurbs", "domain": [0, 1], "degree": 2, "rational": True, "knots": [0, 0, 1, 1],
                "points": [[1, 0, 0, 1], [root, root, 0, root], [0, 1, 0, 1]]}
    return {
        "line": {"kind": "line", "domain": [-1, 3.5], "from": [1, 1, 0], "to": [5, 6, 0]},
        "arc": {"kind": "arc", "domain": [0, 4], "plane": plane, "radius": 2.75, "angle": [math.pi / 6, math.pi * 2 / 3]},
        "circle": {"kind": "arc", "domain": [0, 2.75 * math.tau], "plane": plane, "radius": 2.75, "angle": [0, math.tau]},
        "polyline": {"kind": "polyline", "domain": [0, 6], "points": [[i, i % 2, 0.1 * i] for i in range(7)],
                     "parameters": [0, 1, 2.5, 3, 4, 5.25, 6]},
        "nurbs": {"kind": "nurbs", "domain": [0, 4], "degree": 3, "rational": False, "knots": [0, 0, 0, 1, 1.5, 4, 4, 4],
                  "points": [[i, i * i / 3, 0.7, 1] for i in range(6)]},
        "rational": rational,
        "polycurve": {"kind": "poly", "domain": [0, 7], "parameters": [0, 2, 3, 7], "segments": [
            {"kind": "line", "domain": [0, 2], "from": [3, 0, 0], "to": [1, 0, 0]},
            rational,
            {"kind": "polyline", "domain": [0, 2], "points": [[0, 1, 0], [0, 2, 0], [-1, 2, 1]], "parameters": [0, 1, 2]},
        ]},
    }


def sample_plane():
    plane = sample_curves()["arc"]["plane"]
    return lambda x, y: [o + x * a + y * b for o, a, b in zip(*plane[:3])]


def sample_plane_surface():
    at, steps = sample_plane(), (0, 0.3, 0.5, 1)
    return {"kind": "plane", "domains": [[0, 1], [2, 8]],
            "samples": [at(-1 + 5 * x, 2 * y) for x in steps for y in steps]}


def check_sphere(sphere):
    centre = sample_plane()(0, 0)
    for u in (0, 1, 2.5, 6):
        for v in (-1.5, -0.2, 0, 1):
            close(math.dist(xyz(sphere.PointAt(u, v)), centre), 2.75, "sphere", 1e-12)


def sample_mesh():
    columns, rows = 20, 15
    faces = []
    for row in range(rows - 1):
        for column in range(columns - 1):
            a = row * columns + column
            if (row + column) % 3 == 0:
                faces += [[a, a + 1, a + columns + 1], [a, a + columns + 1, a + columns]]
            else:
                faces.append([a, a + 1, a + columns + 1, a + columns])
    count = columns * rows
    return {
        "vertices": [[(i % columns) * 0.1, (i // columns) / 3, i / 7] for i in range(count)],
        "faces": faces,
        "normals": [[0, 0.6, 0.8]] * count,
        "colours": [[i % 256, i // 2, 7, 255] for i in range(count)],
    }


def check_sample(version):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "sample.3dm"
        example("write_sample", path, version)
        file = rhino3dm.File3dm.Read(str(path))
        notes = rhino3dm.File3dm.ReadNotes(str(path))
    assert file is not None and file.ArchiveVersion == version
    assert notes == "Written for a reader.\nZweite Zeile.", notes
    assert file.Settings.ModelUnitSystem == rhino3dm.UnitSystem.Centimeters
    close(file.Settings.ModelAbsoluteTolerance, 0.0025)
    close(file.Settings.ModelAngleToleranceRadians, 0.02)
    assert file.ApplicationName == "Katydid"
    layers = [(layer.Name, layer.FullPath, layer.Color[:3]) for layer in file.Layers]
    assert layers == [("curves", "curves", (200, 30, 10)), ("conics ⌀", "curves::conics ⌀", (0, 128, 255)), ("rest", "rest", (0, 0, 0))], layers
    objects = {o.Attributes.Name: o for o in file.Objects}
    assert len(objects) == len(file.Objects) == 18
    for i, o in enumerate(file.Objects):
        assert o.Attributes.Id.int == 0xABCD_0000 + i + 1
        valid, log = o.Geometry.IsValidWithLog
        assert valid, f"{o.Attributes.Name}: {log}"
    where = {"point": 2, "cloud": 2, "line": 0, "arc": 1, "circle": 1, "polyline": 0, "nurbs": 0, "rational": 1,
             "polycurve": 0, "plane surface": 2, "sum surface": 2, "revolution": 2, "transposed revolution": 2,
             "sphere": 2, "nurbs surface": 2, "rational surface": 2, "mesh": 2, "plain mesh": 2}
    assert {name: o.Attributes.LayerIndex for name, o in objects.items()} == where
    line = objects["line"].Attributes
    assert line.ObjectColor[:3] == (12, 34, 56) and line.ColorSource == rhino3dm.ObjectColorSource.ColorFromObject
    assert line.Url == "https://example.org/"
    assert sorted(line.GetUserStrings()) == [("Länge", "√41"), ("material", "larch")], line.GetUserStrings()
    assert not objects["cloud"].Attributes.Visible and objects["point"].Attributes.Visible
    assert objects["arc"].Attributes.Mode == rhino3dm.ObjectMode.Locked
    assert objects["arc"].Attributes.ColorSource == rhino3dm.ObjectColorSource.ColorFromLayer
    close([0.1, -2.5, 1e6], xyz(objects["point"].Geometry.Location))
    cloud = {"points": [[i, 0.5, -1 / 3] for i in range(5)], "normals": [[0, 0, 1]] * 5, "values": [], "colours": [[10 * i, 20, 30, 255] for i in range(5)]}
    check_geometry({"detail": cloud, "kept": False, "class": "PointCloud"}, objects["cloud"].Geometry, "cloud")
    for name, curve in sample_curves().items():
        check_curve(curve, objects[name].Geometry, name)
    check_surface(sample_plane_surface(), objects["plane surface"].Geometry, "plane surface")
    check_sphere(objects["sphere"].Geometry)
    check_stated_mesh(sample_mesh(), objects["mesh"].Geometry, "mesh")
    plain = {"vertices": [[x, y, 0.25] for x, y in ((0, 0), (2, 0), (2, 1), (0, 1), (3, 0.5))],
             "faces": [[0, 1, 2, 3], [1, 4, 2]], "normals": [], "colours": []}
    check_stated_mesh(plain, objects["plain mesh"].Geometry, "plain mesh")
    return {name: o.Geometry for name, o in objects.items()}
