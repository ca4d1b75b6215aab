//! Params / Geometry: parameters that hold geometry.

use katydid_component::component;
use katydid_data::Tree;

parameters! {
    /// Points. Texts such as `{1,2,3}`, vectors, planes (their origin) and circles (their centre) become points too.
    point, "fbac3e32-f100-4292-8692-77240a42fd1a", "Point", "Pt", "Params/Geometry", Point;

    /// Vectors. A point becomes the vector from the origin to it, a line the vector along it.
    vector, "16ef3e75-e315-4899-b531-d3166b42dac9", "Vector", "Vec", "Params/Geometry", Vector;

    /// Circles. Curves that are circles within the tolerance become one.
    circle, "d1028c72-ff86-4057-9eb0-36c687a4d98c", "Circle", "Circle", "Params/Geometry", Circle;

    /// Circular arcs. Curves that are arcs within the tolerance become one.
    circular_arc, "04d3eace-deaa-475e-9e69-8f804d687998", "Circular Arc", "Arc", "Params/Geometry", Arc;

    /// Curves of any kind; lines, circles, arcs and rectangles become curves.
    curve, "d5967b9f-e8ee-436b-a8ad-29fdcecf32d5", "Curve", "Crv", "Params/Geometry", Curve;

    /// Straight lines. A straight curve becomes the line between its ends.
    line, "8529dbdf-9b6f-42e9-8e1f-c7a2bde56a70", "Line", "Line", "Params/Geometry", Line;

    /// Planes. A point becomes the XY plane moved to it.
    plane, "4f8984c4-7c7a-4d69-b0a2-183cbb330d20", "Plane", "Pln", "Params/Geometry", Plane;

    /// Rectangles. A closed polyline with four right angles becomes one.
    rectangle, "abf9c670-5462-4cd8-acb3-f1ab0256dbf3", "Rectangle", "Rec", "Params/Geometry", Rectangle;

    /// Boxes. Other geometry becomes the box around it, along the world axes.
    box_parameter, "c9482db6-bea9-448d-98ff-fed6d69a8efc", "Box", "Box", "Params/Geometry", Box;

    /// Boxes with eight free corners, to morph geometry into. A box becomes one.
    twisted_box, "6db039c4-cad1-4549-bd45-e31cb0f71692", "Twisted Box", "TBox", "Params/Geometry", TwistedBox;

    /// Surfaces.
    surface, "deaf8653-5528-4286-807c-3de8b8dad781", "Surface", "Srf", "Params/Geometry", Surface;

    /// Solids and joined surfaces.
    brep, "919e146f-30ae-4aae-be34-4d72f555e7da", "Brep", "Brep", "Params/Geometry", Brep;

    /// Meshes.
    mesh, "1e936df3-0eea-4246-8549-514cb8862b7a", "Mesh", "Mesh", "Params/Geometry", Mesh;

    /// Triangles and quads of a mesh, by the indices of their corners. Texts such as `Q{0;1;2;3}` become faces.
    mesh_face, "e02b3da5-543a-46ac-a867-0ba6b0a524de", "Mesh Face", "Face", "Params/Geometry", MeshFace;

    /// Subdivision surfaces.
    subd, "89cd1a12-0007-4581-99ba-66578665e610", "SubD", "SubD", "Params/Geometry", SubD;

    /// Point clouds.
    point_cloud, "850b6368-ff26-48ce-9773-ac554ffbaeef", "Point Cloud", "Point Cloud", "Params/Geometry", PointCloud;

    /// Geometry that was put into a model and is kept here, unchanged.
    geometry_cache, "f91778ca-2700-42fc-8ee6-74049a2292b5", "Geometry Cache", "", "Params/Geometry", Geometry;

    /// Places on meshes, unchanged.
    mesh_point, "fa20fe95-5775-417b-92ff-b77c13cbf40c", "Mesh Point", "MPoint", "Params/Geometry", Generic;

    /// Settings of a mesher, unchanged.
    mesher_settings, "c3407fda-b505-4686-9165-38fe7a9274cf", "Mesher Settings", "Mesh", "Params/Geometry", Generic;

    /// Settings of a loft, unchanged.
    loft_options, "a8da9901-f5fb-49ec-9cd1-dfa7b788263e", "Loft Options", "Loft", "Surface/Util", LoftOptions;

    /// Settings of a remesher with quads, unchanged.
    quadmesh_settings, "b7cbe6eb-0608-4038-88e0-50495a559a41", "Quadmesh Settings", "QMS", "Mesh/Triangulation", QuadSettings;

    /// Geometry of any kind, unchanged.
    geometry, "ac2bc2cb-70fb-4dd5-9c78-7e1ea97fe278", "Geometry", "Geo", "Params/Geometry", Geometry;

    /// Groups of geometry.
    group, "b0851fc0-ab55-47d8-bdda-cc6306a40176", "Group", "Grp", "Params/Geometry", Group;

    /// Fields of force.
    field, "3175e3eb-1ae0-4d0b-9395-53fd3e8f8a28", "Field", "Field", "Params/Geometry", Field;

    /// Places on the globe. A point or a text such as `13.4, 52.5` becomes the place of that longitude and latitude
    /// in degrees.
    location, "87391af3-35fe-4a40-b001-2bd4547ccd45", "Location", "Loc", "Params/Geometry", Location;

    /// Transformations. A vector becomes the move along it.
    transform, "28f40e48-e739-4211-91bd-f4aefa5965f8", "Transform", "Transform", "Params/Geometry", Transform;
}
