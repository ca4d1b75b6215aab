"""Value types against closed forms and against the habits of C#."""

import copy
import math
import pickle

import pytest
from katydid.values import (Arc, BoundingBox, Box, Circle, Color, Complex, Cylinder, Ellipse, Guid, Interval, Line, Plane,
                            Point2d, Point3d, Point3f, Polyline, Quaternion, Rectangle3d, Sphere, Transform, Vector3d)
from katydid.values.base import UNSET, number_text
from katydid.values.enums import PlaneFitResult, PointContainment


def near(a, b, tolerance=1e-12):
    """Whether two values agree in all their numbers."""
    if isinstance(a, (int, float)):
        return abs(a - b) <= tolerance
    return type(a) is type(b) and a.EpsilonEquals(b, tolerance)


def test_points_and_vectors():
    p, q = Point3d(1, 2, 3), Point3d(4, 6, 3)
    assert p.DistanceTo(q) == 5.0 and p.DistanceToSquared(q) == 25.0
    assert type(q - p) is Vector3d and (q - p).Length == 5.0
    assert type(p + Vector3d(1, 0, 0)) is Point3d and type(p + q) is Point3d
    assert p * 2 == Point3d(2, 4, 6) == 2 * p and p / 2 == Point3d(0.5, 1, 1.5)
    assert Vector3d(1, 2, 3) * Vector3d(4, 5, 6) == 32.0
    assert Vector3d.CrossProduct(Vector3d.XAxis, Vector3d.YAxis) == Vector3d.ZAxis
    assert str(Point3d(1, 0.5, -2e-7)) == "1,0.5,-2E-07" and p.ToString() == "1,2,3"
    assert p[1] == 2 and list(p) == [1, 2, 3] and sum([p, q], Point3d.Origin) == Point3d(5, 8, 6)
    assert Point3d((1, 2, 3)) == Point3d(Vector3d(1, 2, 3)) == Point3d(Point3f(1, 2, 3)) == p
    assert not Point3d.Unset.IsValid and Point3d.Unset.X == UNSET
    assert hash(Point3d(1, 2, 3)) == hash(p) and p < q and p.GetType().Name == "Point3d"
    with pytest.raises(TypeError):
        Point3d("a", 1, 2)


def test_coordinates_are_floats_after_assigning():
    p = Point3d(1, 2, 3)
    p.X = 7
    assert isinstance(p.X, float) and p.X / 2 == 3.5
    with pytest.raises(AttributeError):
        p.Q = 1


def test_single_precision():
    assert Point3f(0.1, 0, 0).X == pytest.approx(0.1, abs=1e-8) and Point3f(0.1, 0, 0).X != 0.1


def test_vector_methods():
    v = Vector3d(3, 4, 0)
    assert v.Unitize() and v == Vector3d(0.6, 0.8, 0) and not Vector3d.Zero.Unitize()
    assert v.Rotate(math.pi / 2, Vector3d.ZAxis) and near(v, Vector3d(-0.8, 0.6, 0))
    assert Vector3d.VectorAngle(Vector3d.XAxis, Vector3d(1, 1, 0)) == pytest.approx(math.pi / 4)
    assert Vector3d.VectorAngle(Vector3d.XAxis, -Vector3d.YAxis, Plane.WorldXY) == pytest.approx(1.5 * math.pi)
    assert Vector3d.XAxis.IsParallelTo(Vector3d(-2, 0, 0)) == -1
    for x, y, z in ((0, 0, 1), (1, 0, 0), (0, 1, 0), (1, 2, 3), (3, 2, 1), (2, 3, 1), (1, 3, 2), (-1, 1, -1)):
        w = Vector3d()
        assert w.PerpendicularTo(Vector3d(x, y, z)) and w * Vector3d(x, y, z) == 0.0 and w.Length > 0
    assert repr(Vector3d.ZAxis) == "0,0,1"


def test_structs_copy_where_c_sharp_copies():
    plane = Plane.WorldXY
    plane.Origin.X = 5
    assert plane.Origin == Point3d.Origin
    plane.Origin = (5, 0, 0)
    plane.OriginY = 2
    assert plane.Origin == Point3d(5, 2, 0) and Plane.WorldXY.Origin == Point3d.Origin
    line = Line(Point3d(0, 0, 0), Point3d(1, 0, 0))
    p = line.From
    p.Z = 9
    assert line.From.Z == 0 and copy.copy(line) == line and copy.copy(line) is not line
    assert pickle.loads(pickle.dumps(plane)) == plane


def test_planes():
    plane = Plane(Point3d(1, 2, 3), Vector3d(0, 0, 5))
    assert plane.XAxis == Vector3d.XAxis and plane.YAxis == Vector3d.YAxis and plane.IsValid
    three = Plane(Point3d(0, 0, 0), Point3d(0, 2, 0), Point3d(0, 0, 3))
    assert three.ZAxis == Vector3d.XAxis
    assert plane.DistanceTo(Point3d(9, 9, 5)) == 2.0 and plane.ClosestPoint(Point3d(9, 8, 5)) == Point3d(9, 8, 3)
    assert plane.ClosestParameter(Point3d(4, 6, 9)) == (True, 3.0, 4.0)
    assert plane.RemapToPlaneSpace(Point3d(4, 6, 9)) == (True, Point3d(3, 4, 6))
    assert plane.GetPlaneEquation() == [0, 0, 1, -3]
    tilted = Plane(1.0, 1.0, 1.0, -3.0)
    assert tilted.ValueAt(Point3d(1, 1, 1)) == pytest.approx(0.0, abs=1e-15)
    plane.Rotate(math.pi / 2, plane.ZAxis)
    assert near(plane.XAxis, Vector3d.YAxis) and plane.Origin == Point3d(1, 2, 3)
    plane.Rotate(math.pi, Vector3d.ZAxis, Point3d.Origin)
    assert near(plane.Origin, Point3d(-1, -2, 3))
    plane.Flip()
    assert plane.ZAxis == -Vector3d.ZAxis and plane.IsValid
    assert str(Plane.WorldXY) == "Origin=0,0,0 XAxis=1,0,0, YAxis=0,1,0, ZAxis=0,0,1"


def test_a_fitted_plane():
    result, plane = Plane.FitPlaneToPoints([(0, 0, 0), (2, 0, 2), (0, 3, 0), (2, 3, 2)])
    assert result == PlaneFitResult.Success and abs(abs(plane.ZAxis * Vector3d(1, 0, -1)) - math.sqrt(2)) < 1e-12
    assert Plane.FitPlaneToPoints([(0, 0, 0), (1, 1, 1)])[0] == PlaneFitResult.Failure


def test_intervals():
    span = Interval(6, 2)
    assert (span.Length, span.Min, span.Max, span.Mid) == (-4, 2, 6, 4) and span.IsDecreasing
    assert span.ParameterAt(0.25) == 5 and span.NormalizedParameterAt(3) == 0.75
    assert span.IncludesParameter(6) and not span.IncludesParameter(6, True)
    span.Swap()
    span.Grow(10)
    assert span == Interval(2, 10) and str(span) == "2,10"
    assert Interval.FromIntersection(Interval(0, 5), Interval(9, 3)) == Interval(3, 5)
    assert Interval.FromUnion(Interval(0, 5), Interval(9, 3)) == Interval(0, 9)
    assert not Interval.FromIntersection(Interval(0, 1), Interval(2, 3)).IsValid


def test_lines():
    line = Line(Point3d(0, 0, 0), Vector3d(0, 0, 2), 6.0)
    assert line.Length == 6 and line.To == Point3d(0, 0, 6) and line.PointAt(0.5) == Point3d(0, 0, 3)
    assert line.ClosestPoint(Point3d(1, 0, 9), True) == Point3d(0, 0, 6)
    assert line.ClosestPoint(Point3d(1, 0, 9), False) == Point3d(0, 0, 9)
    assert line.DistanceTo(Point3d(3, 4, 9), False) == 5
    assert line.MinimumDistanceTo(Line(Point3d(2, -1, 3), Point3d(2, 1, 3))) == 2
    line.Extend(1, 2)
    assert line == Line(0, 0, -1, 0, 0, 8)
    line.Length = 1
    assert line.To == Point3d(0, 0, 0)


def test_bounding_boxes_and_boxes():
    box = BoundingBox([(1, 5, 0), (3, 2, 4)])
    assert box.Volume == 2 * 3 * 4 and box.Area == 2 * (6 + 12 + 8) and box.Center == Point3d(2, 3.5, 2)
    assert box.GetCorners()[6] == Point3d(3, 5, 4) and len(box.GetEdges()) == 12
    assert box.Contains(Point3d(1, 2, 0)) and not box.Contains(Point3d(1, 2, 0), True)
    assert not BoundingBox.Empty.IsValid and str(BoundingBox(0, 0, 0, 1, 1, 1)) == "0,0,0 - 1,1,1"
    box.Union(Point3d(0, 0, 0))
    assert box.Min == Point3d(0, 0, 0) and BoundingBox.Union(BoundingBox.Empty, box) == box
    turned = Box(Plane(Point3d(1, 1, 1), Vector3d.YAxis, -Vector3d.XAxis), Interval(0, 2), Interval(-1, 1), Interval(0, 3))
    assert turned.Volume == 12 and turned.Contains(Point3d(1.5, 2, 2)) and turned.Center == Point3d(1, 2, 2.5)
    assert turned.ClosestPoint(Point3d(1, 9, 2)) == Point3d(1, 3, 2)
    turned.Transform(Transform.Scale(Point3d.Origin, 2))
    assert turned.Volume == pytest.approx(96)


def test_circles_arcs_and_ellipses():
    circle = Circle(Point3d(1, 0, 0), Point3d(0, 1, 0), Point3d(-1, 0, 0))
    assert near(circle.Center, Point3d.Origin) and circle.Radius == pytest.approx(1)
    assert Circle(5).Circumference == pytest.approx(10 * math.pi) and Circle(5).Plane == Plane.WorldXY
    assert near(Circle(2).TangentAt(0), Vector3d.YAxis) and near(Circle(2).ClosestPoint(Point3d(0, 9, 5)), Point3d(0, 2, 0))
    assert near(Circle(Plane(Point3d(1, 2, 3), Vector3d(1, 1, 0)), 2).BoundingBox.Max,
                Point3d(1 + math.sqrt(2), 2 + math.sqrt(2), 5))
    arc = Arc(Point3d(1, 0, 0), Point3d(0, 1, 0), Point3d(-1, 0, 0))
    assert arc.Angle == pytest.approx(math.pi) and arc.Length == pytest.approx(math.pi)
    assert near(arc.MidPoint, Point3d(0, 1, 0)) and near(arc.StartPoint, Point3d(1, 0, 0))
    assert near(arc.ClosestPoint(Point3d(0.5, -3, 0)), Point3d(1, 0, 0)) and near(arc.BoundingBox().Max, Point3d(1, 1, 0))
    tangent = Arc(Point3d(0, 0, 0), Vector3d.XAxis, Point3d(1, 1, 0))
    assert tangent.Radius == pytest.approx(1) and tangent.Angle == pytest.approx(math.pi / 2)
    clockwise = Arc(Point3d(-1, 0, 0), Point3d(0, 1, 0), Point3d(1, 0, 0))
    assert near(clockwise.Plane.ZAxis, -Vector3d.ZAxis)
    arc.Reverse()
    assert near(arc.StartPoint, Point3d(-1, 0, 0)) and near(arc.EndPoint, Point3d(1, 0, 0))
    a, b = Ellipse(Plane.WorldXY, 5, 3).GetFoci()
    assert a == Point3d(4, 0, 0) and b == Point3d(-4, 0, 0)


def test_rectangles():
    r = Rectangle3d(Plane.WorldXY, Point3d(4, 1, 0), Point3d(0, 3, 0))
    assert (r.Width, r.Height, r.Area, r.Circumference) == (4, 2, 8, 12) and r.Center == Point3d(2, 2, 0)
    assert r.Corner(2) == Point3d(4, 3, 0) and r.PointAt(1.5) == Point3d(4, 2, 0) and r.PointAt(0.5, 0.5) == r.Center
    assert r.Contains(Point3d(1, 2, 0)) == PointContainment.Inside and r.Contains(9.0, 9.0) == PointContainment.Outside
    assert r.ToPolyline().IsClosed and r.ToPolyline().Length == 12
    assert Rectangle3d(Plane.WorldXY, 5, 3).Corner(2) == Point3d(5, 3, 0)


def test_polylines_are_lists():
    line = Polyline([(0, 0, 0), (3, 0, 0), (3, 4, 0)])
    assert line.Length == 7 and line.Count == 3 and line.SegmentCount == 2 and not line.IsClosed
    assert line.PointAt(1.5) == Point3d(3, 2, 0) and line.ClosestParameter(Point3d(9, 2, 0)) == 1.5
    line.Add(0, 0, 0)
    assert line.IsClosed and line.Length == 12 and line[0].GetType().Name == "Point3d"
    assert Polyline([(0, 0, 0), (1, 0.001, 0), (2, 0, 0)]).ReduceSegments(0.01) == 1
    assert Polyline.CreateInscribedPolygon(Circle(2), 6).Length == pytest.approx(12)
    line.Transform(Transform.Translation(0, 0, 1))
    assert line.BoundingBox.Min == Point3d(0, 0, 1)
    assert near(Polyline([(0, 0, 0), (4, 0, 0)]).CenterPoint(), Point3d(2, 0, 0))


def test_transforms():
    turn = Transform.Rotation(math.pi / 2, Vector3d.ZAxis, Point3d(1, 0, 0))
    assert near(turn * Point3d(2, 0, 0), Point3d(1, 1, 0)) and near(turn * Vector3d(1, 0, 0), Vector3d(0, 1, 0))
    both = Transform.Translation(0, 0, 5) * turn
    assert near(both * Point3d(2, 0, 0), Point3d(1, 1, 5))
    found, back = both.TryGetInverse()
    assert found and (back * both).IsIdentity
    assert Transform.Scale(Point3d(1, 1, 1), 3) * Point3d(2, 1, 1) == Point3d(4, 1, 1)
    assert Transform.Mirror(Plane.WorldYZ) * Point3d(2, 1, 1) == Point3d(-2, 1, 1)
    assert Transform.PlaneToPlane(Plane.WorldXY, Plane.WorldYZ) * Point3d(1, 2, 3) == Point3d(3, 1, 2)
    assert Transform.ChangeBasis(Plane.WorldYZ, Plane.WorldXY) * Point3d(1, 2, 3) == Point3d(3, 1, 2)
    assert near(Transform.ProjectAlong(Plane.WorldXY, Vector3d(1, 0, -1)) * Point3d(0, 0, 2), Point3d(2, 0, 0))
    assert Transform.PlanarProjection(Plane.WorldXY) * Point3d(1, 2, 3) == Point3d(1, 2, 0)
    assert Transform.Diagonal(2, 3, 4).Determinant == 24 and Transform.Scale(Point3d.Origin, -2).Determinant == -8
    assert turn.SimilarityType == 1 and Transform.Mirror(Plane.WorldXY).SimilarityType == -1
    assert Transform.Diagonal(1, 2, 1).SimilarityType == 0 and turn.M03 == turn[0, 3] == 1
    assert near(Transform.Rotation(Vector3d.XAxis, Vector3d.YAxis, Point3d.Origin) * Point3d(1, 0, 0), Point3d(0, 1, 0))
    assert near(Transform.Rotation(Vector3d.XAxis, -Vector3d.XAxis, Point3d.Origin) * Point3d(1, 0, 0), Point3d(-1, 0, 0))
    ok, yaw, pitch, roll = Transform.RotationZYX(0.3, 0.2, 0.1).GetYawPitchRoll()
    assert ok and (yaw, pitch, roll) == (pytest.approx(0.3), pytest.approx(0.2), pytest.approx(0.1))


def test_decompositions():
    move = Transform.Translation(1, 2, 3)
    turn = Transform.Rotation(0.5, Vector3d(1, 2, 2), Point3d.Origin)
    kind, motion, rotation = (move * turn).DecomposeRigid(1e-9)
    assert kind == 1 and motion == Vector3d(1, 2, 3) and near(rotation, turn)
    kind, motion, size, rotation = (move * turn * Transform.Scale(Point3d.Origin, 3)).DecomposeSimilarity(1e-9)
    assert kind == 1 and size == pytest.approx(3) and near(rotation, turn)
    for angles in ((0.3, 0.7, 1.1), (-2.0, 1.0, 3.0), (0.4, 0.0, 0.0), (0.4, math.pi, 0.0)):
        ok, *found = Transform.RotationZYZ(*angles).GetEulerZYZ()
        assert ok and near(Transform.RotationZYZ(*found), Transform.RotationZYZ(*angles), 1e-9)


def test_joined_lines():
    joined = Polyline.CreateByJoiningLines([Line(0, 0, 0, 1, 0, 0), Line(2, 1, 0, 1, 0, 0), Line(9, 9, 9, 8, 8, 8)], 0.1, False)
    assert [len(one) for one in joined] == [3, 2] and joined[0].Last == Point3d(2, 1, 0)
    joined[0].X[0] = 5
    assert joined[0][0] == Point3d(5, 0, 0)


def test_quaternions():
    assert Quaternion.I * Quaternion.J == Quaternion.K and Quaternion.J * Quaternion.I == Quaternion(0, 0, 0, -1)
    turn = Quaternion.Rotation(math.pi / 2, Vector3d.ZAxis)
    assert near(turn.Rotate(Vector3d.XAxis), Vector3d.YAxis)
    ok, angle, axis = turn.GetRotation()
    assert ok and angle == pytest.approx(math.pi / 2) and near(axis, Vector3d.ZAxis)
    half = Quaternion.Slerp(Quaternion.Identity, turn, 0.5)
    assert near(half.Rotate(Vector3d.XAxis), Vector3d(math.sqrt(0.5), math.sqrt(0.5), 0))
    assert near((turn * turn.Inverse), Quaternion.Identity)


def test_spheres_and_cylinders():
    sphere = Sphere(Point3d(1, 1, 1), 2)
    assert near(sphere.PointAt(0, math.pi / 2), Point3d(1, 1, 3)) and sphere.NorthPole == Point3d(1, 1, 3)
    assert sphere.ClosestPoint(Point3d(9, 1, 1)) == Point3d(3, 1, 1) and sphere.BoundingBox.Volume == 64
    assert sphere.LatitudeDegrees(60).Radius == pytest.approx(1)
    corners = [(3, 1, 1), (-1, 1, 1), (1, 3, 1), (1, 1, 3), (1, -1, 1)]
    fitted = Sphere.FitSphereToPoints(corners)
    assert fitted.Radius == pytest.approx(2) and near(fitted.Center, Point3d(1, 1, 1), 1e-9)
    cylinder = Cylinder(Circle(3), 5)
    assert cylinder.TotalHeight == 5 and near(cylinder.LineAt(0).To, Point3d(3, 0, 5))


def test_colours_guids_and_complex_numbers():
    assert Color.FromArgb(255, 0, 0) == Color.Red and Color.Red.ToArgb() == -65536 and Color.Red.GetHue() == 0
    assert str(Color.FromArgb(10, 1, 2, 3)) == "Color [A=10, R=1, G=2, B=3]" and Color.Lime.GetHue() == 120
    with pytest.raises(ValueError):
        Color.FromArgb(256, 0, 0)
    assert Guid.Empty == Guid("00000000-0000-0000-0000-000000000000") and Guid.NewGuid() != Guid.NewGuid()
    assert Guid.TryParse("x") == (False, Guid.Empty)
    assert Complex(1, 2) * Complex(3, -1) == Complex(5, 5) and abs(Complex(3, 4)) == 5


@pytest.mark.parametrize("number, text", [
    (0.0, "0"), (-0.0, "-0"), (1.0, "1"), (0.1, "0.1"), (1e-5, "1E-05"), (0.0001, "0.0001"), (1e15, "1E+15"),
    (123456789012345.0, "123456789012345"), (1.5e-7, "1.5E-07"), (-2.5, "-2.5"), (1 / 3, "0.3333333333333333"),
    (1e100, "1E+100"), (100000.0, "100000"), (12345.678, "12345.678"), (float("nan"), "NaN"), (float("inf"), "∞")])
def test_number_texts(number, text):
    # .NET Core 3.0 and later: the shortest text that reads back, an exponent from 1E+15 and below 1E-04.
    assert number_text(number) == text


def test_point2d():
    assert Point2d(3, 4).DistanceTo(Point2d.Origin) == 5 and str(Point2d(1, 2)) == "1,2"
