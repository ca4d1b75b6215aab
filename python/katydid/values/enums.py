"""The enumerations of Rhino.Geometry, as .NET's: members are numbers that know their name."""

import enum
import keyword

from .base import DotNetType


class NetEnum(enum.IntEnum):
    """An enumeration whose text is the member's name."""

    def __str__(self):
        return self._name_ or str(self._value_)

    def ToString(self, *format_and_culture):
        return str(self)

    def GetType(self):
        return DotNetType(type(self))

    def Equals(self, other):
        return self == other

    def HasFlag(self, flag):
        return self & flag == flag

    def CompareTo(self, other):
        return (self > other) - (self < other)

    def __or__(self, other):
        return _combined(type(self), int(self) | int(other))

    def __and__(self, other):
        return _combined(type(self), int(self) & int(other))

    def __hash__(self):
        return hash(self._value_)


def _combined(cls, value):
    try:
        return cls(value)
    except ValueError:
        return value


def make(name, **members):
    """An enumeration; a member that is a word of Python (None, True) is reached by getattr and in capitals."""
    made = NetEnum(name, [(key, value) for key, value in members.items()
                          if not keyword.iskeyword(key)] or [("_", 0)])
    made.__module__ = "Rhino.Geometry"
    for key, value in members.items():
        if keyword.iskeyword(key):
            member = int.__new__(made, value)
            member._name_, member._value_ = key, value
            made._value2member_map_.setdefault(value, member)
            for alias in (key, key.upper(), key + "_"):
                type.__setattr__(made, alias, member)
    return made


PointContainment = make("PointContainment", Unset=0, Inside=1, Outside=2, Coincident=3)
LoftType = make("LoftType", Normal=0, Loose=1, Tight=2, Straight=3, Developable=4, Uniform=5)
CurveKnotStyle = make("CurveKnotStyle", Uniform=0, Chord=1, ChordSquareRoot=2, UniformPeriodic=3, ChordPeriodic=4,
                      ChordSquareRootPeriodic=5)
CurveOffsetCornerStyle = make("CurveOffsetCornerStyle", **{"None": 0, "Sharp": 1, "Round": 2, "Smooth": 3, "Chamfer": 4})
CurveOffsetEndStyle = make("CurveOffsetEndStyle", **{"None": 0, "Flat": 1, "Round": 2})
CurveSimplifyOptions = make("CurveSimplifyOptions", **{
    "None": 0, "SplitAtFullyMultipleKnots": 1, "RebuildLines": 2, "RebuildArcs": 4, "RebuildRationals": 8,
    "AdjustG1": 16, "Merge": 32, "All": 63})
CurveExtensionStyle = make("CurveExtensionStyle", Line=0, Arc=1, Smooth=2)
CurveEnd = make("CurveEnd", **{"None": 0, "Start": 1, "End": 2, "Both": 3})
CurveOrientation = make("CurveOrientation", Undefined=0, Clockwise=-1, CounterClockwise=1)
BlendContinuity = make("BlendContinuity", Position=0, Tangency=1, Curvature=2)
Continuity = make("Continuity", **{"None": 0, "C0_continuous": 1, "C1_continuous": 2, "C2_continuous": 3,
                                   "G1_continuous": 4, "G2_continuous": 5, "Cinfinity_continuous": 11})
PipeCapMode = make("PipeCapMode", **{"None": 0, "Flat": 1, "Round": 2})
ExtrudeCornerType = make("ExtrudeCornerType", **{"None": 0, "Sharp": 1, "Round": 2, "Smooth": 3, "Chamfer": 4})
SolidOrientation = make("BrepSolidOrientation", **{"None": 0, "Outward": 1, "Inward": -1, "Unknown": 2})
BrepLoopType = make("BrepLoopType", Unknown=0, Outer=1, Inner=2, Slit=3)
BrepTrimType = make("BrepTrimType", Unknown=0, Boundary=1, Mated=2, Seam=3, Singular=4, CurveOnSurface=5,
                    PointOnSurface=6, Slit=7)
IsoStatus = make("IsoStatus", **{"None": 0, "X": 1, "Y": 2, "West": 3, "South": 4, "East": 5, "North": 6})
SubDVertexTag = make("SubDVertexTag", Unset=0, Smooth=1, Crease=2, Corner=3, Dart=4)
SubDEdgeTag = make("SubDEdgeTag", Unset=0, Smooth=1, Crease=2, SmoothX=4)
RegionContainment = make("RegionContainment", Disjoint=0, MutualIntersection=1, AInsideB=2, BInsideA=3)
PlaneFitResult = make("PlaneFitResult", Success=0, Inconclusive=1, Failure=-1)
TransformSimilarityType = make("TransformSimilarityType", OrientationReversing=-1, NotSimilarity=0,
                               OrientationPreserving=1)
ObjectType = make("ObjectType", **{
    "None": 0, "Point": 1, "PointSet": 2, "Curve": 4, "Surface": 8, "Brep": 16, "Mesh": 32, "Light": 256,
    "Annotation": 512, "InstanceDefinition": 2048, "InstanceReference": 4096, "TextDot": 8192, "Grip": 16384,
    "Detail": 32768, "Hatch": 65536, "MorphControl": 131072, "SubD": 262144, "BrepLoop": 524288,
    "Extrusion": 1073741824})
UnitSystem = make("UnitSystem", **{
    "None": 0, "Microns": 1, "Millimeters": 2, "Centimeters": 3, "Meters": 4, "Kilometers": 5, "Microinches": 6,
    "Mils": 7, "Inches": 8, "Feet": 9, "Miles": 10, "CustomUnits": 11, "Angstroms": 12, "Nanometers": 13,
    "Decimeters": 14, "Dekameters": 15, "Hectometers": 16, "Megameters": 17, "Gigameters": 18, "Yards": 19})

BY_NAME = {kind.__name__: kind for kind in list(globals().values())
           if isinstance(kind, type) and issubclass(kind, NetEnum) and kind is not NetEnum}


def member(type_name, value):
    """A member of an enumeration by the names that the host sends, or the number where the type is not known."""
    kind = BY_NAME.get(type_name.rpartition(".")[2])
    return value if kind is None else _combined(kind, value)
