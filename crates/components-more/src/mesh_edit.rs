//! MeshEdit: small tools for meshes.
//!
//! Names are from public lists; the order of ports is our reading, files tell them by name.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Mesh, MeshFace, Point3};

use crate::polygons::Polygons;

/// The area of a mesh. Stands for MeshEdit's Mesh Area.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d01",
    name = "Mesh Area",
    nick = "MArea",
    at = "MeshEdit/Analysis"
)]
#[output("Area", "A", "The area, in square units.")]
fn mesh_area(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> f64 {
    mesh.area()
}

/// The volume that a mesh encloses. Stands for MeshEdit's Mesh Volume.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d02",
    name = "Mesh Volume",
    nick = "MVolume",
    at = "MeshEdit/Analysis"
)]
#[output("Volume", "V", "The volume, in cubic units.")]
fn mesh_volume(
    context: &Context<'_>,
    /// The mesh, closed.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> f64 {
    if !mesh.is_closed() {
        context.warn("The mesh is open: it encloses no volume");
    }
    mesh.volume()
}

/// The faces of a mesh, each a mesh of its own. Stands for MeshEdit's Mesh Explode.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d03",
    name = "Mesh Explode",
    nick = "MExplode",
    at = "MeshEdit/Edit"
)]
#[output("Meshes", "M", "A mesh for each face.")]
fn mesh_explode(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Vec<Shared<Mesh>>, Message> {
    context.items(mesh.faces().len())?;
    mesh.faces().iter().map(|face| Ok(Shared::new(mesh.part(&[*face])?))).collect()
}

/// Turns a mesh round: its faces look to the other side. Stands for MeshEdit's Mesh Flip.
#[component("6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d04", name = "Mesh Flip", nick = "MFlip", at = "MeshEdit/Edit")]
#[output("Mesh", "M", "The mesh.")]
fn mesh_flip(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Shared<Mesh> {
    Shared::new(mesh.flipped())
}

/// Cuts quads into triangles, along the shorter diagonal. Stands for MeshEdit's Mesh Triangulate.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d05",
    name = "Mesh Triangulate",
    nick = "MTriangulate",
    at = "MeshEdit/Edit"
)]
#[output("Mesh", "M", "The mesh of triangles.")]
fn mesh_triangulate(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Shared<Mesh>, Message> {
    context.bytes(mesh.faces().len().saturating_mul(40))?;
    let at = |i: u32| mesh.vertices().get(i as usize).copied().unwrap_or(Point3::ORIGIN);
    let mut faces = Vec::with_capacity(2 * mesh.faces().len());
    for face in mesh.faces() {
        match *face {
            MeshFace::Triangle(_) => faces.push(*face),
            MeshFace::Quad([a, b, c, d]) if at(a).distance_to(at(c)) <= at(b).distance_to(at(d)) => {
                faces.extend([MeshFace::Triangle([a, b, c]), MeshFace::Triangle([a, c, d])]);
            }
            MeshFace::Quad([a, b, c, d]) => {
                faces.extend([MeshFace::Triangle([a, b, d]), MeshFace::Triangle([b, c, d])]);
            }
        }
    }
    let vertices = mesh.vertices().to_vec();
    Ok(Shared::new(Mesh::from_parts(vertices, faces, mesh.normals().to_vec(), mesh.colours().to_vec())?))
}

/// Joins pairs of triangles to quads where they are nearly flat together and the quads are nearly as wide as long. Stands for
/// MeshEdit's Mesh ConvertQuads.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d06",
    name = "Mesh ConvertQuads",
    nick = "MConvertQuads",
    at = "MeshEdit/Edit"
)]
#[output("Mesh", "M", "The mesh.")]
fn convert_quads(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The greatest angle between the triangles of a quad, in radians.
    #[port("Angle", "A", default = 0.035)]
    angle: f64,
    /// The least ratio of the shorter diagonal of a quad to the longer one.
    #[port("Ratio", "R", default = 0.5)]
    ratio: f64,
) -> Shared<Mesh> {
    Shared::new(mesh.quadrangulated(angle, ratio).0)
}

/// A mesh without vertices that no face uses. Stands for MeshEdit's Mesh CullUnused Vertices.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d07",
    name = "Mesh CullUnusedVertices",
    nick = "MCullUnused",
    at = "MeshEdit/Edit"
)]
#[output("Mesh", "M", "The mesh.")]
fn cull_unused(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Shared<Mesh>, Message> {
    Ok(Shared::new(mesh.part(mesh.faces())?))
}

/// Makes vertices in one place one where the faces there meet at less than an angle. Stands for MeshEdit's Mesh WeldVertices.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d08",
    name = "Mesh WeldVertices",
    nick = "MWeld",
    at = "MeshEdit/Edit"
)]
#[output("Mesh", "M", "The mesh.")]
fn weld(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The angle, in radians.
    #[port("Angle", "A", default = std::f64::consts::PI)]
    angle: f64,
) -> Result<Shared<Mesh>, Message> {
    if !angle.is_finite() {
        return Err(Message::error("The angle is not finite"));
    }
    Ok(Shared::new(mesh.welded(angle)))
}

/// The boundary of a mesh as lines. Stands for MeshEdit's Mesh NakedEdge.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d09",
    name = "Mesh NakedEdge",
    nick = "MNaked",
    at = "MeshEdit/Analysis"
)]
#[output("Edges", "E", "The naked edges, each a line.")]
fn naked_edges(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Vec<katydid_geometry::Line>, Message> {
    let edges = mesh.edges();
    context.items(edges.len())?;
    Ok(edges.iter().filter(|edge| edge.faces == 1).filter_map(|edge| mesh.edge_line(edge)).collect())
}

/// A mesh of quads from rows of points. Stands for MeshEdit's Mesh from Points.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d0a",
    name = "Mesh from Points",
    nick = "MfromPts",
    at = "MeshEdit/Create"
)]
#[output("Mesh", "M", "The mesh.")]
fn mesh_from_points(
    context: &Context<'_>,
    /// The points, row by row.
    #[port("Points", "P")]
    points: List<Point3>,
    /// The number of points in a row.
    #[port("U", "U", default = 2)]
    u: i32,
    /// The number of rows.
    #[port("V", "V", default = 2)]
    v: i32,
) -> Result<Shared<Mesh>, Message> {
    let points: Vec<Point3> = points.present().collect();
    let (Ok(u), Ok(v)) = (usize::try_from(u), usize::try_from(v)) else {
        return Err(Message::error("The numbers of points may not be negative"));
    };
    if u < 2 || v < 2 || u.checked_mul(v) != Some(points.len()) {
        return Err(Message::error(format!("{} points are not {v} rows of {u}", points.len())));
    }
    let faces = (1..v).flat_map(|row| {
        (1..u).map(move |k| {
            let (here, below) = (row * u + k, (row - 1) * u + k);
            vec![below - 1, below, here, here - 1]
        })
    });
    Ok(Shared::new(Polygons { faces: faces.collect(), points }.to_mesh(context)?))
}

/// Turns faces of a mesh round until neighbours look to the same side, as the first face of each piece does. Stands for MeshEdit's
/// Mesh UnifyNormals.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d0b",
    name = "Mesh UnifyNormals",
    nick = "UnifyNormals",
    at = "MeshEdit/Edit"
)]
#[output("Mesh", "M", "The mesh.")]
fn unify_normals(
    /// The mesh, open or closed.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Shared<Mesh>, Message> {
    Ok(Shared::new(mesh.unified()?.0))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_geometry::{Box3, Interval, Mesh, Plane, Point3};

    #[test]
    fn a_cube_in_parts() {
        let side = Interval::new(0.0, 2.0);
        let cube = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 1, 1, 1).unwrap();
        let of = |name: &str| Trial::of(name).item(cube.clone());
        assert_eq!(of("Mesh Area").texts(0), ["{0}: 24"]);
        assert_eq!(of("Mesh Volume").texts(0), ["{0}: 8"]);
        assert_eq!(of("Mesh NakedEdge").run().outputs[0].item_count(), 0);
        assert_eq!(of("Mesh WeldVertices").texts(0), ["{0}: Mesh (V:8  F:6)"]);
        let triangles = Trial::of("Mesh Triangulate").item(cube.clone()).run().outputs[0].clone();
        assert_eq!(katydid_component::testing::texts(&triangles)[0].split_once("F:").unwrap().1, "12)");
        let quads = Trial::of("Mesh ConvertQuads").tree(triangles).texts(0);
        assert_eq!(quads[0].split_once("F:").unwrap().1, "6)");
    }

    #[test]
    fn rows_of_points() {
        let points: Vec<Point3> =
            (0..6).map(|i| Point3::new(f64::from(i % 3), f64::from(i / 3), 0.0)).collect();
        assert_eq!(
            Trial::of("Mesh from Points").list(points.clone()).item(3).item(2).texts(0),
            ["{0}: Mesh (V:6  F:2)"]
        );
        assert!(Trial::of("Mesh from Points").list(points).item(4).item(2).message().contains("rows"));
    }
}
