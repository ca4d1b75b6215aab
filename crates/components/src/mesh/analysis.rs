//! Mesh / Analysis.

use std::sync::Arc as Shared;

use katydid_component::{Context, Message, component};
use katydid_data::Colour;
use katydid_geometry::{Circle, Containment, Curve, Line, Mesh, MeshFace, Point3, PolylineCurve, Vector3};

use super::integer;
use crate::prepared;

/// The parts of a mesh.
#[component(
    "ba2d8f57-0738-42b4-b5a5-fe4d853517eb",
    name = "Deconstruct Mesh",
    nick = "DeMesh",
    at = "Mesh/Analysis"
)]
#[output("Vertices", "V", "Its vertices.")]
#[output("Faces", "F", "Its faces.")]
#[output("Colours", "C", "The colours of its vertices; none when it has no colours.")]
#[output("Normals", "N", "The unit normals at its vertices.")]
fn deconstruct_mesh(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> (Vec<Point3>, Vec<MeshFace>, Vec<Colour>, Vec<Vector3>) {
    let colours = mesh.colours().iter().map(|&[r, g, b, a]| Colour { a, r, g, b }).collect();
    let normals = if mesh.normals().is_empty() { mesh.vertex_normals() } else { mesh.normals().to_vec() };
    (mesh.vertices().to_vec(), mesh.faces().to_vec(), colours, normals)
}

/// The vertex numbers of a mesh face.
#[component(
    "aab142b1-b870-46de-8e86-654c9a554d90",
    name = "Deconstruct Face",
    nick = "DeFace",
    at = "Mesh/Analysis"
)]
#[output("Corner A", "A", "The first corner.")]
#[output("Corner B", "B", "The second corner.")]
#[output("Corner C", "C", "The third corner.")]
#[output("Corner D", "D", "The fourth corner; for a triangle the third again.")]
fn deconstruct_face(
    /// The face.
    #[port("Face", "F")]
    face: MeshFace,
) -> (i32, i32, i32, i32) {
    let index = |i: u32| i32::try_from(i).unwrap_or(i32::MAX);
    let [a, b, c, d] = match face {
        MeshFace::Triangle([a, b, c]) => [a, b, c, c],
        MeshFace::Quad(corners) => corners,
    };
    (index(a), index(b), index(c), index(d))
}

/// The edges of a mesh by the number of faces that meet there. Vertices in the same place count as one.
#[component(
    "2b9bf01d-5fe5-464c-b0b3-b469eb5f2efb",
    name = "Mesh Edges",
    nick = "MEdges",
    at = "Mesh/Analysis"
)]
#[output("Naked Edges", "E1", "Edges with one face: the rim.")]
#[output("Interior Edges", "E2", "Edges between two faces.")]
#[output("Non-Manifold Edges", "E3", "Edges where three or more faces meet.")]
fn mesh_edges(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> (Vec<Line>, Vec<Line>, Vec<Line>) {
    let mut sorted = [Vec::new(), Vec::new(), Vec::new()];
    for edge in mesh.edges() {
        let place = sorted.get_mut(edge.faces.clamp(1, 3) - 1);
        if let Some((list, line)) = place.zip(mesh.edge_line(&edge)) {
            list.push(line);
        }
    }
    let [naked, interior, crowded] = sorted;
    (naked, interior, crowded)
}

/// The outline of every face of a mesh.
#[component(
    "0b4ac802-fc4a-4201-9c66-0078b837c1eb",
    name = "Face Boundaries",
    nick = "FaceB",
    at = "Mesh/Analysis",
    also("08d45f16-c708-4ede-8fd3-b70a0a7abd8f")
)]
#[output("Boundaries", "B", "The outlines as closed polylines; null for a face whose corners coincide.")]
fn face_boundaries(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Vec<Option<Shared<Curve>>> {
    (0..mesh.faces().len())
        .map(|i| {
            let mut corners = mesh.face_points(i)?;
            corners.extend(corners.first().copied());
            PolylineCurve::new(corners).ok().map(|c| Shared::new(c.into()))
        })
        .collect()
}

/// The middle and the unit normal of every face of a mesh.
#[component(
    "cb4ca22c-3419-4962-a078-ad4ff7f1f929",
    name = "Face Normals",
    nick = "FaceN",
    at = "Mesh/Analysis"
)]
#[output("Centers", "C", "The means of the corners.")]
#[output("Normals", "N", "The normals; zero for a face without area.")]
fn face_normals(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> (Vec<Point3>, Vec<Vector3>) {
    (mesh.face_centers(), mesh.face_normals())
}

/// The circles around the triangles of a mesh. Quads are left out.
#[component(
    "d8cf1555-a0d5-43cb-8a10-46f8c014db3a",
    name = "Face Circles",
    nick = "FaceC",
    at = "Mesh/Analysis"
)]
#[output("Centers", "C", "The circles through the corners.")]
#[output(
    "Ratio",
    "R",
    "How slim each triangle is: its least height over its longest side, 0.866 for an equilateral one."
)]
fn face_circles(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> (Vec<Circle>, Vec<f64>) {
    let mut found = (Vec::new(), Vec::new());
    for i in 0..mesh.faces().len() {
        let Some(&[a, b, c]) = mesh.face_points(i).as_deref().and_then(|p| <&[Point3; 3]>::try_from(p).ok())
        else {
            continue;
        };
        if let Ok(circle) = Circle::through(a, b, c) {
            let longest = a.distance_to(b).max(b.distance_to(c)).max(c.distance_to(a));
            found.0.push(circle);
            found.1.push((b - a).cross(c - a).length() / (longest * longest));
        }
    }
    found
}

/// The point of a mesh nearest to a point.
#[component(
    "a559fee2-4b76-4370-8042-c7440cd75049",
    name = "Mesh Closest Point",
    nick = "MeshCP",
    at = "Mesh/Analysis"
)]
#[output("Point", "P", "The nearest point.")]
#[output("Index", "I", "The number of its face.")]
#[output(
    "Parameter",
    "P",
    "Its place on the mesh, as Mesh Eval takes it: the face and the weights of its corners."
)]
fn mesh_closest_point(
    context: &Context<'_>,
    /// The point to start from.
    #[port("Point", "P")]
    point: Point3,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: Shared<Mesh>,
) -> Result<(Point3, i32, Shared<str>), Message> {
    let near = prepared::mesh(context, &mesh)?.tree.closest(point)?;
    let [a, b, c, d] = near.weights;
    Ok((near.point, integer(near.face), format!("{}[{a};{b};{c};{d}]", near.face).into()))
}

/// What a mesh is at a place on one of its faces.
#[component("b2dc090f-b022-4264-8889-87e22979336e", name = "Mesh Eval", nick = "MEval", at = "Mesh/Analysis")]
#[output("Point", "P", "The point.")]
#[output("Normal", "N", "The unit normal there, between those of the corners.")]
#[output("Colour", "C", "The colour there, between those of the corners; nothing without colours.")]
fn mesh_eval(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The face and the weights of its corners, such as `12[0.5;0.25;0.25;0]`.
    #[port("Parameter", "P")]
    place: Shared<str>,
) -> Result<(Point3, Vector3, Option<Colour>), Message> {
    let wrong =
        || Message::error(format!("`{place}` is no place on a mesh: write it as 12[0.5;0.25;0.25;0]"));
    let (face, weights) = place.trim().strip_suffix(']').and_then(|t| t.split_once('[')).ok_or_else(wrong)?;
    let face: usize = face.trim().parse().map_err(|_| wrong())?;
    let weights = weights.split(';').map(|w| w.trim().parse::<f64>());
    let weights: Vec<f64> = weights.collect::<Result<_, _>>().map_err(|_| wrong())?;
    let found =
        mesh.faces().get(face).ok_or_else(|| Message::error(format!("The mesh has no face {face}")))?;
    let corners = || found.indices().iter().map(|&i| i as usize).zip(weights.iter().copied());
    let computed;
    let normals = if mesh.normals().is_empty() {
        computed = mesh.vertex_normals();
        &computed
    } else {
        mesh.normals()
    };
    let (mut point, mut normal, mut colour) = (Vector3::ZERO, Vector3::ZERO, [0.0; 4]);
    for (i, weight) in corners() {
        point += mesh.vertices().get(i).map_or(Vector3::ZERO, |p| p.to_vector()) * weight;
        normal += normals.get(i).copied().unwrap_or(Vector3::ZERO) * weight;
        for (sum, channel) in colour.iter_mut().zip(mesh.colours().get(i).into_iter().flatten()) {
            *sum += f64::from(*channel) * weight;
        }
    }
    let [r, g, b, a] = colour.map(|c: f64| c.round().clamp(0.0, 255.0) as u8);
    let colour = (!mesh.colours().is_empty()).then_some(Colour { a, r, g, b });
    Ok((point.to_point(), normal.unitized().unwrap_or(normal), colour))
}

/// Whether a point is inside a closed mesh.
///
/// For an open mesh the answer means little: a warning.
#[component(
    "01e3991d-18bd-474f-9fbd-076a8700159f",
    name = "Mesh Inclusion",
    nick = "MInc",
    at = "Mesh/Analysis"
)]
#[output("Inside", "I", "True when it is inside.")]
fn mesh_inclusion(
    context: &Context<'_>,
    /// The closed mesh.
    #[port("Mesh", "M")]
    mesh: Shared<Mesh>,
    /// The point.
    #[port("Point", "P")]
    point: Point3,
    /// Whether a point on the mesh itself, within the tolerance, counts as outside.
    #[port("Strict", "S", default = false)]
    strict: bool,
) -> Result<bool, Message> {
    let prepared = prepared::mesh(context, &mesh)?;
    if !prepared.is_closed() {
        context.warn("The mesh is not closed: it has no inside");
    }
    Ok(match prepared.tree.containment(point, context.tolerance().absolute) {
        Containment::Inside => true,
        Containment::On => !strict,
        Containment::Outside => false,
    })
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Mesh, MeshFace, Plane, Point3};

    fn mesh() -> Mesh {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
        let faces = vec![MeshFace::Quad([0, 1, 2, 3]), MeshFace::Triangle([1, 4, 2])];
        Mesh::new(points.map(Point3::from).to_vec(), faces).unwrap()
    }

    #[test]
    fn parts() {
        let parts = Trial::of("Deconstruct Mesh").item(mesh()).run();
        assert_eq!(texts(&parts.outputs[1]), ["{0;0}: Q{0;1;2;3}, T{1;4;2}"]);
        assert_eq!(texts(&parts.outputs[2]), ["{0;0}:"]);
        assert!(texts(&parts.outputs[3])[0].starts_with("{0;0}: {0, 0, 1}"));
        assert_eq!(Trial::of("Deconstruct Face").item(MeshFace::Triangle([1, 4, 2])).texts(3), ["{0}: 2"]);
    }

    #[test]
    fn edges_as_in_the_golden_case() {
        let edges = Trial::of("Mesh Edges").item(mesh()).run();
        let counts = [0, 1, 2].map(|k| edges.outputs[k].item_count());
        assert_eq!(counts, [5, 1, 0]);
        assert_eq!(texts(&edges.outputs[2]), ["{0;0}:"]);
        assert_eq!(Trial::of("Face Boundaries").item(mesh()).run().outputs[0].item_count(), 2);
    }

    #[test]
    fn faces_and_places() {
        let normals = Trial::of("Face Normals").item(mesh()).texts(0);
        assert_eq!(normals, ["{0;0}: {0.5, 0.5, 0}, {1.333333, 0.333333, 0}"]);
        assert_eq!(Trial::of("Face Circles").item(mesh()).texts(1), ["{0;0}: 0.5"]);
        let near = Trial::of("Mesh Closest Point").item(Point3::new(0.5, 0.25, 7.0)).item(mesh()).run();
        assert_eq!(texts(&near.outputs[0]), ["{0}: {0.5, 0.25, 0}"]);
        let back = Trial::of("Mesh Eval").item(mesh()).tree(near.outputs[2].clone()).run();
        assert_eq!(texts(&back.outputs[0]), ["{0}: {0.5, 0.25, 0}"]);
        assert_eq!(texts(&back.outputs[1]), ["{0}: {0, 0, 1}"]);
        assert!(Trial::of("Mesh Eval").item(mesh()).item("9[1;0;0;0]").message().contains("no face 9"));
        assert!(Trial::of("Mesh Eval").item(mesh()).item("what").message().contains("no place"));
    }
    #[test]
    fn inside() {
        let ball = || Mesh::sphere(&Plane::XY, 2.0, 12, 8).unwrap();
        let points = [Point3::ORIGIN, Point3::new(0.0, 0.0, 2.0), Point3::new(0.0, 0.0, 2.1)];
        let ask = |strict: bool| Trial::of("Mesh Inclusion").item(ball()).list(points).item(strict).texts(0);
        assert_eq!(ask(false), ["{0}: True, True, False"]);
        assert_eq!(ask(true), ["{0}: True, False, False"]);
        assert!(
            Trial::of("Mesh Inclusion").item(mesh()).item(Point3::ORIGIN).message().contains("not closed")
        );
    }
}
