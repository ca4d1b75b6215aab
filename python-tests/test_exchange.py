"""Independent readers open what Katydid converts from models that rhino3dm wrote."""

import json
import math
import xml.etree.ElementTree as xml

import numpy as np
import plyfile
import pygltflib
import pytest
import rhino3dm
import svgelements
import trimesh

from program import ROOT, katydid

NAME = 'bäll "<&>" 1'


def ball(center, radius, around=24, up=12):
    mesh = rhino3dm.Mesh()
    for i in range(1, up):
        for j in range(around):
            a, b = math.pi * i / up, 2 * math.pi * j / around
            mesh.Vertices.Add(
                center[0] + radius * math.sin(a) * math.cos(b),
                center[1] + radius * math.sin(a) * math.sin(b),
                center[2] + radius * math.cos(a),
            )
    for i in range(up - 2):
        for j in range(around):
            k = (j + 1) % around
            mesh.Faces.AddFace(i * around + j, (i + 1) * around + j, (i + 1) * around + k, i * around + k)
    for ring, turn in ((0, 1), (up - 2, -1)):
        tip = len(mesh.Vertices)
        mesh.Vertices.Add(center[0], center[1], center[2] + (radius if ring == 0 else -radius))
        for j in range(around):
            k = (j + 1) % around
            corners = [ring * around + j, ring * around + k][::turn]
            mesh.Faces.AddFace(tip, *corners)
    mesh.Normals.ComputeNormals()
    return mesh


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    """A coloured ball and a plain one on two layers, a circle, a curve of degree 3, a polyline, two points; in inches."""
    model = rhino3dm.File3dm()
    model.Settings.ModelUnitSystem = rhino3dm.UnitSystem.Inches
    outer = rhino3dm.Layer()
    outer.Name, outer.Color = "outer", (10, 200, 30, 255)
    model.Layers.Add(outer)
    inner = rhino3dm.Layer()
    inner.Name, inner.ParentLayerId = "inner", model.Layers[0].Id
    model.Layers.Add(inner)
    attributes = rhino3dm.ObjectAttributes()
    attributes.Name, attributes.LayerIndex = NAME, 1
    attributes.ObjectColor, attributes.ColorSource = (255, 0, 0, 255), rhino3dm.ObjectColorSource.ColorFromObject
    model.Objects.AddMesh(ball((1, 2, 3), 2), attributes)
    plain = rhino3dm.ObjectAttributes()
    plain.LayerIndex = 0
    model.Objects.AddMesh(ball((-20, 0, 0), 4), plain)
    model.Objects.AddCircle(rhino3dm.Circle(5))
    points = [(0, 0, 0), (1, 3, 0), (3, -2, 1), (5, 4, 0), (8, 0, 0)]
    model.Objects.AddCurve(rhino3dm.NurbsCurve.Create(False, 3, [rhino3dm.Point3d(*p) for p in points]))
    model.Objects.AddPolyline(rhino3dm.Polyline([rhino3dm.Point3d(*p) for p in points]))
    model.Objects.AddPoint(rhino3dm.Point3d(9, 9, 9))
    path = tmp_path_factory.mktemp("exchange") / "model.3dm"
    assert model.Write(str(path), 7)
    return path


def converted(model, extension, *options):
    out = model.with_suffix("." + extension)
    katydid("convert", model, out, *options)
    return out


def expected_volume():
    total = 0.0
    for center, radius in (((1, 2, 3), 2), ((-20, 0, 0), 4)):
        mesh = ball(center, radius)
        points = np.array([[v.X, v.Y, v.Z] for v in mesh.Vertices])
        faces = []
        for i in range(len(mesh.Faces)):
            a, b, c, d = mesh.Faces[i]
            faces += [[a, b, c]] if c == d else [[a, b, c], [a, c, d]]
        total += trimesh.Trimesh(points, faces, process=False).volume
    return total


@pytest.mark.parametrize("options", [(), ("--ascii",)])
def test_stl_is_two_closed_balls(model, options):
    mesh = trimesh.load(converted(model, "stl", *options), force="mesh")
    assert mesh.is_watertight
    assert mesh.volume == pytest.approx(expected_volume(), rel=1e-5)


def test_obj_has_objects_groups_lines_and_normals(model):
    path = converted(model, "obj")
    text = path.read_text()
    assert "g outer::inner\no bäll_\"<&>\"_1\n" in text
    scene = trimesh.load_scene(path)
    meshes = [g for g in scene.geometry.values() if isinstance(g, trimesh.Trimesh)]
    assert sum(m.volume for m in meshes) == pytest.approx(expected_volume(), rel=1e-6)
    lines = [line.split()[1:] for line in text.splitlines() if line.startswith("l ")]
    vertices = [tuple(map(float, line.split()[1:4])) for line in text.splitlines() if line.startswith("v ")]
    circle = next(line for line in lines if len(line) > 20 and line and abs(math.hypot(*vertices[int(line[0]) - 1]) - 5) < 1e-9)
    assert all(abs(math.hypot(*vertices[int(i) - 1]) - 5) < 1e-9 for i in circle)
    assert "\np " in text and "\nvn " in text


@pytest.mark.parametrize("options", [(), ("--ascii",)])
def test_ply_has_vertices_faces_edges_and_colours(model, options):
    path = converted(model, "ply", *options)
    data = plyfile.PlyData.read(path)
    assert {"vertex", "face", "edge"} <= {element.name for element in data.elements}
    vertices, faces = data["vertex"], data["face"]
    points = np.stack([vertices[axis] for axis in "xyz"], axis=1)
    triangles = []
    for corners in faces["vertex_indices"]:
        triangles += [[corners[0], corners[i], corners[i + 1]] for i in range(1, len(corners) - 1)]
    mesh = trimesh.Trimesh(points, triangles, process=False)
    assert mesh.volume == pytest.approx(expected_volume(), rel=1e-9)
    first = faces["vertex_indices"][0][0]
    assert [int(vertices[part][first]) for part in ("red", "green", "blue")] == [255, 0, 0]


@pytest.mark.parametrize("extension", ["glb", "gltf"])
def test_gltf_is_in_metres_with_y_up_and_layers_as_nodes(model, extension):
    path = converted(model, extension)
    scene = trimesh.load(path)
    meshes = [g for g in scene.dump() if isinstance(g, trimesh.Trimesh)]
    assert sum(m.volume for m in meshes) == pytest.approx(expected_volume() * 0.0254**3, rel=1e-4)
    red = next(m for m in meshes if m.volume < 40 * 0.0254**3)
    # (1, 2, 3) inches: x stays, z goes up to y, y goes back to −z.
    assert np.allclose(red.bounds.mean(axis=0) / 0.0254, [1, 3, -2], atol=1e-4)
    gltf = pygltflib.GLTF2().load(str(path))
    by_name = {node.name: node for node in gltf.nodes if node.name}
    assert {"outer", "inner", NAME} <= set(by_name)
    nodes = gltf.nodes
    assert NAME in [nodes[i].name for i in by_name["inner"].children]
    assert "inner" in [nodes[i].name for i in by_name["outer"].children]
    primitive = gltf.meshes[by_name[NAME].mesh].primitives[0]
    material = gltf.materials[primitive.material].pbrMetallicRoughness
    assert material.baseColorFactor == [1.0, 0.0, 0.0, 1.0]
    modes = {p.mode for mesh in gltf.meshes for p in mesh.primitives}
    assert modes == {0, 3, 4}


def test_svg_is_exact_and_in_true_size(model):
    path = converted(model, "svg")
    tree = xml.parse(path).getroot()
    assert tree.get("width").endswith("in")
    titles = [e.text for e in tree.iter("{http://www.w3.org/2000/svg}title")]
    assert NAME in titles and "outer" in titles
    paths = [svgelements.Path(e.get("d")) for e in tree.iter("{http://www.w3.org/2000/svg}path")]
    circle = next(p for p in paths if any(isinstance(s, svgelements.Arc) for s in p))
    x0, y0, x1, y1 = circle.bbox()
    assert np.allclose([x0, y0, x1, y1], [-5, -5, 5, 5], atol=1e-9)
    cubic = next(p for p in paths if any(isinstance(s, svgelements.CubicBezier) for s in p))
    source = rhino3dm.File3dm.Read(str(model))
    curves = [o.Geometry for o in source.Objects if isinstance(o.Geometry, rhino3dm.NurbsCurve)]
    curve = next(curve for curve in curves if curve.Degree == 3)
    segments = [s for s in cubic if isinstance(s, svgelements.CubicBezier)]
    assert len(segments) == 2
    for i, segment in enumerate(segments):
        domain = curve.Domain
        for k in range(11):
            t = domain.T0 + (domain.T1 - domain.T0) * (i + k / 10) / 2
            p, q = curve.PointAt(t), segment.point(k / 10)
            assert math.hypot(p.X - q.x, p.Y + q.y) < 1e-9


def test_info_counts_as_rhino3dm_does(model):
    report = json.loads(katydid("info", model, "--json").stdout)
    source = rhino3dm.File3dm.Read(str(model))
    assert sum(report["objects"].values()) == len(source.Objects)
    assert [layer["path"] for layer in report["layers"]] == [layer.FullPath for layer in source.Layers]
    assert report["units"] == "Inches" and report["invalid"] == []


def test_obj_has_its_materials_beside_it(model):
    path = converted(model, "obj")
    assert path.with_suffix(".mtl").exists()
    meshes = [g for g in trimesh.load_scene(path).geometry.values() if isinstance(g, trimesh.Trimesh)]
    colours = {round(m.volume): list(m.visual.material.diffuse) for m in meshes}
    small, large = sorted(colours)
    assert colours[small] == [255, 0, 0, 255] and colours[large] == [10, 200, 30, 255]
    back = path.with_name("back.3dm")
    katydid("convert", path, back)
    read = rhino3dm.File3dm.Read(str(back))
    named = next(o for o in read.Objects if isinstance(o.Geometry, rhino3dm.Mesh) and o.Attributes.ObjectColor[:3] == (255, 0, 0))
    assert named.Attributes.Name == 'bäll_"<&>"_1'


def test_dots_are_text_in_drawings_and_told_of_elsewhere(tmp_path):
    model = rhino3dm.File3dm()
    model.Objects.AddTextDot("a < b", rhino3dm.Point3d(1, 2, 3))
    model.Objects.AddLine(rhino3dm.Point3d(0, 0, 0), rhino3dm.Point3d(10, 5, 0))
    path = tmp_path / "dots.3dm"
    assert model.Write(str(path), 7)
    tree = xml.parse(converted(path, "svg")).getroot()
    [text] = list(tree.iter("{http://www.w3.org/2000/svg}text"))
    assert "".join(text.itertext()) == "a < b"
    assert text.get("transform").endswith(" 1 -2)")
    told = katydid("convert", path, tmp_path / "dots.obj").stderr
    assert "1 × text: only drawings show text" in told


def corners(source, objects, outer):
    """The corners of the solids among objects, where blocks put them."""
    for member in objects:
        geometry = member.Geometry
        if isinstance(geometry, rhino3dm.InstanceReference):
            block = source.InstanceDefinitions.FindId(geometry.ParentIdefId)
            inside = [source.Objects.FindId(str(id)) for id in block.GetObjectIds()]
            yield from corners(source, inside, rhino3dm.Transform.Multiply(outer, geometry.Xform))
        elif isinstance(geometry, rhino3dm.Extrusion):
            brep = geometry.ToBrep(False)
            for i in range(len(brep.Vertices)):
                p = brep.Vertices[i].Location.Transform(outer)
                yield [p.X, p.Y, p.Z]


NESTED = ROOT.parent / "shared" / "data" / "3dm" / "jesterKing+import_3dm__399290a6_nested_blocks.3dm"


@pytest.mark.skipif(not NESTED.exists(), reason="the shared data is not there")
def test_blocks_in_blocks_stand_where_rhino3dm_puts_them(tmp_path):
    source = rhino3dm.File3dm.Read(str(NESTED))
    top = [o for o in source.Objects if not o.Attributes.IsInstanceDefinitionObject]
    expected = np.array(list(corners(source, top, rhino3dm.Transform.Identity())))
    out = tmp_path / "nested.ply"
    katydid("convert", NESTED, out)
    vertices = plyfile.PlyData.read(out)["vertex"]
    found = np.stack([vertices[axis] for axis in "xyz"], axis=1)
    assert len(expected) > 0
    assert np.allclose(found.min(axis=0), expected.min(axis=0), atol=1e-4)
    assert np.allclose(found.max(axis=0), expected.max(axis=0), atol=1e-4)


SUBDS = ROOT.parent / "shared" / "data" / "3dm" / "mcneel+rhino-developer-samples__d01029d9_input.3dm"


@pytest.mark.skipif(not SUBDS.exists(), reason="the shared data is not there")
def test_subds_are_the_surface_that_rhino3dm_has(tmp_path):
    source = rhino3dm.File3dm.Read(str(SUBDS))
    [subd] = [o.Geometry for o in source.Objects if isinstance(o.Geometry, rhino3dm.SubD)]
    subd.ClearEvaluationCache()
    out = tmp_path / "subd.ply"
    katydid("convert", SUBDS, out, "--hidden")
    vertices = plyfile.PlyData.read(out)["vertex"]
    found = {tuple(round(float(vertices[axis][i]), 5) for axis in "xyz") for i in range(len(vertices))}
    on = [subd.Vertices[i + 1] for i in range(subd.VertexCount)]
    places = [tuple(round(x, 5) for x in (p.X, p.Y, p.Z)) for p in (v.SurfacePoint for v in on if v and not v.IsDart)]
    missing = [p for p in places if p not in found]
    assert len(missing) <= len(places) // 100, "rounding may part a few"
