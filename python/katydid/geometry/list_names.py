"""What the names of members say beyond the host's table: lists of parts, methods of records, enumerations."""

#: The class in Rhino.Geometry.Collections of a list, by the class of its object and the property.
LISTS = {
    "Mesh": {"Vertices": "MeshVertexList", "Faces": "MeshFaceList", "Normals": "MeshVertexNormalList",
             "FaceNormals": "MeshFaceNormalList", "VertexColors": "MeshVertexColorList",
             "TopologyVertices": "MeshTopologyVertexList", "TopologyEdges": "MeshTopologyEdgeList",
             "TextureCoordinates": "MeshTextureCoordinateList", "Ngons": "MeshNgonList"},
    "NurbsCurve": {"Points": "NurbsCurvePointList", "Knots": "NurbsCurveKnotList"},
    "NurbsSurface": {"Points": "NurbsSurfacePointList", "KnotsU": "NurbsSurfaceKnotList",
                     "KnotsV": "NurbsSurfaceKnotList"},
    "Brep": {"Faces": "BrepFaceList", "Edges": "BrepEdgeList", "Vertices": "BrepVertexList", "Trims": "BrepTrimList",
             "Loops": "BrepLoopList", "Surfaces": "BrepSurfaceList", "Curves3D": "BrepCurveList",
             "Curves2D": "BrepCurveList"},
    "SubD": {"Vertices": "SubDVertexList", "Edges": "SubDEdgeList", "Faces": "SubDFaceList"},
}


def has_list(table, owner, name):
    """Whether the host has a list: by its own class, or as a property of its object."""
    lists = LISTS.get(owner, {})
    return name in lists and (table.has(lists[name], "ToArray") or table.has(owner, "get_" + name))


#: Fields of records that are methods without arguments in RhinoCommon.
RECORD_METHODS = {"BrepLoop": {"To3dCurve"}}

#: Methods of records that pick one of several fields: `Kappa(0)` is the field Kappa1.
PICKED_FIELDS = {"SurfaceCurvature": {"Kappa", "Direction"}}

#: Members whose lists of points are Polylines.
POLYLINES = {"GetNakedEdges", "GetOutlines"}

#: Members whose number is the member of an enumeration.
ENUM_RESULTS = {"Contains": "PointContainment", "PlanarClosedCurveRelationship": "RegionContainment"}
