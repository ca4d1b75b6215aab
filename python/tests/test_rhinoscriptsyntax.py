"""rhinoscriptsyntax by closed forms: the functions that need no geometry of the host."""

import math

import pytest
from katydid import document, rhino


@pytest.fixture(autouse=True)
def rs():
    rhino.install()
    import rhinoscriptsyntax
    import scriptcontext
    scriptcontext.doc = document.begin({"tolerance": 0.001})
    yield rhinoscriptsyntax
    rhino.uninstall()


def test_points_move_turn_and_copy(rs):
    p = rs.AddPoint(1, 0, 0)
    assert type(p).__name__ == "Guid" and rs.PointCoordinates(p).ToString() == "1,0,0"
    assert rs.MoveObject(p, (0, 2, 0)) == p and list(rs.PointCoordinates(p)) == [1, 2, 0]
    q = rs.CopyObject(p, [1, 1, 1])
    assert q != p and list(rs.coerce3dpoint(q)) == [2, 3, 1]
    r = rs.RotateObject(p, (0, 0, 0), 90, copy=True)
    assert [round(c, 12) for c in rs.PointCoordinates(r)] == [-2, 1, 0]
    assert rs.MoveObjects([p, q], (1, 0, 0)) == [p, q] and rs.Distance(p, q) == pytest.approx(math.sqrt(3))
    assert rs.Distance((0, 0, 0), (3, 4, 0)) == 5 and rs.Distance("0,0,0", [(0, 0, 2)]) == [2]
    assert rs.DeleteObject(p) and rs.PointCoordinates(p) is None and not rs.DeleteObject(p)
    assert rs.ScaleObject(q, (0, 0, 0), (2, 2, 2)) == q and list(rs.PointCoordinates(q)) == [6, 6, 2]


def test_vectors(rs):
    assert list(rs.VectorAdd((1, 2, 3), [1, 1, 1])) == [2, 3, 4] and list(rs.VectorSubtract((1, 2, 3), (1, 1, 1))) == [0, 1, 2]
    assert list(rs.VectorCrossProduct((1, 0, 0), (0, 1, 0))) == [0, 0, 1] and rs.VectorLength((3, 4, 0)) == 5
    assert list(rs.VectorUnitize((0, 5, 0))) == [0, 1, 0] and rs.VectorUnitize((0, 0, 0)) is None
    assert list(rs.VectorDivide((2, 4, 6), 2)) == [1, 2, 3] and list(rs.VectorScale((1, 2, 3), 2)) == [2, 4, 6]
    assert [round(c, 12) for c in rs.VectorRotate((1, 0, 0), 90, (0, 0, 1))] == [0, 1, 0]
    assert rs.VectorAngle((1, 0, 0), (0, 1, 0)) == pytest.approx(90) and rs.VectorDotProduct((1, 2, 3), (4, 5, 6)) == 32
    assert list(rs.VectorCreate((3, 3, 3), (1, 1, 1))) == [2, 2, 2] and list(rs.VectorReverse((1, 0, 0))) == [-1, 0, 0]


def test_planes(rs):
    plane = rs.WorldXYPlane()
    assert list(rs.EvaluatePlane(plane, [5, 7])) == [5, 7, 0]
    assert list(rs.MovePlane(plane, (1, 2, 3)).Origin) == [1, 2, 3] and list(plane.Origin) == [0, 0, 0]
    turned = rs.RotatePlane(plane, 90, (0, 0, 1))
    assert [round(c, 12) for c in turned.XAxis] == [0, 1, 0]
    assert rs.DistanceToPlane(plane, (1, 1, 4)) == 4 and rs.PlaneFromPoints((0, 0, 0), (1, 0, 0), (2, 0, 0)) is None
    assert list(rs.LinePlaneIntersection(((0, 0, 1), (1, 0, 0)), plane)) == [1, 0, 0]
    assert list(rs.PlaneClosestPoint(plane, (3, 4, 5))) == [3, 4, 0]


def test_lines(rs):
    a, b = rs.LineLineIntersection(((0, 0, 0), (1, 0, 0)), ((3, -1, 2), (3, 1, 2)))
    assert list(a) == [3, 0, 0] and list(b) == [3, 0, 2]
    assert rs.LineLineIntersection(((0, 0, 0), (1, 0, 0)), ((0, 1, 0), (1, 1, 0))) is None
    line = rs.AddLine((0, 0, 0), (0, 0, 4))
    assert rs.coerceline(line).Length == 4
    with pytest.raises(ValueError):
        rs.AddLine((1, 1, 1), (1, 1, 1))
    rs.MoveObject(line, (1, 0, 0))
    assert list(rs.coerceline(line).To) == [1, 0, 4]
    assert list(rs.LineClosestPoint(((0, 0, 0), (1, 0, 0)), (5, 2, 0))) == [5, 0, 0]


def test_coercion(rs):
    assert list(rs.coerce3dpoint("1, 2.5, -3e1")) == [1, 2.5, -30] and rs.coerce3dpoint("a") is None
    with pytest.raises(ValueError):
        rs.coerce3dpoint(None, True)
    assert rs.coercecurve(rs.AddPoint(0, 0, 0)) is None and rs.coercebrep(5) is None
    assert rs.coerceguid("57da07bd-ecab-415d-9d86-af36d7073abc") is not None and rs.coerceguid("x") is None
    assert rs.CreateColor(1, 2, 3).B == 3 and rs.CreateColor([0, 0, 0, 80]).A == 80
    assert rs.coercegeometry(rs.AddPoint(1, 2, 3)).Location.Y == 2


def test_transforms_and_sorting(rs):
    turn = rs.XformRotation2(90, (0, 0, 1), (0, 0, 0))
    assert [round(c, 12) for c in rs.PointTransform((1, 0, 0), turn)] == [0, 1, 0]
    assert rs.XformMultiply(turn, rs.XformInverse(turn)).IsIdentity and rs.XformDeterminant(rs.XformScale(2)) == 8
    assert [list(p) for p in rs.SortPoints([(2, 0, 0), (1, 5, 0)])] == [[1, 5, 0], [2, 0, 0]]
    assert rs.PointArrayClosestPoint([(0, 0, 0), (5, 5, 5)], (4, 4, 4)) == 1
    assert len(rs.CullDuplicatePoints([(0, 0, 0), (0, 0, 0.0001), (1, 0, 0)])) == 2
    assert [list(p) for p in rs.BoundingBox([rs.AddPoint(0, 0, 0), rs.AddPoint(1, 2, 3)])][6] == [1, 2, 3]
    assert list(rs.Polar((0, 0, 0), 90, 2))[1] == pytest.approx(2)


def test_what_is_not_there_is_named(rs):
    with pytest.raises(AttributeError, match="rhinoscriptsyntax.AddUnicorn is not supported by Katydid yet"):
        rs.AddUnicorn()
