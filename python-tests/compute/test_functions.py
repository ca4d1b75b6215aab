"""rhino3dm reads the geometry that functions called by path give, and finds the same numbers."""

import json
import math
import subprocess

import pytest
import rhino3dm as r
from program import ROOT, example

P = r.Point3d


@pytest.fixture(scope="module")
def program():
    with subprocess.Popen([example("endpoint")], cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as running:
        yield running
        running.stdin.close()


@pytest.fixture
def call(program):
    def reply(path, *arguments):
        program.stdin.write(json.dumps({"path": path, "body": arguments}) + "\n")
        program.stdin.flush()
        answer = json.loads(program.stdout.readline())
        assert "fault" not in answer, answer
        return answer["reply"]

    return reply


def sent(geometry):
    return geometry.Encode()


def given(json_object):
    geometry = r.CommonObject.Decode(json_object)
    assert geometry is not None
    return geometry


def point(p):
    return {"X": p.X, "Y": p.Y, "Z": p.Z}


def mesh():
    m = r.Mesh()
    for p in [(0, 0, 0), (2, 0, 0), (2, 1, 0.5), (0, 1, 0.1), (1, 3, 0.7)]:
        m.Vertices.Add(*p)
    m.Faces.AddFace(0, 1, 2, 3)
    m.Faces.AddFace(3, 2, 4)
    return m


def polyline():
    line = r.Polyline()
    for p in [(0, 0, 0), (1, 0.5, 0), (2, -1, 1), (4, 0, 0)]:
        line.Add(*p)
    return line.ToPolylineCurve()


def curves():
    arc = r.Arc(P(0, 0, 0), 3.0, 2.0).ToNurbsCurve()
    chain = r.PolyCurve()
    chain.Append(r.LineCurve(P(0, 0, 0), P(3, 0, 0)))
    chain.Append(r.LineCurve(P(3, 0, 0), P(3, 4, 1)))
    points = [P(0, 0, 0), P(1, 2, 0), P(3, 1, 1), P(5, 0, 0), P(6, 3, 0)]
    return {
        "line": r.LineCurve(P(-1, 2, 3), P(4, 5, 6)),
        "arc": arc,
        "circle": r.Circle(P(1, 2, 3), 5.0).ToNurbsCurve(),
        "polyline": polyline(),
        "polycurve": chain,
        "nurbs": r.NurbsCurve.Create(False, 3, points),
        "periodic": r.NurbsCurve.Create(True, 3, points),
    }


def surfaces():
    bottom, top = curves()["nurbs"], r.NurbsCurve.Create(False, 2, [P(0, 0, 5), P(3, 4, 5), P(6, 0, 6)])
    return {
        "ruled": r.NurbsSurface.CreateRuledSurface(bottom, top),
        "sphere": r.Sphere(P(1, 0, 0), 2.0).ToNurbsSurface(),
        "plane": r.PlaneSurface(r.Plane.WorldXY(), r.Interval(0, 4), r.Interval(1, 3)),
    }


def solids():
    extrusion = r.Extrusion.Create(r.Circle(P(0, 0, 0), 2.0).ToNurbsCurve(), 5.0, True)
    return {
        "sphere": r.Sphere(P(1, 0, 0), 2.0).ToBrep(),
        "cylinder": r.Cylinder(r.Circle(P(0, 0, 0), 2.0), 5.0).ToBrep(True, True),
        "box": r.Brep.CreateFromBox(r.Box(r.BoundingBox(P(0, 0, 0), P(1, 2, 3)))),
        "extrusion": extrusion,
    }


# Those with corners: the chords of a sample would cut them.
LENGTHS = {
    "polyline": math.dist((0, 0, 0), (1, 0.5, 0)) + math.dist((1, 0.5, 0), (2, -1, 1)) + math.dist((2, -1, 1), (4, 0, 0)),
    "polycurve": 3 + math.sqrt(17),
}
VOLUMES = {"sphere": 4 / 3 * math.pi * 8, "cylinder": 20 * math.pi, "box": 6.0, "extrusion": 20 * math.pi}


@pytest.mark.parametrize("name", curves())
def test_curves_have_the_same_points_lengths_and_boxes(call, name):
    curve = curves()[name]
    domain = curve.Domain
    for share in (0.1, 0.37, 0.8):
        t = domain.T0 + share * (domain.T1 - domain.T0)
        p = curve.PointAt(t)
        found = call("curve/localclosestpoint-curve_point3d_double_double", sent(curve), point(p), t)
        assert found[0] and curve.PointAt(found[1]).DistanceTo(p) < 1e-9
    steps = [curve.PointAt(domain.T0 + (domain.T1 - domain.T0) * k / 20000) for k in range(20001)]
    length = LENGTHS.get(name) or sum(a.DistanceTo(b) for a, b in zip(steps, steps[1:]))
    assert call("curve/getlength-curve", sent(curve)) == pytest.approx(length, rel=1e-6)
    box = call("geometrybase/getboundingbox-geometrybase_bool", sent(curve), True)
    assert all(box["Min"]["X"] - 1e-9 <= p.X <= box["Max"]["X"] + 1e-9 for p in steps)


@pytest.mark.parametrize("name", curves())
def test_curves_come_back_as_they_went(call, name):
    curve = curves()[name]
    if curve.IsClosed:
        # It has no ends: joined with nothing it comes back too.
        [back] = map(given, call("curve/joincurves-curvearray", [sent(curve)]))
    else:
        back = given(call("curve/extend-curve_curveend_double_curveextensionstyle", sent(curve), 0, 0.0, 0))
    assert back.IsValid
    assert type(back) is type(curve)
    for share in (0.0, 0.3, 0.9):
        t = curve.Domain.T0 + share * (curve.Domain.T1 - curve.Domain.T0)
        assert back.PointAt(t).DistanceTo(curve.PointAt(t)) < 1e-12


@pytest.mark.parametrize("name", surfaces())
def test_nearest_points_of_surfaces_are_on_them(call, name):
    surface = surfaces()[name]
    for u, v in ((0.2, 0.3), (0.5, 0.75), (0.9, 0.4)):
        u = surface.Domain(0).T0 + u * (surface.Domain(0).T1 - surface.Domain(0).T0)
        v = surface.Domain(1).T0 + v * (surface.Domain(1).T1 - surface.Domain(1).T0)
        p = surface.PointAt(u, v)
        found = call("surface/closestpoint-surface_point3d_double_double", sent(surface), point(p))
        assert surface.PointAt(found[1], found[2]).DistanceTo(p) < 1e-7


@pytest.mark.parametrize("name", solids())
def test_solids_have_their_volumes_and_come_back_valid(call, name):
    solid = solids()[name]
    assert call("brep/getvolume-brep", sent(solid)) == pytest.approx(VOLUMES[name], rel=1e-6)
    back = given(call("brep/mergebreps-breparray_double", [sent(solid)], 0.01))
    assert isinstance(back, r.Brep) and back.IsValid and back.IsSolid
    assert call("brep/getvolume-brep", sent(back)) == pytest.approx(VOLUMES[name], rel=1e-6)


def test_meshes_come_back_valid(call):
    back = given(call("mesh/rebuildnormals-mesh", sent(mesh())))
    assert back.IsValid and len(back.Vertices) == 5 and back.Faces.Count == 2


def test_subds_come_back_valid(call):
    subd = given(call("subd/createfrommesh-mesh", sent(mesh())))
    assert isinstance(subd, r.SubD) and subd.IsValid
    fine = given(call("mesh/createfromsubd-subd_int", sent(subd), 2))
    assert fine.IsValid and fine.Faces.Count > 16


def test_what_is_made_is_valid(call):
    circle = sent(r.Circle(P(0, 0, 0), 5.0).ToNurbsCurve())
    above = sent(r.Circle(P(0, 0, 4), 3.0).ToNurbsCurve())
    rail = sent(r.LineCurve(P(0, 0, 0), P(0, 0, 9)))
    made = [
        *call("brep/createfromloft-curvearray_point3d_point3d_lofttype_bool", [circle, above], None, None, 0, False),
        *call("brep/createplanarbreps-curvearray", [circle]),
        *call("brep/createpipe-curve_double_bool_pipecapmode_bool_double_double", rail, 1, False, 1, False, 0.01, 0.01),
        *call("brep/createfromsweep-curve_curve_bool_double", rail, circle, False, 0.01),
        call("brep/createpatch-geometrybasearray_int_int_double", [circle], 8, 8, 0.01),
        *call("mesh/createfrombrep-brep", sent(r.Sphere(P(0, 0, 0), 5.0).ToBrep())),
        call("mesh/createicosphere-sphere_int", {"Radius": 2, "Center": [0, 0, 0]}, 2),
        call("surface/createextrusion-curve_vector3d", circle, [0, 0, 1]),
        *call("curve/createbooleanunion-curvearray", [circle, sent(r.Circle(P(3, 0, 0), 5.0).ToNurbsCurve())]),
        call("curve/createinterpolatedcurve-point3darray_int", [[0, 0, 0], [1, 1, 0], [2, 0, 0]], 3),
    ]
    for one in made:
        assert given(one).IsValid, type(given(one))
