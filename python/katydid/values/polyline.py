"""Polyline and Point3dList: lists of points."""

import math

from .base import ZERO_TOLERANCE, not_supported
from .box import BoundingBox
from .interval import to_interval
from .line import Line
from .netlist import NetList
from .plane import to_point
from .point import Point3d
from .vector import Vector3d


class _Coordinate:
    """One coordinate of all points: `points.X[3] = 1`."""

    def __init__(self, points, name):
        self._points, self._name = points, name

    def __len__(self):
        return len(self._points)

    def __getitem__(self, index):
        return getattr(self._points[index], self._name)

    def __setitem__(self, index, value):
        setattr(self._points[index], self._name, value)


class Point3dList(NetList):
    """A list that holds points; what is added is converted."""

    _net_name = "Point3dList"
    _namespace = "Rhino.Collections"

    def __init__(self, *points):
        if len(points) == 1 and isinstance(points[0], int):
            points = ((),)
        elif len(points) > 1:
            points = (points,)
        list.__init__(self, map(to_point, *points) if points else ())

    @staticmethod
    def _item(value):
        return to_point(value)

    def append(self, value):
        list.append(self, to_point(value))

    def __setitem__(self, index, value):
        list.__setitem__(self, index, list(map(to_point, value)) if isinstance(index, slice) else to_point(value))

    def Add(self, *item):
        self.append(Point3d(*item) if len(item) == 3 else item[0])

    BoundingBox = property(lambda self: BoundingBox(self) if self else BoundingBox.Empty)
    First = property(lambda self: self[0]._copy(), lambda self, value: self.__setitem__(0, value))
    Last = property(lambda self: self[-1]._copy(), lambda self, value: self.__setitem__(-1, value))

    def ClosestIndex(self, testPoint):
        point = to_point(testPoint)
        return min(range(len(self)), key=lambda i: self[i].DistanceToSquared(point)) if self else -1

    def Transform(self, xform):
        for point in self:
            point.Transform(xform)

    X = property(lambda self: _Coordinate(self, "X"))
    Y = property(lambda self: _Coordinate(self, "Y"))
    Z = property(lambda self: _Coordinate(self, "Z"))

    def SetAllX(self, value):
        for point in self:
            point.X = value

    def SetAllY(self, value):
        for point in self:
            point.Y = value

    def SetAllZ(self, value):
        for point in self:
            point.Z = value

    def Duplicate(self):
        return type(self)(self)

    def __copy__(self):
        return type(self)(self)

    def __deepcopy__(self, memo):
        return type(self)(self)

    def __reduce__(self):
        return (type(self), (list(self),))


class Polyline(Point3dList):
    """Straight segments from point to point; a parameter's whole part counts the segments."""

    _net_name = "Polyline"
    _namespace = "Rhino.Geometry"

    SegmentCount = property(lambda self: max(len(self) - 1, 0))
    IsClosed = property(lambda self: len(self) >= 3 and self[0].DistanceTo(self[-1]) <= ZERO_TOLERANCE)

    @property
    def IsValid(self):
        if len(self) < 2 or not all(point.IsValid for point in self):
            return False
        return all(a.DistanceTo(b) > ZERO_TOLERANCE for a, b in zip(self, self[1:]))

    @property
    def Length(self):
        return math.fsum(a.DistanceTo(b) for a, b in zip(self, self[1:]))

    def IsClosedWithinTolerance(self, tolerance):
        return len(self) >= 3 and self[0].DistanceTo(self[-1]) <= tolerance

    def GetSegments(self):
        return [Line(a, b) for a, b in zip(self, self[1:])]

    def SegmentAt(self, index):
        if not 0 <= index < self.SegmentCount:
            raise IndexError("a polyline of %d segments has no segment %d" % (self.SegmentCount, index))
        return Line(self[index], self[index + 1])

    def _at(self, t):
        """The segment of a parameter and the rest."""
        index = max(0, min(int(math.floor(t)), len(self) - 2))
        return index, t - index

    def PointAt(self, t):
        if len(self) < 2:
            return self[0]._copy() if self else Point3d.Origin
        index, rest = self._at(max(0.0, min(float(len(self) - 1), t)))
        return Line(self[index], self[index + 1]).PointAt(rest)

    def TangentAt(self, t):
        if len(self) < 2:
            return Vector3d.Zero
        index, _ = self._at(t)
        return self.SegmentAt(index).UnitTangent

    def ClosestParameter(self, testPoint):
        best, where = None, 0.0
        for i, segment in enumerate(self.GetSegments()):
            t = max(0.0, min(1.0, segment.ClosestParameter(testPoint)))
            gap = segment.PointAt(t).DistanceToSquared(testPoint)
            if best is None or gap < best:
                best, where = gap, i + t
        return where

    def ClosestPoint(self, testPoint):
        return self.PointAt(self.ClosestParameter(testPoint))

    def Trim(self, domain):
        """The part between two parameters."""
        span = to_interval(domain)
        low, high = max(0.0, span.Min), min(float(self.SegmentCount), span.Max)
        inner = [self[i] for i in range(int(math.floor(low)) + 1, int(math.ceil(high)))]
        return Polyline([self.PointAt(low)] + inner + [self.PointAt(high)])

    def CenterPoint(self):
        """The middle of the line, each segment counted by its length."""
        total = self.Length
        if total <= 0.0:
            return self[0]._copy() if self else Point3d.Unset
        middle = Vector3d.Zero
        for segment in self.GetSegments():
            middle = middle + Vector3d(segment.PointAt(0.5)) * (segment.Length / total)
        return Point3d(middle)

    def DeleteShortSegments(self, tolerance):
        """Drops points that follow the one before within the tolerance; the ends stay."""
        before = len(self)
        if before < 3:
            return 0
        kept = [self[0]]
        for point in self[1:-1]:
            if point.DistanceTo(kept[-1]) > tolerance:
                kept.append(point)
        while len(kept) > 1 and kept[-1].DistanceTo(self[-1]) <= tolerance:
            kept.pop()
        self[:] = kept + [self[-1]]
        return before - len(self)

    def ReduceSegments(self, tolerance):
        """Drops points within the tolerance of the line without them (Douglas and Peucker)."""
        keep, stack = {0, len(self) - 1}, [(0, len(self) - 1)]
        while stack:
            a, b = stack.pop()
            if b - a < 2:
                continue
            line = Line(self[a], self[b])
            far, index = max((line.DistanceTo(self[i], True), i) for i in range(a + 1, b))
            if far > tolerance:
                keep.add(index)
                stack += [(a, index), (index, b)]
        before = len(self)
        self[:] = [self[i] for i in sorted(keep)]
        return before - len(self)

    def MergeColinearSegments(self, angleTolerance, includeSeam):
        """Drops points where the direction turns by no more than the tolerance."""
        before, i = len(self), 1
        while 0 < i < len(self) - 1:
            a, b = self[i] - self[i - 1], self[i + 1] - self[i]
            if Vector3d.VectorAngle(a, b) <= angleTolerance:
                del self[i]
            else:
                i += 1
        if includeSeam and self.IsClosed and len(self) > 4:
            if Vector3d.VectorAngle(self[-1] - self[-2], self[1] - self[0]) <= angleTolerance:
                del self[-1]
                self[0] = self[-1]
        return before - len(self)

    def BreakAtAngles(self, angle):
        """The pieces between the points where the direction turns by more than an angle."""
        pieces, current = [], [self[0]] if self else []
        for i in range(1, len(self)):
            current.append(self[i])
            last = i == len(self) - 1
            if last or Vector3d.VectorAngle(self[i] - self[i - 1], self[i + 1] - self[i]) > angle:
                pieces.append(Polyline(current))
                current = [self[i]]
        return pieces

    def Smooth(self, amount):
        """Moves each inner point towards the middle of its neighbours."""
        if len(self) < 3:
            return False
        old = [point._copy() for point in self]
        closed, n = self.IsClosed, len(self) - 1
        for i in range(n + 1):
            if closed:
                a, b = old[(i - 1) % n], old[(i + 1) % n]
            elif 0 < i < n:
                a, b = old[i - 1], old[i + 1]
            else:
                continue
            self[i] = old[i] + ((a + b) * 0.5 - old[i]) * amount
        return True

    def RemapIndex(self, index):
        """The index of an item of a closed polyline, counted around."""
        n = len(self) - 1 if self.IsClosed else len(self)
        return index % n if n else 0

    def CollapseShortSegments(self, tolerance):
        """Drops points until no segment is shorter than the tolerance; the ends stay."""
        before = len(self)
        self.DeleteShortSegments(tolerance)
        return before - len(self)

    def RemoveNearlyEqualSubsequentPoints(self, tolerance):
        kept = self[:1]
        for point in self[1:]:
            if point.DistanceTo(kept[-1]) > tolerance:
                kept.append(point)
        self[:] = kept

    @staticmethod
    def CreateByJoiningLines(lines, tolerance, splitAtIntersections):
        """Polylines of lines that meet at their ends. Splitting where lines cross is not here."""
        if splitAtIntersections:
            raise not_supported("Rhino.Geometry.Polyline.CreateByJoiningLines with splitAtIntersections")
        left, made = [[line.From, line.To] for line in lines], []
        while left:
            chain = left.pop(0)
            grown = True
            while grown:
                grown = False
                for i, (a, b) in enumerate(left):
                    if chain[-1].DistanceTo(a) <= tolerance:
                        chain.append(b)
                    elif chain[-1].DistanceTo(b) <= tolerance:
                        chain.append(a)
                    elif chain[0].DistanceTo(b) <= tolerance:
                        chain.insert(0, a)
                    elif chain[0].DistanceTo(a) <= tolerance:
                        chain.insert(0, b)
                    else:
                        continue
                    del left[i]
                    grown = True
                    break
            made.append(Polyline(chain))
        return made

    def ToPolylineCurve(self):
        from ..geometry import construct
        return construct("PolylineCurve", self)

    def ToNurbsCurve(self):
        from ..geometry import call
        return call(self.ToPolylineCurve(), "ToNurbsCurve")

    def ToArray(self):
        return [point._copy() for point in self]

    @staticmethod
    def _regular(circle, count, radius):
        turn = 2.0 * math.pi / count
        return Polyline([circle.Plane.PointAt(radius * math.cos(i % count * turn), radius * math.sin(i % count * turn))
                         for i in range(count + 1)])

    @staticmethod
    def CreateInscribedPolygon(circle, sideCount):
        return Polyline._regular(circle, sideCount, circle.Radius) if sideCount > 2 else None

    @staticmethod
    def CreateCircumscribedPolygon(circle, sideCount):
        return Polyline._regular(circle, sideCount, circle.Radius / math.cos(math.pi / sideCount)) \
            if sideCount > 2 else None

    @staticmethod
    def CreateStarPolygon(circle, radius, cornerCount):
        if cornerCount < 3:
            return None
        turn, plane = math.pi / cornerCount, circle.Plane
        radii = (circle.Radius, radius)
        return Polyline([plane.PointAt(radii[i % 2] * math.cos(i % (2 * cornerCount) * turn),
                                       radii[i % 2] * math.sin(i % (2 * cornerCount) * turn))
                         for i in range(2 * cornerCount + 1)])


def to_polyline(value):
    """A Polyline of a polyline or of points."""
    return value if isinstance(value, Polyline) else Polyline(value)
