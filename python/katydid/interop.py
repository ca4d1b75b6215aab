"""Geometry to and from rhino3dm, COMPAS and trimesh, where they are installed."""

import json

from ._katydid import Curve, Interval, Mesh, NotSupportedError, Plane, Point, Transform, Vector, rebuild


def _unknown(thing, where):
    return NotSupportedError("not supported: a %s %s" % (type(thing).__name__, where))


def from_rhino3dm(thing):
    """The geometry of an object of rhino3dm: a Point3d, Vector3d, Plane, Line, Circle, Arc, Polyline, Interval, or any
    GeometryBase."""
    import rhino3dm as r
    point = lambda p: Point(p.X, p.Y, p.Z)  # noqa: E731
    vector = lambda v: Vector(v.X, v.Y, v.Z)  # noqa: E731
    if isinstance(thing, (r.Point3d, r.Point3f)):
        return point(thing)
    if isinstance(thing, (r.Vector3d, r.Vector3f)):
        return vector(thing)
    if isinstance(thing, r.Plane):
        return Plane(point(thing.Origin), vector(thing.XAxis), vector(thing.YAxis))
    if isinstance(thing, r.Line):
        return Curve.line(point(thing.From), point(thing.To))
    if isinstance(thing, r.Interval):
        return Interval(thing.T0, thing.T1)
    if isinstance(thing, r.Polyline):
        return Curve.polyline([point(thing[i]) for i in range(len(thing))])
    if isinstance(thing, r.Circle):
        return Curve.circle(from_rhino3dm(thing.Plane), thing.Radius)
    if isinstance(thing, r.Arc):
        return Curve.arc_through(*(point(p) for p in (thing.StartPoint, thing.MidPoint, thing.EndPoint)))
    if isinstance(thing, r.Point):
        return point(thing.Location)
    if isinstance(thing, r.CommonObject):
        # A Brep of one whole face comes back as what it was written as, not as a surface.
        return rebuild(json.dumps(thing.Encode()), "Brep" if isinstance(thing, (r.Brep, r.Extrusion)) else "")
    raise _unknown(thing, "of rhino3dm")


def to_rhino3dm(thing):
    """An object of rhino3dm for a point, vector, plane, range, transform, curve, surface, Brep, mesh or SubD."""
    import rhino3dm as r
    if isinstance(thing, Point):
        return r.Point3d(*thing)
    if isinstance(thing, Vector):
        return r.Vector3d(*thing)
    if isinstance(thing, Interval):
        return r.Interval(*thing)
    if isinstance(thing, Plane):
        o, x, y = thing.origin, thing.x_axis, thing.y_axis
        return r.Plane(r.Point3d(*o), r.Vector3d(*x), r.Vector3d(*y))
    if isinstance(thing, Transform):
        made = r.Transform(1.0)
        for i, row in enumerate(thing.rows):
            for j, number in enumerate(row):
                setattr(made, "M%d%d" % (i, j), number)
        return made
    if hasattr(thing, "to_json"):
        return r.CommonObject.Decode(json.loads(thing.to_json()))
    raise _unknown(thing, "in rhino3dm")


def from_compas(thing):
    """The geometry of a point, vector, frame, plane, line, polyline, circle, mesh or transformation of COMPAS."""
    import compas.datastructures
    import compas.geometry as g
    if isinstance(thing, compas.datastructures.Mesh):
        vertices, faces = thing.to_vertices_and_faces(triangulated=any(
            len(thing.face_vertices(face)) > 4 for face in thing.faces()))
        return Mesh(vertices, [list(face) for face in faces])
    if isinstance(thing, g.Point):
        return Point(*thing)
    if isinstance(thing, g.Vector):
        return Vector(*thing)
    if isinstance(thing, g.Frame):
        return Plane(tuple(thing.point), tuple(thing.xaxis), tuple(thing.yaxis))
    if isinstance(thing, g.Plane):
        return Plane(tuple(thing.point), normal=tuple(thing.normal))
    if isinstance(thing, g.Line):
        return Curve.line(tuple(thing.start), tuple(thing.end))
    if isinstance(thing, g.Polyline):
        return Curve.polyline([tuple(point) for point in thing.points])
    if isinstance(thing, g.Circle):
        return Curve.circle(from_compas(thing.frame), thing.radius)
    if isinstance(thing, g.Transformation):
        return Transform([list(row) for row in thing.matrix])
    raise _unknown(thing, "of COMPAS")


def to_compas(thing):
    """A point, vector, frame, polyline, line, mesh or transformation of COMPAS."""
    import compas.datastructures
    import compas.geometry as g
    if isinstance(thing, Point):
        return g.Point(*thing)
    if isinstance(thing, Vector):
        return g.Vector(*thing)
    if isinstance(thing, Plane):
        return g.Frame(tuple(thing.origin), tuple(thing.x_axis), tuple(thing.y_axis))
    if isinstance(thing, Transform):
        return g.Transformation(matrix=[list(row) for row in thing.rows])
    if isinstance(thing, Mesh):
        faces = [face[:3] if len(face) == 4 and face[2] == face[3] else face
                 for face in (list(map(int, face)) for face in thing.faces)]
        return compas.datastructures.Mesh.from_vertices_and_faces([[float(x) for x in v] for v in thing.vertices], faces)
    if isinstance(thing, Curve):
        corners = thing.corners()
        if corners is not None:
            corners = [tuple(map(float, corner)) for corner in corners]
            return g.Line(*corners) if len(corners) == 2 else g.Polyline(corners)
    raise _unknown(thing, "in COMPAS")


def from_trimesh(thing):
    """The mesh of a trimesh.Trimesh."""
    import numpy
    return Mesh(numpy.asarray(thing.vertices), numpy.asarray(thing.faces))


def to_trimesh(mesh):
    """A trimesh.Trimesh of a mesh, its quads cut into triangles."""
    import trimesh
    return trimesh.Trimesh(vertices=mesh.vertices, faces=mesh.triangles, process=False)
