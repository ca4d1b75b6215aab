//! MeshEdit: small tools for meshes.
//!
//! Names are from public lists; the order of ports is our reading, files tell them by name.

use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::cloud::{convex_hull, convex_hull_3d};
use katydid_geometry::{Mesh, MeshFace, Plane, Point2, Point3, Vector3};

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

/// The points of a list that are there.
///
/// # Errors
/// There are none.
fn given(points: &List<'_, Point3>) -> Result<Vec<Point3>, Message> {
    let points: Vec<Point3> = points.present().collect();
    if points.is_empty() { Err(Message::error("There are no points")) } else { Ok(points) }
}

/// The convex hull of points in space, as a closed mesh of triangles. Points in one plane have none. Stands for MeshEdit's 3D
/// ConvexHull.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d0c",
    name = "3D ConvexHull",
    nick = "ConvexHull",
    at = "MeshEdit/Triangulation"
)]
#[output("ConvexHullSurface", "M", "The mesh.")]
fn convex_hull_mesh(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
) -> Result<Shared<Mesh>, Message> {
    let points = given(&points)?;
    context.items(points.len())?;
    let faces: Vec<MeshFace> = convex_hull_3d(&points)?.into_iter().map(MeshFace::Triangle).collect();
    Ok(Shared::new(Mesh::new(points, Vec::new())?.part(&faces)?.with_normals()))
}

/// The corners of the convex hull of points by their numbers.
fn hull_corners(points: &[Point3], tolerance: f64) -> Result<Vec<usize>, Message> {
    let plane = match Plane::fit(points) {
        Ok((plane, deviation)) if deviation <= tolerance => plane,
        Ok(_) => {
            let mut corners: Vec<usize> =
                convex_hull_3d(points)?.concat().into_iter().map(|i| i as usize).collect();
            corners.sort_unstable();
            corners.dedup();
            return Ok(corners);
        }
        // All of them on one line, which any plane along it shows.
        Err(_) => {
            let first = points.first().copied().unwrap_or(Point3::ORIGIN);
            let away = points.iter().map(|p| *p - first);
            let far = away.fold(Vector3::ZERO, |far, v| if v.length() > far.length() { v } else { far });
            Plane::from_normal(first, far.perpendicular().unwrap_or(Vector3::Z))?
        }
    };
    let flat = |p: &Point3| {
        let [x, y, _] = plane.coordinates(*p);
        Point2::new(x, y)
    };
    Ok(convex_hull(&points.iter().map(flat).collect::<Vec<Point2>>())?)
}

/// The points of a set that are corners of its convex hull. In space they keep their order; those of points in one plane, within the
/// tolerance of the document, go round it. Stands for MeshEdit's Convex Hull Points.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1d0d",
    name = "Convex Hull Points",
    nick = "HullPt",
    at = "MeshEdit/Triangulation"
)]
#[output("ConvexHull", "P", "The corners.")]
#[output("Indices", "ID", "Their places among the points, from 0; nulls are not counted.")]
fn convex_hull_points(
    context: &Context<'_>,
    /// The points.
    #[port("Points", "P")]
    points: List<Point3>,
) -> Result<(Vec<Point3>, Vec<i32>), Message> {
    let points = given(&points)?;
    context.items(points.len().saturating_mul(2))?;
    let corners = hull_corners(&points, context.tolerance().absolute)?;
    let places = corners.iter().map(|i| i32::try_from(*i).unwrap_or(i32::MAX)).collect();
    Ok((corners.iter().filter_map(|i| points.get(*i).copied()).collect(), places))
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

    /// The corners of a cube of side 2, its middle, and a point inside.
    fn cloud() -> Vec<Point3> {
        let mut points: Vec<Point3> = vec![Point3::new(1.0, 1.0, 1.0)];
        points.extend(
            (0..8).map(|i| Point3::new(f64::from(2 * (i & 1)), f64::from(i & 2), f64::from((i & 4) / 2))),
        );
        points.push(Point3::new(0.5, 1.0, 1.5));
        points
    }

    #[test]
    fn hulls_in_space() {
        let hull = Trial::of("3D ConvexHull").list(cloud()).run().outputs[0].clone();
        let Some(katydid_data::Value::Mesh(mesh)) = hull.column().get(0) else { panic!("a mesh") };
        assert_eq!((mesh.vertices().len(), mesh.faces().len()), (8, 12));
        assert!(mesh.is_closed() && (mesh.volume() - 8.0).abs() < 1e-12);
        assert_eq!(Trial::of("Convex Hull Points").list(cloud()).texts(1), ["{0}: 1, 2, 3, 4, 5, 6, 7, 8"]);
        let none: [Option<Point3>; 1] = [None];
        assert_eq!(Trial::of("3D ConvexHull").gaps(none).message(), "There are no points");
    }

    #[test]
    fn hulls_of_flat_points() {
        let flat = || {
            [(0.0, 0.0), (4.0, 0.0), (1.0, 1.0), (4.0, 3.0), (0.0, 3.0)].map(|(x, y)| Point3::new(x, y, 7.0))
        };
        let out = Trial::of("Convex Hull Points").list(flat()).texts(1);
        let mut places: Vec<&str> = out[0].trim_start_matches("{0}: ").split(", ").collect();
        places.sort_unstable();
        assert_eq!(places, ["0", "1", "3", "4"]);
        assert!(!Trial::of("3D ConvexHull").list(flat()).message().is_empty());
        let line = [3.0, 1.0, 2.0].map(|x| Point3::new(x, x, 0.0));
        let ends = Trial::of("Convex Hull Points").list(line).texts(1);
        assert!(ends == ["{0}: 0, 1"] || ends == ["{0}: 1, 0"], "{ends:?}");
        assert_eq!(Trial::of("Convex Hull Points").list([Point3::ORIGIN]).texts(1), ["{0}: 0"]);
        let broken = Trial::of("Convex Hull Points").list([Point3::new(f64::NAN, 0.0, 0.0)]);
        assert!(!broken.message().is_empty());
    }
}
