//! Surface / SubD: subdivision surfaces of Catmull and Clark by their control nets.

use std::sync::Arc as Shared;

use katydid_3dm::{Object, SubDObject};
use katydid_component::{Context, List, Message, component};
use katydid_data::Value;
use katydid_geometry::subd::{FromMesh, SubD, SubDEdgeTag, SubDNet, SubDVertexTag};
use katydid_geometry::{Box3, Curve, KnotSpacing, Line, Mesh, NurbsCurve, Point3};

use super::warning;

/// The archive version whose rules the bytes of SubDs follow.
const NEWEST: i32 = 80;

/// The SubD that a value holds.
pub(super) fn subd(value: &Value) -> Result<SubD, Message> {
    match value.subd() {
        Some(subd) => subd.map_err(Message::warning),
        None => Err(Message::warning(format!("A {} is no SubD", value.kind()))),
    }
}

/// The SubD that a value is; `None` for other values.
pub(crate) fn subd_of(value: &Value) -> Option<Result<SubD, Message>> {
    value.subd().map(|subd| subd.map_err(Message::warning))
}

/// A net as an output gives it.
pub(super) fn kept(context: &Context<'_>, net: SubDNet) -> Result<Value, Message> {
    // Its vertices and edges once more, as openNURBS keeps them, and the bytes of the object.
    context.bytes(net.faces().len().saturating_mul(1024))?;
    let object = Object::SubD(Box::new(SubDObject::from(&SubD::new(net))));
    object.to_raw(NEWEST, &[]).map(Value::from).map_err(|error| Message::warning(error.to_string()))
}

/// A SubD with the vertices and faces of a mesh as its control net.
#[component(
    "855a2c73-31c0-41d2-b061-57d54229d11b",
    name = "SubD from Mesh",
    nick = "SubDMesh",
    at = "Surface/SubD"
)]
#[output("SubD", "S", "The SubD.", kind = SubD)]
fn subd_from_mesh(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// Which inner edges are creases: 1 none, 2 those where the mesh is not welded. Borders always are.
    #[port("Creases", "Cr", default = 1)]
    creases: i32,
    /// Which vertices on borders are corners: 1 none, 2 those of a single face.
    #[port("Corners", "Co", default = 1)]
    corners: i32,
    /// Whether the surface goes through the vertices of the mesh rather than near them.
    #[port("Interpolate", "I", default = false)]
    interpolate: bool,
) -> Result<Value, Message> {
    context.bytes(mesh.faces().len().saturating_mul(400))?;
    let options = FromMesh { creases: creases == 2, corners: corners == 2 };
    let net = SubDNet::from_mesh(mesh, &options).map_err(warning)?;
    if !interpolate {
        return kept(context, net);
    }
    let (net, miss) = net.interpolating().map_err(warning)?;
    if miss > context.tolerance().absolute {
        context.warn(format!("The surface misses some vertices by up to {miss:.3}"));
    }
    kept(context, net)
}

/// The most subdivisions on the way to a mesh.
const FINEST: i32 = 8;

/// A mesh of a SubD, whose vertices lie on its surface.
#[component(
    "c0b3c6e9-d05d-4c51-a0df-1ce2678c7a33",
    name = "Mesh from SubD",
    nick = "MeshSubD",
    at = "Surface/SubD"
)]
#[output("Mesh", "M", "The mesh, of quads.")]
fn mesh_from_subd(
    context: &Context<'_>,
    /// The SubD.
    #[port("SubD", "S", kind = SubD)]
    value: Value,
    /// How often each face is divided into four, from 1 to 8.
    #[port("Density", "D", default = 2)]
    density: i32,
) -> Result<Shared<Mesh>, Message> {
    let subd = subd(&value)?;
    let levels = density.clamp(1, FINEST);
    if levels != density {
        context.warn(format!("The density must be from 1 to {FINEST}: {levels} is used"));
    }
    let faces = subd.net().faces().len().saturating_mul(4_usize.saturating_pow(levels.unsigned_abs()));
    context.bytes(faces.saturating_mul(100))?;
    Ok(Shared::new(subd.limit_mesh(levels.unsigned_abs()).map_err(warning)?))
}

/// The control net of a SubD as a mesh.
#[component(
    "c1a57c2a-11c5-4f77-851e-0a7dffef848e",
    name = "SubD Control Polygon",
    nick = "SubDPoly",
    at = "Surface/SubD"
)]
#[output("Mesh", "M", "The net; faces of more than four sides are triangles around their middle.")]
fn subd_control_polygon(
    /// The SubD.
    #[port("SubD", "S", kind = SubD)]
    value: Value,
) -> Result<Shared<Mesh>, Message> {
    Ok(Shared::new(subd(&value)?.net().to_mesh().map_err(warning)?))
}

/// A SubD whose control net is a box.
#[component("10487e4e-a405-48b5-b188-5a8a6328418b", name = "SubD Box", nick = "SubDBox", at = "Surface/SubD")]
#[output("SubD", "S", "The SubD.", kind = SubD)]
fn subd_box(
    context: &Context<'_>,
    /// The box.
    #[port("Box", "B")]
    shape: Box3,
    /// How many faces there are along each edge of the box, at least 1.
    #[port("Density", "D", default = 2)]
    density: i32,
    /// Whether the edges of the box are creases.
    #[port("Creases", "C", default = false)]
    creases: bool,
) -> Result<Value, Message> {
    let count = usize::try_from(density).unwrap_or(0);
    context.bytes(count.saturating_mul(count).saturating_mul(6 * 400))?;
    kept(context, SubDNet::of_box(&shape, count, creases).map_err(warning)?)
}

fn edge_letter(tag: SubDEdgeTag) -> &'static str {
    match tag {
        SubDEdgeTag::Crease => "C",
        SubDEdgeTag::Smooth | SubDEdgeTag::SmoothX => "S",
        SubDEdgeTag::Unset => "U",
    }
}

fn vertex_letter(tag: SubDVertexTag) -> &'static str {
    match tag {
        SubDVertexTag::Smooth => "S",
        SubDVertexTag::Crease => "C",
        SubDVertexTag::Corner => "K",
        SubDVertexTag::Dart => "D",
        SubDVertexTag::Unset => "U",
    }
}

/// Subdivisions along an edge on the way to its curve.
const ALONG: u32 = 4;

/// The edges of a SubD.
#[component(
    "2183c4c6-b5b3-45d2-9261-2096c9357f92",
    name = "SubD Edges",
    nick = "SubDEdges",
    at = "Surface/SubD"
)]
#[output("Line", "L", "The edges of the control net.")]
#[output("Edge", "E", "The curves on the surface that they become, through seventeen points each.")]
#[output("Tag", "T", "S for a smooth edge, C for a crease.")]
#[output("Id", "I", "The number of each edge.")]
fn subd_edges(
    context: &Context<'_>,
    /// The SubD.
    #[port("SubD", "S", kind = SubD)]
    value: Value,
) -> Result<(Vec<Line>, Vec<Option<Shared<Curve>>>, Vec<Shared<str>>, Vec<Shared<str>>), Message> {
    let subd = subd(&value)?;
    let edges = subd.net().edges();
    context.items(edges.len().saturating_mul(4))?;
    context.bytes(edges.len().saturating_mul(2_000))?;
    let lines = (0..edges.len()).filter_map(|edge| subd.net().edge_line(edge)).collect();
    let curve = |points: Vec<Point3>| -> Option<Shared<Curve>> {
        let made = NurbsCurve::interpolate(3, &points, KnotSpacing::Chord, None, None);
        made.ok().map(|curve| Shared::new(curve.into()))
    };
    let curves = subd.edge_limits(ALONG).into_iter().map(curve).collect();
    let tags = edges.iter().map(|edge| Shared::from(edge_letter(edge.tag))).collect();
    Ok((lines, curves, tags, edges.iter().map(|edge| Shared::from(edge.id.to_string())).collect()))
}

/// The faces of a SubD.
#[component(
    "83c81431-17bc-4bff-bb85-be0a846bd044",
    name = "SubD Faces",
    nick = "SubDFaces",
    at = "Surface/SubD"
)]
#[output("Point", "P", "The middle of each face of the control net.")]
#[output("Count", "C", "How many sides each has.")]
#[output("Edges", "E", "For each the numbers of its edges, with semicolons between.")]
#[output("Vertices", "V", "For each the numbers of its vertices, with semicolons between.")]
fn subd_faces(
    context: &Context<'_>,
    /// The SubD.
    #[port("SubD", "S", kind = SubD)]
    value: Value,
) -> Result<(Vec<Point3>, Vec<i32>, Vec<Shared<str>>, Vec<Shared<str>>), Message> {
    let subd = subd(&value)?;
    let net = subd.net();
    context.items(net.faces().len().saturating_mul(4))?;
    let all = 0..net.faces().len();
    let ids = |list: Vec<u32>| -> Shared<str> {
        list.iter().map(u32::to_string).collect::<Vec<_>>().join(";").into()
    };
    let edges = net.faces().iter().map(|face| {
        ids(face.edges.iter().filter_map(|side| net.edges().get(side.index)).map(|edge| edge.id).collect())
    });
    let vertices = all
        .clone()
        .map(|face| ids(net.corners(face).filter_map(|v| net.vertices().get(v)).map(|v| v.id).collect()));
    Ok((
        all.clone().map(|face| net.face_middle(face)).collect(),
        net.faces().iter().map(|face| i32::try_from(face.edges.len()).unwrap_or(i32::MAX)).collect(),
        edges.collect(),
        vertices.collect(),
    ))
}

/// The vertices of a SubD.
#[component(
    "fc8ad805-2cbf-4447-b41b-50c0be591fcd",
    name = "SubD Vertices",
    nick = "SubDVerts",
    at = "Surface/SubD"
)]
#[output("Point", "P", "The points of the control net.")]
#[output("Id", "I", "The number of each vertex.")]
#[output(
    "Tag",
    "T",
    "S for a smooth vertex, C for one on a crease, D for the end of a crease, K for a corner."
)]
fn subd_vertices(
    context: &Context<'_>,
    /// The SubD.
    #[port("SubD", "S", kind = SubD)]
    value: Value,
) -> Result<(Vec<Point3>, Vec<Shared<str>>, Vec<Shared<str>>), Message> {
    let subd = subd(&value)?;
    let vertices = subd.net().vertices();
    context.items(vertices.len().saturating_mul(3))?;
    Ok((
        vertices.iter().map(|vertex| vertex.point).collect(),
        vertices.iter().map(|vertex| Shared::from(vertex.id.to_string())).collect(),
        vertices.iter().map(|vertex| Shared::from(vertex_letter(vertex.tag))).collect(),
    ))
}

/// The vertices of a SubD. An early form of the component of the same name.
#[component(
    "cd9efa8f-0084-4d52-ab13-ad88ff22dc46",
    name = "SubD Vertices",
    nick = "SubDVerts",
    at = "Surface/SubD",
    old
)]
#[output("Point", "P", "The points of the control net.")]
#[output("Id", "I", "The number of each vertex.")]
fn subd_vertices_without_tags(
    context: &Context<'_>,
    /// The SubD.
    #[port("SubD", "S", kind = SubD)]
    value: Value,
) -> Result<(Vec<Point3>, Vec<Shared<str>>), Message> {
    let subd = subd(&value)?;
    let vertices = subd.net().vertices();
    context.items(vertices.len().saturating_mul(2))?;
    let ids = vertices.iter().map(|vertex| Shared::from(vertex.id.to_string()));
    Ok((vertices.iter().map(|vertex| vertex.point).collect(), ids.collect()))
}

/// The places of the parts with some numbers; those that are not there are left out with a warning.
fn places(context: &Context<'_>, ids: &List<'_, i32>, all: impl Iterator<Item = u32>) -> Vec<usize> {
    let of: std::collections::HashMap<i64, usize> = all.map(i64::from).zip(0..).collect();
    let mut missing = 0;
    let mut found = Vec::new();
    for id in ids.present() {
        match of.get(&i64::from(id)) {
            Some(place) => found.push(*place),
            None => missing += 1,
        }
    }
    if missing > 0 {
        context.warn(format!("{missing} of the numbers are none of the SubD's"));
    }
    found
}

/// Makes edges of a SubD smooth or sharp.
#[component(
    "048b219e-284a-49f2-ae40-a60465b08447",
    name = "SubD Edge Tags",
    nick = "SubDTags",
    at = "Surface/SubD"
)]
#[output("SubD", "S", "The SubD with the tags.", kind = SubD)]
fn subd_edge_tags(
    context: &Context<'_>,
    /// The SubD.
    #[port("SubD", "S", kind = SubD)]
    value: Value,
    /// S or Smooth for smooth edges, C or Crease for creases.
    #[port("Edge Tag", "T", default = "C")]
    tag: Shared<str>,
    /// The numbers of the edges, as SubD Edges gives them.
    #[port("Edge IDs", "E")]
    ids: List<i32>,
) -> Result<Value, Message> {
    let tag = match tag.trim().to_lowercase().as_str() {
        "s" | "smooth" => SubDEdgeTag::Smooth,
        "c" | "crease" => SubDEdgeTag::Crease,
        other => return Err(Message::error(format!("\"{other}\" is no tag of an edge: use S or C"))),
    };
    let net = subd(&value)?.net().clone();
    let places = places(context, &ids, net.edges().iter().map(|edge| edge.id));
    kept(context, net.with_edge_tag(&places, tag).map_err(warning)?)
}

/// Makes vertices of a SubD smooth or corners.
#[component(
    "954a8963-bb2c-4847-9012-69ff34acddd5",
    name = "SubD Vertex Tags",
    nick = "SubDVTags",
    at = "Surface/SubD"
)]
#[output("SubD", "S", "The SubD with the tags.", kind = SubD)]
fn subd_vertex_tags(
    context: &Context<'_>,
    /// The SubD.
    #[port("SubD", "S", kind = SubD)]
    value: Value,
    /// S or Smooth, C or Crease, D or Dart, K or Corner. Tags that do not go with the creases at a vertex change
    /// nothing.
    #[port("Vertex Tag", "T", default = "K")]
    tag: Shared<str>,
    /// The numbers of the vertices, as SubD Vertices gives them.
    #[port("Vertex IDs", "V")]
    ids: List<i32>,
) -> Result<Value, Message> {
    let tag = match tag.trim().to_lowercase().as_str() {
        "s" | "smooth" => SubDVertexTag::Smooth,
        "c" | "crease" => SubDVertexTag::Crease,
        "d" | "dart" => SubDVertexTag::Dart,
        "k" | "corner" => SubDVertexTag::Corner,
        other => {
            return Err(Message::error(format!("\"{other}\" is no tag of a vertex: use S, C, D or K")));
        }
    };
    let net = subd(&value)?.net().clone();
    let places = places(context, &ids, net.vertices().iter().map(|vertex| vertex.id));
    kept(context, net.with_vertex_tag(&places, tag).map_err(warning)?)
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::Tree;
    use katydid_geometry::{Box3, Interval, Mesh, Plane};

    fn first(trial: Trial) -> Tree {
        trial.run().outputs.swap_remove(0)
    }

    fn block(density: i32, creases: bool) -> Tree {
        let side = Interval::new(-1.0, 1.0);
        let shape = Box3 { plane: Plane::XY, x: side, y: side, z: side };
        first(Trial::of("SubD Box").item(shape).item(density).item(creases))
    }

    #[test]
    fn boxes_become_meshes() {
        let volume = |subd: Tree| {
            let mesh = first(Trial::of("Mesh from SubD").tree(subd).item(3));
            Trial::of("Volume").tree(mesh).texts(0).join("")
        };
        assert_eq!(volume(block(2, true)), "{0}: 8");
        let net = first(Trial::of("SubD Control Polygon").tree(block(2, false)));
        assert_eq!(Trial::of("Volume").tree(net).texts(0), ["{0}: 8"]);
    }

    #[test]
    fn parts_and_tags() {
        let edges = Trial::of("SubD Edges").tree(block(1, false)).run().outputs;
        assert_eq!(edges.iter().map(Tree::item_count).collect::<Vec<_>>(), [12; 4]);
        assert_eq!(Trial::of("SubD Faces").tree(block(1, false)).texts(1), ["{0;0}: 4, 4, 4, 4, 4, 4"]);
        let tagged = first(Trial::of("SubD Edge Tags").tree(block(1, false)).item("C").list([1, 2, 99]));
        let tags = Trial::of("SubD Edges").tree(tagged.clone()).texts(2).join("");
        assert_eq!(tags.matches('C').count(), 2);
        let letters = Trial::of("SubD Vertices").tree(tagged).texts(2).join("");
        assert!(letters.contains('D') || letters.contains('C'), "{letters}");
        let corner = first(Trial::of("SubD Vertex Tags").tree(block(1, false)).item("corner").list([1]));
        assert_eq!(Trial::of("SubD Vertices").tree(corner).texts(2).join("").matches('K').count(), 1);
    }

    #[test]
    fn meshes_become_subds() {
        let mesh = Mesh::sphere(&Plane::XY, 2.0, 8, 6).unwrap();
        let subd = first(Trial::of("SubD from Mesh").item(mesh).item(1).item(1).item(true));
        let again = first(Trial::of("Mesh from SubD").tree(subd).item(2));
        assert!(again.item_count() == 1);
    }
}
