//! Mesh / Util: meshes without some of their parts, and in pieces.

use std::collections::HashSet;
use std::sync::Arc as Shared;

use katydid_component::{Context, List, Message, component};
use katydid_geometry::{Mesh, MeshFace, Plane};

use super::shared;

/// Takes faces out of a mesh by a pattern, which is repeated as needed.
#[component("57edd208-760a-4f0f-87e6-ca1bbd74133b", name = "Cull Faces", nick = "CullF", at = "Mesh/Util")]
#[output("Mesh", "M", "The mesh of the faces that stay, without vertices that none uses.")]
fn cull_faces(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// For each face whether it stays; nulls are skipped. An empty pattern keeps all.
    #[port("Pattern", "P")]
    pattern: List<bool>,
) -> Result<Shared<Mesh>, Message> {
    let pattern: Vec<bool> = pattern.present().collect();
    if pattern.is_empty() {
        return Ok(shared(mesh.clone()));
    }
    let stays = pattern.iter().cycle();
    let faces: Vec<MeshFace> = mesh.faces().iter().zip(stays).filter(|(_, s)| **s).map(|(f, _)| *f).collect();
    Ok(shared(mesh.part(&faces)?))
}

/// The numbers in a list, without those that are negative.
fn numbers(indices: &List<'_, i32>) -> HashSet<usize> {
    indices.present().filter_map(|i| usize::try_from(i).ok()).collect()
}

/// Takes faces out of a mesh by their numbers. Numbers that are no face's are ignored.
#[component(
    "d0f1311b-8287-4484-b2ea-1475c6770926",
    name = "Delete Faces",
    nick = "DeleteF",
    at = "Mesh/Util"
)]
#[output("Mesh", "M", "The mesh of the faces that stay, without vertices that none uses.")]
fn delete_faces(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The numbers of the faces to take out, from 0.
    #[port("Indices", "I")]
    indices: List<i32>,
) -> Result<Shared<Mesh>, Message> {
    let gone = numbers(&indices);
    let faces = mesh.faces().iter().enumerate();
    let faces: Vec<MeshFace> = faces.filter(|(i, _)| !gone.contains(i)).map(|(_, f)| *f).collect();
    Ok(shared(mesh.part(&faces)?))
}

/// Takes vertices out of a mesh by a pattern, which is repeated as needed, and with them the faces that they carry.
#[component("9d50bf9b-46bc-403a-9ec9-1052f51dd6b6", name = "Cull Vertices", nick = "CullV", at = "Mesh/Util")]
#[output("Mesh", "M", "The mesh that is left, without vertices that no face uses.")]
fn cull_vertices(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// For each vertex whether it stays; nulls are skipped. An empty pattern keeps all.
    #[port("Pattern", "P")]
    pattern: List<bool>,
    /// Whether a quad that loses one corner becomes a triangle; else it goes.
    #[port("Shrink", "S", default = true)]
    shrink: bool,
) -> Result<Shared<Mesh>, Message> {
    let pattern: Vec<bool> = pattern.present().collect();
    if pattern.is_empty() {
        return Ok(shared(mesh.clone()));
    }
    let gone = |i: usize| pattern.get(i % pattern.len()).is_some_and(|stays| !*stays);
    Ok(shared(mesh.without_vertices(gone, shrink)?))
}

/// Takes vertices out of a mesh by their numbers, and with them the faces that they carry. Numbers that are no
/// vertex's are ignored.
#[component(
    "23d715f7-4bc6-4e69-b76d-7c04ca2ebf5f",
    name = "Delete Vertices",
    nick = "DeleteV",
    at = "Mesh/Util"
)]
#[output("Mesh", "M", "The mesh that is left, without vertices that no face uses.")]
fn delete_vertices(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The numbers of the vertices to take out, from 0.
    #[port("Indices", "I")]
    indices: List<i32>,
    /// Whether a quad that loses one corner becomes a triangle; else it goes.
    #[port("Shrink", "S", default = true)]
    shrink: bool,
) -> Result<Shared<Mesh>, Message> {
    let gone = numbers(&indices);
    Ok(shared(mesh.without_vertices(|i| gone.contains(&i), shrink)?))
}

/// The pieces of a mesh that hang together along edges. Vertices in the same place count as one.
#[component(
    "4dce5963-dc1a-4710-8991-9437ea23888d",
    name = "Disjoint Mesh",
    nick = "Disjoint",
    at = "Mesh/Util"
)]
#[output("Meshes", "M", "The pieces, in order of their first faces.")]
fn disjoint_mesh(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<Vec<Shared<Mesh>>, Message> {
    let pieces = mesh.pieces()?;
    context.items(pieces.len())?;
    Ok(pieces.into_iter().map(shared).collect())
}

/// Cuts a mesh along a plane. The cut stays open.
#[component(
    "330eb9c9-0098-4375-9078-e00a419d49fb",
    name = "Mesh Split Plane",
    nick = "MSplit",
    at = "Mesh/Util"
)]
#[output(
    "Above",
    "A",
    "The pieces on the side to which the plane's normal points; faces in the plane are here."
)]
#[output("Below", "B", "The pieces on the other side.")]
fn mesh_split_plane(
    context: &Context<'_>,
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The plane.
    #[port("Plane", "P", default = Plane::XY)]
    plane: Plane,
) -> Result<(Vec<Shared<Mesh>>, Vec<Shared<Mesh>>), Message> {
    // Vertices that rounding alone keeps off the plane are on it.
    let size = mesh.bounding_box().map_or(0.0, |b| b.diagonal().length());
    let [above, below] = mesh.split_by_plane(&plane, (size * 1e-12).min(f64::MAX))?;
    let pieces = |side: &Mesh| -> Result<Vec<Shared<Mesh>>, Message> {
        Ok(side.pieces()?.into_iter().map(shared).collect())
    };
    let (above, below) = (pieces(&above)?, pieces(&below)?);
    context.items(above.len().saturating_add(below.len()))?;
    Ok((above, below))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::{Trial, texts};
    use katydid_data::Value;
    use katydid_geometry::{Box3, Interval, Mesh, MeshFace, Plane, Point3};

    fn mesh() -> Mesh {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
        let faces = vec![MeshFace::Quad([0, 1, 2, 3]), MeshFace::Triangle([1, 4, 2])];
        Mesh::new(points.map(Point3::from).to_vec(), faces).unwrap()
    }

    #[test]
    fn faces_and_vertices_taken_out() {
        assert_eq!(
            Trial::of("Cull Faces").item(mesh()).list([false, true]).texts(0),
            ["{0}: Mesh (V:3  F:1)"]
        );
        assert_eq!(Trial::of("Delete Faces").item(mesh()).list([1, 7]).texts(0), ["{0}: Mesh (V:4  F:1)"]);
        let cull = |shrink: bool| {
            let pattern = [true, true, true, false, true];
            Trial::of("Cull Vertices").item(mesh()).list(pattern).item(shrink).texts(0)
        };
        assert_eq!(cull(true), ["{0}: Mesh (V:4  F:2)"]);
        assert_eq!(cull(false), ["{0}: Mesh (V:3  F:1)"]);
        let delete =
            |i: i32| Trial::of("Delete Vertices").item(mesh()).list([i, -4, 99]).item(false).texts(0);
        assert_eq!(delete(4), ["{0}: Mesh (V:4  F:1)"]);
        assert_eq!(delete(1), ["{0}: Mesh (V:0  F:0)"]);
        assert_eq!(delete(77), ["{0}: Mesh (V:5  F:2)"]);
    }

    #[test]
    fn pieces() {
        assert_eq!(Trial::of("Disjoint Mesh").item(mesh()).texts(0), ["{0;0}: Mesh (V:5  F:2)"]);
        let twice = Trial::of("Mesh Join").list([mesh(), Mesh::new(vec![], vec![]).unwrap()]).run();
        assert_eq!(
            Trial::of("Disjoint Mesh").tree(twice.outputs[0].clone()).run().outputs[0].item_count(),
            1
        );
    }

    #[test]
    fn split_at_a_plane() {
        let (long, side) = (Interval::new(0.0, 3.0), Interval::new(0.0, 1.0));
        let bar = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: long }, 2, 2, 3).unwrap();
        let at = |z: f64| Plane { origin: Point3::new(0.0, 0.0, z), ..Plane::XY };
        let area = |z: f64| {
            let parts = Trial::of("Mesh Split Plane").item(bar.clone()).item(at(z)).run();
            [0, 1].map(|k| {
                let sum = parts.outputs[k].column();
                (0..sum.len()).filter_map(|i| sum.get(i)).fold(0.0, |s, v| match v {
                    Value::Mesh(m) => s + m.area(),
                    _ => s,
                })
            })
        };
        let near = |got: [f64; 2], want: [f64; 2]| {
            assert!(got.iter().zip(want).all(|(a, b)| (a - b).abs() < 1e-12), "{got:?}");
        };
        near(area(1.25), [1.0 + 4.0 * 1.75, 1.0 + 4.0 * 1.25]);
        near(area(1.0), [9.0, 5.0]);
        near(area(-1.0), [14.0, 0.0]);
        let outside = Trial::of("Mesh Split Plane").item(bar.clone()).item(at(9.0)).run();
        assert_eq!(texts(&outside.outputs[0]), ["{0;0}:"]);
        assert_eq!(outside.outputs[1].item_count(), 1);
    }
}
