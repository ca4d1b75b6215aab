"""Surfaces, Breps and meshes that are added to the document, or made of what is in it."""

import scriptcontext
from katydid.geometry import construct, static_call
from katydid.values import Circle, Cone, Cylinder, Plane, Sphere, Torus
from katydid.values.enums import LoftType, PipeCapMode

from .coerce import (_plane_or_point, coerce3dpoint, coerce3dpointlist, coerce3dvector, coercebrep, coercecurve,
                     coercegeometry, coerceguid, coerceline, coercemesh, coerceplane, coercesurface)
from .support import added, all_added, is_many, radians, tolerance


def _curves(ids):
    return [coercecurve(one, -1, True) for one in (ids if is_many(ids) else [ids])]


def _delete(ids):
    for one in ids if is_many(ids) else [ids]:
        guid = coerceguid(one)
        if guid is not None:
            scriptcontext.doc.Objects.Delete(guid)


def AddSphere(center_or_plane, radius):
    if not float(radius) > 0.0:
        raise ValueError("a sphere's radius is above 0, not %s" % radius)
    return added(Sphere(_plane_or_point(center_or_plane), float(radius)).ToBrep())


def AddBox(corners):
    """Eight corners: four below in order, then four above."""
    points = coerce3dpointlist(corners, True)
    if len(points) != 8:
        raise ValueError("a box has 8 corners, not %d" % len(points))
    return added(static_call("Brep", "CreateFromBox", points))


def AddCylinder(base, height, radius, cap=True):
    """On a plane with a height, or from a point to a point."""
    plane, length = _base_and_height(base, height)
    return added(Cylinder(Circle(plane, float(radius)), length).ToBrep(bool(cap), bool(cap)))


def _base_and_height(base, height):
    if isinstance(height, (int, float)):
        return _plane_or_point(base), float(height)
    start, end = coerce3dpoint(base, True), coerce3dpoint(height, True)
    return Plane(start, end - start), start.DistanceTo(end)


def AddCone(base, height, radius, cap=True):
    """The apex lies at the height over the base."""
    plane, length = _base_and_height(base, height)
    apex = Plane(plane.PointAt(0.0, 0.0, length), plane.XAxis, -plane.YAxis)
    return added(Cone(apex, length, float(radius)).ToBrep(bool(cap)))


def AddTorus(base, major_radius, minor_radius, direction=None):
    plane = _plane_or_point(base)
    if direction is not None:
        plane = Plane(plane.Origin, coerce3dpoint(direction, True) - plane.Origin)
    return added(Torus(plane, float(major_radius), float(minor_radius)).ToRevSurface())


def AddLoftSrf(object_ids, start=None, end=None, loft_type=0, simplify_method=0, value=0, closed=False):
    """A loft through curves: a list of Guids. Simplify 1 rebuilds with `value` points, 2 refits within it."""
    from katydid.values import Point3d
    if not 0 <= loft_type <= 5:
        raise ValueError("loft_type is 0 to 5")
    ends = [coerce3dpoint(one, True) if one is not None else Point3d.Unset for one in (start, end)]
    arguments = [_curves(object_ids)] + ends + [LoftType(int(loft_type)), bool(closed)]
    if simplify_method == 1:
        made = static_call("Brep", "CreateFromLoftRebuild", *arguments + [int(value)])
    elif simplify_method == 2:
        made = static_call("Brep", "CreateFromLoftRefit", *arguments + [float(value)])
    else:
        made = static_call("Brep", "CreateFromLoft", *arguments)
    return all_added(made)


def AddPlanarSrf(object_ids):
    """Planar surfaces that closed curves bound."""
    return all_added(static_call("Brep", "CreatePlanarBreps", _curves(object_ids), tolerance()))


def AddEdgeSrf(object_ids):
    return added(static_call("Brep", "CreateEdgeSurface", _curves(object_ids)))


def AddSrfPt(points):
    """A surface by three or four corners."""
    corners = coerce3dpointlist(points, True)
    if len(corners) not in (3, 4):
        raise ValueError("a surface by corners has 3 or 4, not %d" % len(corners))
    return added(static_call("NurbsSurface", "CreateFromCorners", *corners))


def AddSrfPtGrid(count, points, degree=(3, 3), closed=(False, False)):
    """A surface through rows of points."""
    return added(static_call("NurbsSurface", "CreateThroughPoints", coerce3dpointlist(points, True), int(count[0]),
                             int(count[1]), int(degree[0]), int(degree[1]), bool(closed[0]), bool(closed[1])))


def AddSrfControlPtGrid(count, points, degree=(3, 3)):
    return added(static_call("NurbsSurface", "CreateFromPoints", coerce3dpointlist(points, True), int(count[0]),
                             int(count[1]), int(degree[0]), int(degree[1])))


def AddPlaneSurface(plane, u_dir, v_dir):
    from katydid.values import Interval
    return added(construct("PlaneSurface", _plane_or_point(plane), Interval(0.0, float(u_dir)),
                           Interval(0.0, float(v_dir))))


def AddRevSrf(curve_id, axis, start_angle=0.0, end_angle=360.0):
    return added(static_call("RevSurface", "Create", coercecurve(curve_id, -1, True), coerceline(axis, True),
                             radians(start_angle), radians(end_angle)))


def AddSweep1(rail, shapes, closed=False):
    made = static_call("Brep", "CreateFromSweep", coercecurve(rail, -1, True), _curves(shapes), bool(closed), tolerance())
    return all_added(made)


def AddSweep2(rails, shapes, closed=False):
    a, b = _curves(rails)
    return all_added(static_call("Brep", "CreateFromSweep", a, b, _curves(shapes), bool(closed), tolerance()))


def AddNetworkSrf(curves, continuity=1, edge_tolerance=0, interior_tolerance=0, angle_tolerance=0):
    made = static_call("NurbsSurface", "CreateNetworkSurface", _curves(curves), int(continuity), float(edge_tolerance),
                       float(interior_tolerance), float(angle_tolerance))
    return added(made[0] if isinstance(made, tuple) else made)


def AddPatch(object_ids, uv_spans_tuple_OR_surface_object_id, *options):
    things = [coercegeometry(one, True) for one in (object_ids if is_many(object_ids) else [object_ids])]
    spans = uv_spans_tuple_OR_surface_object_id
    if is_many(spans):
        return added(static_call("Brep", "CreatePatch", things, int(spans[0]), int(spans[1]), tolerance()))
    return added(static_call("Brep", "CreatePatch", things, coercesurface(spans, True), tolerance()))


def AddPipe(curve_id, parameters, radii, blend_type=0, cap=0, fit=False):
    """A pipe with radii at parameters; cap 0 open, 1 flat, 2 round. A list of Guids."""
    rail = coercecurve(curve_id, -1, True)
    at = list(parameters) if hasattr(parameters, "__iter__") else [parameters]
    sizes = list(radii) if hasattr(radii, "__iter__") else [radii]
    domain = rail.Domain
    made = static_call("Brep", "CreatePipe", rail, [domain.NormalizedParameterAt(float(t)) for t in at],
                       [float(size) for size in sizes], blend_type == 0, PipeCapMode(int(cap)), bool(fit), tolerance(),
                       scriptcontext.doc.ModelAngleToleranceRadians)
    return all_added(made)


def ExtrudeCurve(curve_id, path_id):
    """The sum surface of two curves."""
    curve, path = coercecurve(curve_id, -1, True), coercecurve(path_id, -1, True)
    along = path.PointAtEnd - path.PointAtStart if path.IsLinear() else path
    return added(static_call("SumSurface", "Create", curve, along))


def ExtrudeCurveStraight(curve_id, start_point, end_point):
    along = coerce3dpoint(end_point, True) - coerce3dpoint(start_point, True)
    return added(static_call("Surface", "CreateExtrusion", coercecurve(curve_id, -1, True), along))


def ExtrudeCurvePoint(curve_id, point):
    return added(static_call("Surface", "CreateExtrusionToPoint", coercecurve(curve_id, -1, True),
                             coerce3dpoint(point, True)))


def ExtrudeCurveTapered(curve_id, distance, direction, base_point, angle_degrees, corner_type=0):
    from katydid.values.enums import ExtrudeCornerType
    made = static_call("Brep", "CreateFromTaperedExtrude", coercecurve(curve_id, -1, True), float(distance),
                       coerce3dvector(direction, True), coerce3dpoint(base_point, True), radians(angle_degrees),
                       ExtrudeCornerType(int(corner_type)))
    return all_added(made)


def ExtrudeSurface(surface, curve, cap=True):
    """A surface moved along a curve; with caps a solid."""
    brep, path = coercebrep(surface, True), coercecurve(curve, -1, True)
    made = brep.Faces[0].CreateExtrusion(path, bool(cap))
    return added(made)


def OffsetSurface(surface_id, distance, tolerance=None, both_sides=False, create_solid=False):
    face = coercebrep(surface_id, True).Faces[0]
    limit = scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None else tolerance
    return added(static_call("Brep", "CreateFromOffsetFace", face, float(distance), limit, bool(both_sides),
                             bool(create_solid)))


def CapPlanarHoles(surface_id):
    """Closes planar holes in place; False where there are none."""
    made = coercebrep(surface_id, True).CapPlanarHoles(tolerance())
    if made is None:
        return False
    guid = coerceguid(surface_id)
    return scriptcontext.doc.Objects.Replace(guid, made) if guid is not None else added(made) is not None


def _booleans(member):
    def work(input0, input1, delete_input=True, manifold_only=True):
        a = [coercebrep(one, True) for one in (input0 if is_many(input0) else [input0])]
        b = [coercebrep(one, True) for one in (input1 if is_many(input1) else [input1])]
        made = all_added(static_call("Brep", member, a, b, tolerance()))
        if made and delete_input:
            _delete(input0)
            _delete(input1)
        return made
    work.__name__ = member
    return work


BooleanDifference = _booleans("CreateBooleanDifference")
BooleanIntersection = _booleans("CreateBooleanIntersection")


def BooleanUnion(input, delete_input=True, manifold_only=True):
    breps = [coercebrep(one, True) for one in input]
    if len(breps) < 2:
        return None
    made = all_added(static_call("Brep", "CreateBooleanUnion", breps, tolerance()))
    if made and delete_input:
        _delete(input)
    return made


def SplitBrep(brep_id, cutter_id, delete_input=False):
    """The Guids of the pieces; None where nothing is cut."""
    pieces = coercebrep(brep_id, True).Split(coercebrep(cutter_id, True), tolerance())
    if isinstance(pieces, tuple):
        pieces = pieces[0]
    made = all_added(pieces)
    if made and delete_input:
        _delete(brep_id)
    return made


def TrimBrep(object_id, cutter, tolerance=None):
    """What is left after the parts in front of a cutter (a Brep or a plane) are taken away."""
    brep, plane = coercebrep(object_id, True), coerceplane(cutter)
    limit = scriptcontext.doc.ModelAbsoluteTolerance if tolerance is None else tolerance
    by = plane if plane is not None and coerceguid(cutter) is None else coercebrep(cutter, True)
    pieces = brep.Trim(by, limit)
    made = all_added(pieces)
    if made:
        _delete(object_id)
    return made


def TrimSurface(surface_id, direction, interval, delete_input=False):
    """The part within parameters: direction 0 u, 1 v, 2 both."""
    from katydid.values import Interval
    surface = coercesurface(surface_id, True)
    u, v = surface.Domain(0), surface.Domain(1)
    if direction == 2:
        u, v = Interval(*interval[0]), Interval(*interval[1])
    elif direction == 0:
        u = Interval(*interval)
    else:
        v = Interval(*interval)
    made = added(surface.Trim(u, v))
    if made and delete_input:
        _delete(surface_id)
    return made


def JoinSurfaces(object_ids, delete_input=False, return_all=False):
    breps = [coercebrep(one, True) for one in object_ids]
    if len(breps) < 2:
        return None
    made = all_added(static_call("Brep", "JoinBreps", breps, scriptcontext.doc.ModelAbsoluteTolerance * 2.1))
    if made and delete_input:
        _delete(object_ids)
    return made if made is None or return_all or len(made) > 1 else made[0]


def ExplodePolysurfaces(object_ids, delete_input=False):
    """One surface for each face; what has one face alone is left out."""
    guids = []
    for one in object_ids if is_many(object_ids) else [object_ids]:
        brep = coercebrep(one, True)
        if len(brep.Faces) > 1:
            guids += all_added([face.DuplicateFace(False) for face in brep.Faces]) or []
            if delete_input:
                _delete(one)
    return guids


def ExtractSurface(object_id, face_indices, copy=False):
    brep = coercebrep(object_id, True)
    indices = list(face_indices) if hasattr(face_indices, "__iter__") else [face_indices]
    return all_added([brep.Faces[i].DuplicateFace(False) for i in indices])


def ExtractIsoCurve(surface_id, parameter, direction):
    """Direction 0 along u, 1 along v, 2 both."""
    surface, guids = coercesurface(surface_id, True), []
    for along in (0, 1) if direction == 2 else (direction,):
        guids.append(added(surface.IsoCurve(along, float(parameter[1 - along]))))
    return guids


def DuplicateEdgeCurves(object_id, select=False):
    return all_added(coercebrep(object_id, True).DuplicateEdgeCurves()) or []


def DuplicateSurfaceBorder(surface_id, type=0):
    """0 all borders, 1 the outer, 2 the inner ones; joined."""
    brep = coercebrep(surface_id, True)
    naked = brep.DuplicateNakedEdgeCurves(type in (0, 1), type in (0, 2))
    if not naked:
        return []
    joined = static_call("Curve", "JoinCurves", list(naked), scriptcontext.doc.ModelAbsoluteTolerance * 2.1)
    return all_added(joined) or []


def RebuildSurface(object_id, degree=(3, 3), pointcount=(10, 10)):
    """In place; whether it worked."""
    made = coercesurface(object_id, True).Rebuild(int(degree[0]), int(degree[1]), int(pointcount[0]), int(pointcount[1]))
    if made is None:
        return False
    guid = coerceguid(object_id)
    return scriptcontext.doc.Objects.Replace(guid, made) if guid is not None else added(made) is not None


def FlipSurface(surface_id, flip=None):
    brep = coercebrep(surface_id, True).DuplicateBrep()
    before = brep.Faces[0].OrientationIsReversed
    if flip is not None and bool(before) != bool(flip):
        brep.Flip()
        scriptcontext.doc.Objects.Replace(coerceguid(surface_id, True), brep)
    return before


def MeshToNurb(object_id, trimmed_triangles=True, delete_input=False):
    """A Brep of flat faces: a list of Guids."""
    made = static_call("Brep", "CreateFromMesh", coercemesh(object_id, True), bool(trimmed_triangles))
    pieces = made if isinstance(made, list) else [made]
    guids = all_added(pieces)
    if guids and delete_input:
        _delete(object_id)
    return guids


def AddMesh(vertices, face_vertices, vertex_normals=None, texture_coordinates=None, vertex_colors=None):
    mesh = construct("Mesh")
    for point in coerce3dpointlist(vertices, True):
        mesh.Vertices.Add(point)
    for face in face_vertices:
        corners = list(face)
        if len(corners) == 4 and corners[2] == corners[3]:
            corners = corners[:3]
        mesh.Faces.AddFace(*corners)
    if vertex_colors:
        from .coerce import coercecolor
        mesh.VertexColors.SetColors([coercecolor(one, True) for one in vertex_colors])
    if vertex_normals is None:
        mesh.Normals.ComputeNormals()
    return added(mesh)


def JoinMeshes(object_ids, delete_input=False):
    mesh = construct("Mesh")
    for one in object_ids:
        mesh.Append(coercemesh(one, True))
    guid = added(mesh)
    if guid and delete_input:
        _delete(object_ids)
    return guid
