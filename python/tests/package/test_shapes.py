"""Geometry against closed forms; copies; arrays; what is refused."""

import copy
import math
import pickle

import numpy as np
import pytest

import katydid as k


def everything():
    circle = k.Curve.circle((1, 2, 3), 2.0)
    box = k.Box(None, (0, 1), (0, 2), (0, 3))
    mesh = box.to_brep().to_mesh()
    return [k.Point(0.1, 2, 3), k.Vector(0.1, 2, 3), k.Interval(0, 0.1), k.Plane((1, 2, 3), normal=(1, 2, 3.3)), box,
            k.Transform.rotation(0.3, (1, 2, 3)), circle, k.Curve.line((0, 0, 0), (1, 2, 3)),
            k.Curve.interpolate(np.random.rand(9, 3)), k.sphere(None, 1.5), k.cylinder((0, 0, 1), 1, 2), mesh,
            k.SubD(mesh), k.Surface.plane(None, (0, 1), (0, 2)), k.Colour(1, 2, 3), circle.bounding_box]


@pytest.mark.parametrize("thing", everything(), ids=lambda thing: type(thing).__name__)
def test_copies_and_pickles_are_the_same(thing):
    assert pickle.loads(pickle.dumps(thing)) == thing
    assert copy.deepcopy(thing) == thing
    assert thing != object() and type(thing).__name__ in repr(thing)
    assert type(thing).__doc__


def test_points_and_vectors_are_not_the_same():
    p, q, v = k.Point(1, 2, 3), k.Point(4, 6, 3), k.Vector(3, 4, 0)
    assert q - p == v and p + v == q and v + p == q and q - v == p
    assert v.length == abs(v) == 5 and p.distance_to(q) == 5
    assert v.dot((1, 0, 0)) == 3 and k.Vector(1, 0, 0).cross((0, 1, 0)) == k.Vector(0, 0, 1)
    assert k.Vector(1, 0, 0).angle_to((0, 2, 0)) == pytest.approx(math.pi / 2)
    assert tuple(p) == (1, 2, 3) and p[-1] == 3 and len(p) == 3 and list(np.asarray(p)) == [1, 2, 3]
    assert {p, k.Point(1, 2, 3)} == {p}
    for wrong in (lambda: p + p, lambda: p[3], lambda: v / 0, lambda: k.Vector().unitized()):
        with pytest.raises((TypeError, IndexError, ZeroDivisionError, k.GeometryError)):
            wrong()


def test_a_circle_has_its_length_curvature_and_area():
    c = k.Curve.circle((1, 1, 0), 2)
    assert c.kind == "circle" and c.is_closed and c.length == pytest.approx(4 * math.pi, rel=1e-14)
    t = np.linspace(*c.domain, 100)
    angles = (t - c.domain.start) / c.domain.length * 2 * math.pi
    wanted = np.stack([1 + 2 * np.cos(angles), 1 + 2 * np.sin(angles), 0 * angles], axis=1)
    np.testing.assert_allclose(c.points_at(t), wanted, atol=1e-12)
    np.testing.assert_allclose(c.points_at(t), [list(c.point_at(x)) for x in t], atol=1e-15)
    np.testing.assert_allclose(np.linalg.norm(c.curvatures_at(t), axis=1), 0.5, atol=1e-12)
    np.testing.assert_allclose(np.linalg.norm(c.tangents_at(t), axis=1), 1, atol=1e-12)
    area, centroid = c.area_and_centroid()
    assert area == pytest.approx(4 * math.pi, rel=1e-12) and centroid.distance_to((1, 1, 0)) < 1e-12
    assert [c.contains(p) for p in ((1, 1, 0), (3, 1, 0), (4, 1, 0))] == [1, 0, -1]
    assert sorted(o.length for o in c.offset(0.5) + c.offset(-0.5)) == pytest.approx([3 * math.pi, 5 * math.pi])


def test_nurbs_have_their_parts():
    points = np.array([(0, 0, 0), (1, 2, 0), (3, 2, 0), (4, 0, 0)], dtype=float)
    c = k.Curve.nurbs(points)
    assert c.degree == 3 and c.point_at(c.domain.start) == k.Point(0, 0, 0)
    np.testing.assert_array_equal(c.control_points, points)
    assert len(c.knots) == 4 + 3 - 1
    a, b = c.domain
    # De Casteljau's middle of a cubic: an eighth of (1, 3, 3, 1).
    np.testing.assert_allclose(list(c.point_at((a + b) / 2)), np.array([1, 3, 3, 1]) / 8 @ points, atol=1e-15)
    quarter = k.Curve.nurbs([(1, 0, 0), (1, 1, 0), (0, 1, 0)], 2, weights=[1, math.sqrt(0.5), 1])
    np.testing.assert_allclose(np.linalg.norm(quarter.points_at(quarter.domain.linspace(20)), axis=1), 1, atol=1e-14)


def test_curves_are_divided_split_and_joined():
    line = k.Curve.line((0, 0, 0), (10, 0, 0))
    np.testing.assert_allclose(line.points_at(line.divide(5))[:, 0], [0, 2, 4, 6, 8, 10], atol=1e-12)
    parts = line.split(line.parameter_at_length(4))
    assert [p.length for p in parts] == pytest.approx([4, 6])
    (whole,) = k.Curve.join(parts)
    assert whole.length == pytest.approx(10)
    t, point, distance = line.closest_point((3, 4, 0))
    assert (point, distance) == (k.Point(3, 0, 0), 4)
    t, points, distances = line.closest_points([(3, 4, 0), (-3, 4, 0)])
    np.testing.assert_allclose(points, [[3, 0, 0], [0, 0, 0]], atol=1e-12)
    np.testing.assert_allclose(distances, [4, 5])
    assert line.extended(1, 2).length == 13 and line.reversed().start == k.Point(10, 0, 0)
    points, t = k.intersect(line, k.Curve.line((5, -1, 0), (5, 1, 0)))
    assert points == [k.Point(5, 0, 0)]


def test_surfaces_are_evaluated_in_arrays():
    s = k.sphere(None, 2).face_surface(0)
    (u0, u1), (v0, v1) = s.domains
    uv = np.random.default_rng(3).random((50, 2)) * [u1 - u0, v1 - v0] * 0.9 + [u0, v0]
    points, normals = s.points_at(uv), s.normals_at(uv)
    np.testing.assert_allclose(np.linalg.norm(points, axis=1), 2, atol=1e-12)
    np.testing.assert_allclose(np.abs((points * normals).sum(axis=1)), 2, atol=1e-9)
    assert s.area == pytest.approx(16 * math.pi, rel=1e-9)
    gaussian, mean = s.gaussian_and_mean_at(1.0, 0.3)
    assert gaussian == pytest.approx(0.25, rel=1e-9) and abs(mean) == pytest.approx(0.5, rel=1e-9)
    grid = s.grid_points([u0, u1], np.linspace(v0, v1, 3))
    assert grid.shape == (6, 3)
    (u, v), point, distance = s.closest_point((5, 0, 0))
    assert distance == pytest.approx(3, abs=1e-9)
    grid = np.array([[(x, y, x * y) for y in range(4)] for x in range(4)], dtype=float)
    assert k.Surface.nurbs(grid).point_at(0, 0) == k.Point(0, 0, 0)


def test_solids_have_their_volumes():
    for solid, volume, area in [
            (k.sphere((1, 2, 3), 2), 32 / 3 * math.pi, 16 * math.pi),
            (k.cylinder(None, 1, 3), 3 * math.pi, 8 * math.pi),
            (k.cone(None, 3, 4), 12 * math.pi, 24 * math.pi),
            (k.torus(None, 3, 1), 6 * math.pi ** 2, 12 * math.pi ** 2),
            (k.Box(None, (0, 1), (0, 2), (0, 3)).to_brep(), 6, 22),
            (k.extrude(k.Curve.circle(None, 1), (0, 0, 2), capped=True), 2 * math.pi, 6 * math.pi)]:
        assert solid.is_solid and solid.is_valid, solid
        assert solid.volume == pytest.approx(volume, rel=1e-8) and solid.area == pytest.approx(area, rel=1e-8)
    assert k.sphere((1, 2, 3), 2).centroid.distance_to((1, 2, 3)) < 1e-9
    assert k.sphere(None, 1).contains((0, 0, 0)) == 1
    (section,) = k.sphere(None, 1).section(k.Plane((0, 0, 0.6)))
    assert section.length == pytest.approx(2 * math.pi * 0.8, rel=1e-6)
    loft = k.loft([k.Curve.circle((0, 0, z), 1) for z in (0, 1, 2)], style="straight")
    assert loft.area == pytest.approx(4 * math.pi, rel=1e-6)


def test_meshes_are_arrays():
    m = k.Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], np.array([[0, 1, 2, 3]]))
    assert m.area == 1 and len(m) == 1 and m.triangles.shape == (2, 3)
    np.testing.assert_array_equal(m.faces, [[0, 1, 2, 3]])
    np.testing.assert_array_equal(m.face_normals, [[0, 0, 1]])
    assert k.Mesh(m.vertices, m.triangles).area == 1
    assert k.Mesh(m.vertices, [[0, 1, 2], [0, 2, 3]], colors=np.zeros((4, 3))).colors.shape == (4, 4)
    a, b = (k.Box(None, (x, x + 1), (0, 1), (0, 1)).to_brep().to_mesh() for x in (0, 0.5))
    assert [round(x.volume, 9) for x in (a | b, a & b, a - b)] == [1.5, 0.5, 0.5]
    points, distances = a.closest_points([(0.5, 0.5, 3), (-1, 0.5, 0.5)])
    np.testing.assert_allclose(distances, [2, 1])
    assert [round(t, 9) for t, _, _ in a.ray_hits((0.5, 0.25, -1), (0, 0, 1))] == [1, 2]
    with pytest.raises(k.GeometryError):
        m.volume


def test_a_subd_of_a_cube_lies_on_its_limit():
    cube = k.Box(None, (-1, 1), (-1, 1), (-1, 1)).to_brep().to_mesh().welded()
    subd = k.SubD(cube, creases=False)
    # The limit of a corner where three edges meet, by Catmull and Clark's mask (9 v + 4 Σe + Σf) / 24.
    neighbours = np.array([(-1, 1, 1), (1, -1, 1), (1, 1, -1)])
    opposite = np.array([(-1, -1, 1), (-1, 1, -1), (1, -1, -1)])
    wanted = (9 * np.ones(3) + 4 * neighbours.sum(axis=0) + opposite.sum(axis=0)) / 24
    np.testing.assert_allclose(np.abs(subd.limit_points), np.tile(np.abs(wanted), (8, 1)), atol=1e-12)
    assert len(subd.to_mesh(2)) == 96
    with pytest.raises(k.GeometryError):
        subd.to_mesh(99)


def test_transforms_apply_to_all():
    turn = k.Transform.rotation(math.pi / 2)
    move = k.Transform.translation((1, 0, 0))
    assert ((move @ turn) @ k.Point(1, 0, 0)).distance_to((1, 1, 0)) < 1e-15
    np.testing.assert_allclose(turn @ np.array([[1.0, 0, 0]]), [[0, 1, 0]], atol=1e-15)
    assert (turn @ turn.inverse()).determinant == pytest.approx(1)
    assert (k.Transform.scale(2) @ k.sphere(None, 1)).volume == pytest.approx(32 / 3 * math.pi, rel=1e-8)
    assert (move @ k.Curve.line((0, 0, 0), (0, 0, 1))).start == k.Point(1, 0, 0)


@pytest.mark.parametrize("wrong", [
    lambda: k.Curve.circle(None, -1), lambda: k.Curve.circle(None, math.nan), lambda: k.Curve.line((0, 0, 0), (0, 0, math.inf)),
    lambda: k.Curve.polyline([]), lambda: k.Curve.polyline(np.zeros((2, 2))), lambda: k.Curve.nurbs(np.random.rand(2, 3), 5),
    lambda: k.Mesh([(0, 0, 0)], [[0, 1, 2]]), lambda: k.Mesh(np.zeros((3, 3)), np.array([[0.0, 1, 2]])),
    lambda: k.Mesh(np.zeros((3, 3)), [[0, 1]]), lambda: k.Mesh(np.zeros((3, 3)), np.array([[0, 1, -1]])),
    lambda: k.sphere(None, 0), lambda: k.from_json("{}"), lambda: k.from_json("nonsense"), lambda: k.Plane(normal=(0, 0, 0)),
    lambda: k.loft([]), lambda: k.Curve.line((0, 0, 0), (1, 0, 0)).offset(1, corner="wild"),
    lambda: k.sphere(None, 1).filleted([99], 0.1), lambda: k.Transform([[1]]), lambda: k.Curve.circle("a", 1),
    lambda: k.sphere(None, 1).to_mesh(-1), lambda: k.intersect(k.Curve.circle(None, 1), 3),
])
def test_what_cannot_be_is_an_error(wrong):
    with pytest.raises((k.KatydidError, ValueError, TypeError, IndexError)):
        wrong()


def test_without_numpy_there_are_lists(tmp_path):
    import os
    import subprocess
    import sys
    code = ("import sys; sys.path.insert(0, %r); sys.modules['numpy'] = None\n"
            "import katydid as k\nc = k.Curve.line((0, 0, 0), (2, 0, 0))\n"
            "assert c.points_at([0, c.domain.end]) == [k.Point(0, 0, 0), k.Point(2, 0, 0)]\n"
            "m = k.Mesh([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [[0, 1, 2]])\n"
            "assert m.triangles == [[0, 1, 2]] and m.faces == [[0, 1, 2]]\nprint('well')"
            ) % os.path.dirname(os.path.dirname(k.__file__))
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout == "well\n"


def test_solids_are_united_and_taken_from_each_other():
    a = k.Box(None, (0, 2), (0, 2), (0, 2)).to_brep()
    b = k.Box(None, (1, 3), (1, 3), (1, 3)).to_brep()
    assert [s.volume for s in a | b] == pytest.approx([15])
    assert [s.volume for s in a & b] == pytest.approx([1])
    assert [s.volume for s in a - b] == pytest.approx([7])
    hole = k.cylinder((1, 1, -1), 0.5, 4)
    # The whole column in a, and a quarter of it in b above.
    assert [s.volume for s in (a | b) - hole] == pytest.approx([15 - math.pi * 9 / 16], rel=1e-8)
    assert [s.volume for s in a.difference([b, hole], tolerance=1e-6)][0] < 7
    assert a - a == [] and a & k.sphere((9, 9, 9), 1) == []
