"""Every member of the host's table is called with plausible values, and gives what its signature says, or an error that is
one of geometry: never one of its arguments.

Values are checked where a formula exists, in `test_geometry.py` and in `crates/members/tests`; here it is kinds.
"""

import math
import re

import pytest
from hosts import Members, codec, program
from katydid.backend import Table
from katydid.geometry.call import given
from katydid.values import enums
from katydid.values import (Arc, BoundingBox, Box, Circle, Color, Cone, Cylinder, Ellipse, Interval, Line, Plane, Point2d,
                            Point3d, Rectangle3d, Sphere, Torus, Transform, Vector3d)
from measure_signatures import kind, split

pytestmark = pytest.mark.skipif(program() is None, reason="KATYDID names no program: nothing was called")

#: Parameters that a value of their kind alone would not fit, by their name.
BY_NAME = {"degree": 2, "order": 4, "pointCount": 5, "count": 4, "segmentCount": 4, "uCount": 4, "vCount": 4, "index": 0, "faceIndex": 0,
           "uDegree": 2, "vDegree": 2, "numberDerivatives": 1, "derivativeCount": 1, "direction": 0, "side": 0, "level": 1,
           "tolerance": 0.01, "overlapTolerance": 0.01, "angleTolerance": 0.01, "angleToleranceRadians": 0.01, "t": 0.5, "u": 0.5,
           "v": 0.5, "t0": 0.1, "t1": 0.9, "around": 8, "vertical": 4, "xCount": 4, "yCount": 4, "zCount": 4, "numSamples": 5,
           "cvCount": 6, "pointsPerTurn": 10, "desiredPolygonCount": 6, "uPointCount": 4, "vPointCount": 4,
           "endAngleRadians": 1.5, "numPoints": 5, "dimension": 3, "order0": 3, "order1": 3, "controlPointCount0": 4,
           "controlPointCount1": 4}
#: Indices of control points, which elsewhere are parameters of surfaces by the same names.
INDICES = {"u", "v"}
#: Points and vectors that have to differ from the others of a call.
PLACES = {"contourEnd": Point3d(0, 0, 2), "corner1": Point3d(0, 0, 0), "corner2": Point3d(2, 0, 0), "corner3": Point3d(2, 2, 0),
          "corner4": Point3d(0, 2, 0), "radiusPoint": Point3d(3, 0, 0), "vectorB": Vector3d(1, 0, 0), "end": Point2d(1.5, 1)}
#: Values by member and parameter where those of its kind would not do: a closed curve has no ends to extend, and the like.
#: Texts name a sample.
FITTING = {
    "Brep.CreateEdgeSurface": {"curves": "sides"},
    "Brep.CreateFromLoft": {"curves": "rings", "start": Point3d.Unset, "end": Point3d.Unset, "closed": False, "StartTangent": False,
                            "EndTangent": False},
    "Brep.CreateFromLoftRebuild": {"curves": "rings", "start": Point3d.Unset, "end": Point3d.Unset, "closed": False,
                                   "rebuildPointCount": 10},
    "Brep.CreateFromLoftRefit": {"curves": "rings", "start": Point3d.Unset, "end": Point3d.Unset, "closed": False},
    "Brep.CreateFromOffsetFace": {"bothSides": False, "createSolid": False},
    "Brep.CreateFromSweep": {"rail": "upright", "rail1": "post", "rail2": "other post", "shape": "beam", "shapes": "steps",
                             "closed": False, "startPoint": Point3d.Unset, "endPoint": Point3d.Unset, "start": Point3d.Unset,
                             "end": Point3d.Unset, "roadlikeNormal": Vector3d(0, 1, 0), "blendType": 0, "rebuildType": 0, "rebuild": 0},
    "Brep.CreateFromSweepSegmented": {"rail": "upright", "shape": "beam", "shapes": "steps", "closed": False,
                                      "startPoint": Point3d.Unset, "endPoint": Point3d.Unset, "roadlikeNormal": Vector3d(0, 1, 0),
                                      "blendType": 0, "rebuildType": 0},
    "Brep.CreateOffsetBrep": {"solid": False, "extend": False},
    "Brep.CreatePatch": {"tangency": False, "trim": False},
    "Brep.CreateThickPipe": {"rail": "upright", "radius0": 0.2, "radius1": 0.4, "absoluteTolerance": 0.01,
                             "railRadiiParameters": [0.0], "radii0": [0.2], "radii1": [0.4]},
    "Curve.CreateFillet": {"curve0": "beam", "curve1": "other beam", "t0Base": 1.0, "t1Base": 1.0},
    "Curve.CreateFilletCurves": {"curve0": "beam", "curve1": "other beam", "point0": Point3d(1, 0, 0), "point1": Point3d(0, 1, 0)},
    "Curve.CreatePeriodicCurve": {"curve": "wave"},
    "Curve.Extend": {"this": "beam", "t0": -1.0, "t1": 3.0, "domain": Interval(-1, 3), "geometry": "fences", "style": 0},
    "Curve.ExtendByArc": {"this": "bow", "geometry": "fences"},
    "Curve.ExtendByLine": {"this": "beam", "geometry": "fences"},
    "Curve.Offset": {"loose": False, "endStyle": 0},
    "Curve.Simplify": {"options": 63},
    "Intersection.RayShoot": {"geometry": "surfaces"},
    "Mesh.CreateFromCone": {"quadCaps": False},
    "Mesh.CreateFromCylinder": {"quadCaps": False},
    "Mesh.CreateFromFilteredFaceList": {"inclusion": [True, False] * 12},
    "Mesh.Split": {"splitAtCoplanar": False, "createNgons": False},
    "MeshVertexColorList.get_Item": {"this": "coloured"},
    "MeshVertexList.SetVertex": {"indices": list(range(16))},
    "NurbsCurve.MakeCompatible": {"simplifyMethod": 0, "numPoints": 0},
    "NurbsSurface.CreateNetworkSurface": {"curves": "sides", "uCurves": "beams", "vCurves": "crossbeams"},
    "NurbsSurface.CreateRailRevolvedSurface": {"profile": "spoke", "axis": Line(0, 0, 0, 0, 0, 1)},
    "NurbsSurface.CreateThroughPoints": {"uClosed": False, "vClosed": False},
    "PolyCurve.SegmentDomain": {"segmentIndex": 0},
    "SubD.InterpolateSurfacePoints": {"surfacePoints": "corners of the SubD"},
    "SubD.Offset": {"solidify": False},
    "Surface.CreatePeriodicSurface": {"surface": "tube", "direction": 0},
    "Surface.Extend": {"edge": 5},
    "Surface.Pushup": {"curve2d": "beam within"},
    "VolumeMassProperties.Compute": {"geometry": "solids", "surface": "ball"},
}
#: Names of a second curve.
SECOND = {"curve1", "curveB", "crv1", "rail1", "rail2", "curve2"}
#: Enumerations that stand in signatures alone.
ENUMERATIONS = {"BlendType", "RailType", "SweepFrame", "SweepMiter", "SmoothingCoordinateSystem", "NurbsCurveEndConditionType"}


@pytest.fixture(scope="module")
def host():
    made = Members(program())
    yield made
    made.close()


def samples(host):
    """A value of each kind."""
    pts = [Point3d(0, 0, 0), Point3d(2, 0, 0), Point3d(2, 2, 0), Point3d(0, 2, 0)]
    surface = host.call("PlaneSurface.new", Plane.WorldXY, Interval(0, 2), Interval(0, 2))
    brep = host.call("Brep.CreateFromBox", Box(BoundingBox(0, 0, 0, 2, 2, 2)))
    beside = host.call("Brep.CreateFromBox", Box(BoundingBox(1, 1, 1, 3, 3, 3)))
    mesh = host.call("Mesh.CreateFromBox", Box(BoundingBox(0, 0, 0, 2, 2, 2)), 2, 2, 2)
    line = host.call("LineCurve.new", Line(1, 0, 0, 1, 0, 3))
    poly = host.call("PolyCurve.new")
    host.call("PolyCurve.Append", poly, line)
    events = host.call("Intersection.CurveCurve", host.call("LineCurve.new", Line(-3, 0, 0, 3, 0, 0)),
                       host.call("ArcCurve.new", Circle(2)), 0.01, 0.01)
    circle = host.call("ArcCurve.new", Circle(2))
    faces, edges = host.call("Brep.get_Faces", brep), host.call("Brep.get_Edges", brep)
    polyline = host.call("PolylineCurve.new", pts + pts[:1])
    subd = host.call("SubD.CreateFromMesh", mesh)
    parts = [host.call("SubD.get_" + name, subd)[0] for name in ("Vertices", "Edges", "Faces")]
    coloured = host.call("Mesh.CreateFromBox", Box(BoundingBox(0, 0, 0, 2, 2, 2)), 1, 1, 1)
    host.call("MeshVertexColorList.SetColors", coloured, [Color.FromArgb(1, 2, 3)] * 24)

    def straight(*ends):
        return host.call("LineCurve.new", Line(*ends))

    wave = host.call("Curve.CreateControlPointCurve", [Point3d(math.cos(i), math.sin(i), 0) for i in (0, 1, 2, 3, 4, 5, 0)], 3)
    beam, crossbeam = straight(0, 0, 0, 2, 0, 0), straight(0, 0, 0, 0, 2, 0)
    return {
        "number": 0.5, "whole": 1, "truth": True, "text": "a", "Enum": 0, "any": 1, "Point3d": Point3d(1, 0.5, 0),
        "Point2d": Point2d(0.5, 0.5), "Vector3d": Vector3d(0, 0, 1), "Plane": Plane.WorldXY, "Interval": Interval(0.1, 0.9),
        "Line": Line(0, 0, 0, 2, 0, 0), "Circle": Circle(2), "Arc": Arc(Plane.WorldXY, 2, 1.5), "Sphere": Sphere(pts[0], 1),
        "Ellipse": Ellipse(Plane.WorldXY, 3, 2), "Box": Box(BoundingBox(0, 0, 0, 1, 1, 1)), "Transform":
        Transform.Translation(1, 2, 3), "BoundingBox": BoundingBox(0, 0, 0, 1, 1, 1), "Rectangle3d": Rectangle3d(Plane.WorldXY, 3, 2),
        "Cylinder": Cylinder(Circle(1), 2), "Cone": Cone(Plane.WorldXY, 2, 1), "Torus": Torus(Plane.WorldXY, 3, 1),
        "Color": Color.FromArgb(1, 2, 3), "MeshFace": codec.MeshFace(0, 1, 2, 3), "Curve": circle, "Surface": surface,
        "Brep": brep, "Mesh": mesh, "GeometryBase": circle, "BrepFace": faces[0], "BrepEdge": edges[0], "BrepPart": faces[0],
        "NurbsCurve": host.call("Curve.ToNurbsCurve", circle), "NurbsSurface": host.call("Surface.ToNurbsSurface", surface),
        "LineCurve": host.call("LineCurve.new", Line(0, 0, 0, 2, 0, 0)), "ArcCurve": circle, "PolylineCurve": polyline,
        "PlaneSurface": surface, "Polyline": polyline, "SubD": subd,
        "Point": host.call("Point.new", pts[1]), "MeshingParameters": {"GridMinCount": 4}, "Corners": codec.MeshFace(0, 1, 2, 3),
        "PolyCurve": poly, "IntersectionEvent": events[0], "MeshPoint": host.call("Mesh.ClosestMeshPoint", mesh, pts[1], 10.0),
        "AreaMassProperties": host.call("AreaMassProperties.Compute", surface),
        "VolumeMassProperties": host.call("VolumeMassProperties.Compute", brep),
        "RevSurface": host.call("RevSurface.Create", line, Line(0, 0, 0, 0, 0, 1), 0.0, 1.5),
        "Ray3d": {"Position": Point3d(0.5, 0.6, -5), "Direction": Vector3d(0, 0, 1)},
        "ReduceMeshParameters": {"DesiredPolygonCount": 6}, "SubDCreationOptions": {},
        "PointCloud": host.call("PointCloud.new", pts), "Hatch": host.call("Hatch.Create", polyline, 1, 0.5, 2.0, 0.01)[0],
        "SubDVertex": parts[0], "SubDEdge": parts[1], "SubDFace": parts[2], "TextDot": host.call("TextDot.new", "a", pts[1]),
        "beside": beside, "second": host.call("ArcCurve.new", Circle(Plane(Point3d(0, 0, 2), Vector3d(0, 0, 1)), 1)),
        "sides": [beam, straight(2, 0, 0, 2, 2, 0), straight(2, 2, 0, 0, 2, 0), straight(0, 2, 0, 0, 0, 0)],
        "rings": [circle, host.call("ArcCurve.new", Circle(Plane(Point3d(0, 0, 2), Vector3d(0, 0, 1)), 1))],
        "upright": straight(0, 0, 0, 0, 0, 3), "post": straight(2, 0, 0, 2, 0, 3), "other post": straight(0, 0, 0, 0, 0, 3),
        "beam": beam, "beams": [beam, straight(0, 2, 0, 2, 2, 0)], "other beam": crossbeam,
        "crossbeams": [crossbeam, straight(2, 0, 0, 2, 2, 0)], "beam within": straight(0.2, 0.2, 0, 1.5, 1, 0),
        "steps": [beam, straight(0, 0, 3, 2, 0, 3)], "spoke": straight(0, 0, 2, 2, 0, 0), "wave": wave,
        "fences": [straight(-1, -9, 0, -1, 9, 0)], "bow": host.call("ArcCurve.new", Arc(Plane.WorldXY, 2, 1.5)),
        "surfaces": [surface], "solids": [brep], "coloured": coloured,
        "corners of the SubD": [Point3d(i % 3, i // 3 % 3, i // 9) for i in range(26)],
        "tube": host.call("Surface.CreateExtrusion", wave, Vector3d(0, 0, 2)),
        "ball": host.call("RevSurface.CreateFromSphere", Sphere(pts[0], 1)),
        "grid": [Point3d(i, j, (i - j) % 2 / 4) for i in range(4) for j in range(4)],
        "corners": [Point3d(x, y, z) for z in (0, 2) for x, y in ((0, 0), (2, 0), (2, 2), (0, 2))],
    }


def value_of(made, text, name):
    """A value for a parameter; `None` where there is no sample."""
    text = text.strip()
    if text == "Point3d[]":
        return made["corners" if name == "corners" else "grid"]
    if text.endswith("[]"):
        one = value_of(made, text[:-2], name)
        # A colour for each point of the grid.
        return None if one is None else [one] * (len(made["grid"]) if name == "colors" else 1)
    head = text.rpartition(".")[2]
    if kind(text) == "whole" and name in INDICES:
        return 1
    if kind(text) in ("number", "whole") and name in BY_NAME:
        return BY_NAME[name]
    if head in ENUMERATIONS or head in enums.BY_NAME:
        return 1
    if name in PLACES and type(PLACES[name]).__name__ == head:
        return PLACES[name]
    if head == "Brep" and name in ("secondBrep", "secondSet"):
        return made["beside"]
    if head == "Curve" and name in SECOND:
        return made["second"]
    if kind(text) == "text" or head == "Char":
        return "a"
    return made.get(head, made.get(kind(text)))


def overloads(signature):
    """The class, whether it has an object, its parameters and what it gives."""
    found = re.match(r"([\w`]+)\.(\w+)\((.*)\)\s*->", signature)
    words = [word.strip() for word in split(found.group(3)) if word.strip()]
    parameters = []
    for word in words:
        head, _, name = word.rpartition(" ")
        parameters.append((head, name) if head != "this" else (name, "this"))
    return found.group(1), found.group(2), parameters, [part for part in given(signature) if part != "Void"]


def test_every_member_takes_what_its_signature_says(host):
    table = Table(host(["members"])[1], host(["changing"])[1])
    made = samples(host)
    called, failed, skipped, wrong = 0, 0, [], []
    for cls, names in sorted(table.classes.items()):
        for signature in sorted(text for texts in names.values() for text in texts):
            _, member, parameters, back = overloads(signature)
            values = []
            for text, name in parameters:
                is_own = name == "this" or (member, name) == ("new", "other")
                own = value_of(made, cls if is_own and cls in made else text, name)
                fitting = FITTING.get(cls + "." + member, {}).get(name)
                if fitting is not None:
                    own = made[fitting] if isinstance(fitting, str) else fitting
                # What a member changes is a copy: the others find the sample as it was.
                if name == "this" and table.changes([cls], member) and hasattr(own, "number"):
                    own = host.call("GeometryBase.Duplicate" if table.has("GeometryBase", "Duplicate") else "Curve.Duplicate",
                                    own)
                values.append(own)
            if any(value is None for value in values):
                skipped.append(signature)
                continue
            answer = host(["call", cls + "." + member] + values)
            called += 1
            if isinstance(answer, codec.Error):
                failed += 1
                # A fault of geometry is an answer; one of the arguments' kinds is not.
                if re.search(r" is (a|an) [^,]*, not |is missing|takes at most", answer.message):
                    wrong.append("%s: %s" % (signature, answer.message))
                continue
            # Overloads that differ in what they give back alone: the first one answers.
            counts = {len(overloads(other)[3]) for other in names[member]}
            if counts.isdisjoint((0, 1)) and (not isinstance(answer[1], list) or len(answer[1]) not in counts):
                wrong.append("%s gave %r" % (signature, answer[1]))
            if len(counts) > 1:
                continue
            if back == ["Double"] and not isinstance(answer[1], (int, float)) or back == ["Boolean"] and \
                    answer[1] not in (True, False) or back == ["Point3d"] and type(answer[1]).__name__ != "Point3d":
                wrong.append("%s gave %r" % (signature, answer[1]))
    print("%d called, %d gave an error of geometry, %d without a sample" % (called, failed, len(skipped)))
    assert not wrong, "%d of %d:\n%s" % (len(wrong), called, "\n".join(wrong))
    # A patch that begins from a surface is not supported.
    assert called >= 886 and failed <= 1 and len(skipped) <= 2, (called, failed, skipped)
