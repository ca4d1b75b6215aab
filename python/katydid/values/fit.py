"""Planes, lines, circles and spheres of least squares."""

import math

from .base import UNSET
from .circle import Circle
from .enums import PlaneFitResult
from .line import Line
from .plane import Plane
from .point import Point3d
from .vector import Vector3d


def _middle(points):
    n = float(len(points))
    return Point3d(*[math.fsum(parts) / n for parts in zip(*[p._parts() for p in points])])


def symmetric_axes(matrix):
    """Eigenvalues and unit eigenvectors of a symmetric 3 by 3 matrix, largest first: Jacobi's rotations."""
    a = [list(row) for row in matrix]
    v = [[float(i == j) for j in range(3)] for i in range(3)]
    for _ in range(60):
        off, p, q = max((abs(a[i][j]), i, j) for i, j in ((0, 1), (0, 2), (1, 2)))
        if off <= 1e-300 or off <= 1e-17 * max(abs(a[i][i]) for i in range(3)):
            break
        theta = (a[q][q] - a[p][p]) / (2.0 * a[p][q])
        t = math.copysign(1.0, theta) / (abs(theta) + math.hypot(theta, 1.0))
        c = 1.0 / math.hypot(t, 1.0)
        s = t * c
        for k in range(3):
            a[k][p], a[k][q] = c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]
        for k in range(3):
            a[p][k], a[q][k] = c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]
            v[k][p], v[k][q] = c * v[k][p] - s * v[k][q], s * v[k][p] + c * v[k][q]
    found = [(a[i][i], Vector3d(v[0][i], v[1][i], v[2][i])) for i in range(3)]
    return sorted(found, key=lambda pair: -pair[0])


def _spread(points, middle):
    spans = [(p - middle)._parts() for p in points]
    return [[math.fsum(s[i] * s[j] for s in spans) for j in range(3)] for i in range(3)]


def plane_of_points(points, with_deviation=False):
    """(PlaneFitResult, plane): the normal is the direction of least spread."""
    if len(points) < 3:
        return (PlaneFitResult.Failure, Plane.Unset) + ((UNSET,) if with_deviation else ())
    middle = _middle(points)
    axes = symmetric_axes(_spread(points, middle))
    if axes[1][0] <= 1e-14 * max(axes[0][0], 1e-300):
        result, plane = PlaneFitResult.Inconclusive, Plane(middle, axes[2][1])
    else:
        result, plane = PlaneFitResult.Success, Plane(middle, axes[0][1], axes[1][1])
    if not with_deviation:
        return result, plane
    return result, plane, max(abs(plane.ValueAt(point)) for point in points)


def line_of_points(points):
    """(True, line): along the direction of largest spread, from the first projection to the last."""
    if len(points) < 2:
        return False, Line.Unset
    middle = _middle(points)
    along = symmetric_axes(_spread(points, middle))[0][1]
    if along * (points[-1] - points[0]) < 0.0:
        along = -along
    reach = [(point - middle) * along for point in points]
    if max(reach) <= min(reach):
        return False, Line.Unset
    return True, Line(middle + along * min(reach), middle + along * max(reach))


def solve(rows):
    """The solution of a small square system by elimination with pivots; None where there is no single one."""
    rows = [list(row) for row in rows]
    n = len(rows)
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(rows[r][i]))
        if abs(rows[pivot][i]) <= 1e-14 * max(map(abs, rows[pivot])):
            return None
        rows[i], rows[pivot] = rows[pivot], rows[i]
        for r in range(i + 1, n):
            factor = rows[r][i] / rows[i][i]
            rows[r] = [a - factor * b for a, b in zip(rows[r], rows[i])]
    answer = [0.0] * n
    for i in reversed(range(n)):
        answer[i] = (rows[i][n] - sum(rows[i][j] * answer[j] for j in range(i + 1, n))) / rows[i][i]
    return answer


def _algebraic(spans):
    """Centre and radius from |p|^2 = 2 c.p + k, a linear system (Kasa's fit)."""
    n = len(spans[0])
    columns = [list(span) + [1.0, sum(c * c for c in span)] for span in spans]
    rows = [[math.fsum(col[i] * col[j] for col in columns) for j in range(n + 2)] for i in range(n + 1)]
    answer = solve(rows)
    if answer is None:
        return None
    centre = [0.5 * part for part in answer[:n]]
    square = answer[n] + sum(c * c for c in centre)
    return (centre, math.sqrt(square)) if square > 0.0 else None


def circle_of_points(points):
    """(True, circle) in the points' plane of least squares."""
    if len(points) < 3:
        return False, Circle.Unset
    result, plane = plane_of_points(points)
    if result != PlaneFitResult.Success:
        return False, Circle.Unset
    found = _algebraic([plane._local(point)[:2] for point in points])
    if found is None:
        return False, Circle.Unset
    plane.Origin = plane.PointAt(*found[0])
    return True, Circle(plane, found[1])


def sphere_of_points(points):
    """The sphere of least squares; unset where there is none."""
    from .solid import Sphere
    if len(points) < 4:
        return Sphere.Unset
    middle = _middle(points)
    found = _algebraic([(point - middle)._parts() for point in points])
    return Sphere(middle + Vector3d(*found[0]), found[1]) if found else Sphere.Unset
