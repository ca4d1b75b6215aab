//! Mesh / Util.

use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc as Shared;

use katydid_component::{List, Message, component};
use katydid_geometry::{Mesh, MeshFace, Point3};

use super::{integer, shared};

/// One mesh of several, in order. Nothing is welded.
#[component("4bc9dbbf-fec8-4348-a3af-e33e7edc8e7b", name = "Mesh Join", nick = "MJoin", at = "Mesh/Util")]
#[output("Mesh", "M", "The mesh.")]
fn mesh_join(
    /// The meshes; nulls are skipped.
    #[port("Meshes", "M")]
    meshes: List<Shared<Mesh>>,
) -> Result<Shared<Mesh>, Message> {
    let meshes: Vec<Mesh> = meshes.present().map(|m| (*m).clone()).collect();
    Ok(shared(Mesh::join(&meshes)?))
}

/// Makes vertices in the same place one where their faces meet at a flat enough angle.
#[component("9f6d85c9-1143-4538-bca7-69dcb11a74ef", name = "Weld Mesh", nick = "Weld", at = "Mesh/Util")]
#[output("Result", "R", "The welded mesh.")]
fn weld_mesh(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The largest angle between the normals of the faces, in radians.
    #[port("Angle", "A", default = PI)]
    angle: f64,
) -> Shared<Mesh> {
    shared(mesh.welded(angle))
}

/// Splits a mesh along sharp edges: each face gets vertices of its own there.
#[component("47814a17-ca9e-4305-9400-3a9c8d71c19d", name = "Unweld Mesh", nick = "Unweld", at = "Mesh/Util")]
#[output("Result", "R", "The unwelded mesh.")]
fn unweld_mesh(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The least angle between the normals of the faces at an edge to split, in radians.
    #[port("Angle", "A", default = FRAC_PI_2)]
    angle: f64,
) -> Shared<Mesh> {
    shared(mesh.unwelded(angle))
}

/// Turns a mesh inside out: any of its vertex normals, its face normals and the order of its face corners.
#[component("47fbc929-e88a-4a13-882e-dad84763256d", name = "Flip Mesh", nick = "FlipM", at = "Mesh/Util")]
#[output("Result", "R", "The flipped mesh.")]
fn flip_mesh(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// Whether to reverse the normals at the vertices.
    #[port("Vertex Normals", "Vn", default = true)]
    vertex_normals: bool,
    /// Whether to reverse the normals of the faces; they follow from the order of the corners.
    #[port("Face Normals", "Fn", default = true)]
    face_normals: bool,
    /// Whether to reverse the order of the corners.
    #[port("Face Orientation", "Fo", default = true)]
    orientation: bool,
) -> Result<Shared<Mesh>, Message> {
    let _ = face_normals;
    let own = if mesh.normals().is_empty() { mesh.vertex_normals() } else { mesh.normals().to_vec() };
    let normals = if vertex_normals { own.into_iter().map(|n| -n).collect() } else { own };
    let faces = mesh.faces().iter().map(|f| if orientation { f.flipped() } else { *f }).collect();
    Ok(shared(Mesh::from_parts(mesh.vertices().to_vec(), faces, normals, mesh.colours().to_vec())?))
}

/// Cuts the quads of a mesh into triangles, along their shorter diagonals.
#[component("3fba11d5-b30a-4146-8d80-d591e7a0a287", name = "Triangulate", nick = "Tri", at = "Mesh/Util")]
#[output("Mesh", "M", "The mesh of triangles.")]
#[output("Count", "N", "How many quads were cut.")]
fn triangulate(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<(Shared<Mesh>, i32), Message> {
    let at = |i: u32| mesh.vertices().get(i as usize).copied().unwrap_or(Point3::ORIGIN);
    let mut faces = Vec::with_capacity(2 * mesh.faces().len());
    let mut cut = 0;
    for face in mesh.faces() {
        match *face {
            MeshFace::Triangle(_) => faces.push(*face),
            MeshFace::Quad([a, b, c, d]) => {
                cut += 1;
                if at(a).distance_to(at(c)) <= at(b).distance_to(at(d)) {
                    faces.extend([MeshFace::Triangle([a, b, c]), MeshFace::Triangle([a, c, d])]);
                } else {
                    faces.extend([MeshFace::Triangle([a, b, d]), MeshFace::Triangle([b, c, d])]);
                }
            }
        }
    }
    Ok((shared(with_faces(mesh, faces)?), cut))
}

/// Merges neighbouring triangles of a mesh to quads, those that come nearest to rectangles first.
#[component("9266a2bb-918f-4675-9c91-f67d0dd33eac", name = "Quadrangulate", nick = "Quad", at = "Mesh/Util")]
#[output("Mesh", "M", "The mesh; triangles without a fitting neighbour stay.")]
#[output("Count", "N", "How many quads were made.")]
fn quadrangulate(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
    /// The greatest angle between the normals of two triangles that become one quad, in radians.
    #[port("Angle", "A", default = PI / 90.0)]
    angle: f64,
    /// The least ratio of the shorter diagonal of a quad to the longer one, 0 to 1.
    #[port("Ratio", "R", default = 0.875)]
    ratio: f64,
) -> (Shared<Mesh>, i32) {
    let (merged, made) = mesh.quadrangulated(angle, ratio);
    (shared(merged), integer(made))
}

/// The same vertices under other faces.
fn with_faces(mesh: &Mesh, faces: Vec<MeshFace>) -> Result<Mesh, Message> {
    let parts = (mesh.vertices().to_vec(), mesh.normals().to_vec(), mesh.colours().to_vec());
    Ok(Mesh::from_parts(parts.0, faces, parts.1, parts.2)?)
}

/// Turns faces of a mesh round until neighbours look to the same side. The first face of each piece gives the side.
#[component("ca6a48f4-b681-4989-b0c1-301a2929a84c", name = "Unify Mesh", nick = "UniM", at = "Mesh/Util")]
#[output("Result", "R", "The mesh.")]
#[output("Count", "N", "How many faces were turned round.")]
fn unify_mesh(
    /// The mesh.
    #[port("Mesh", "M")]
    mesh: &Mesh,
) -> Result<(Shared<Mesh>, i32), Message> {
    let (unified, count) = mesh.unified()?;
    Ok((shared(unified), integer(count)))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use katydid_component::testing::{Trial, texts};
    use katydid_geometry::{Mesh, MeshFace, Point3};

    fn two_faces(second: MeshFace) -> Mesh {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [2.0, 0.0, 0.0]];
        Mesh::new(points.map(Point3::from).to_vec(), vec![MeshFace::Quad([0, 1, 2, 3]), second]).unwrap()
    }

    #[test]
    fn the_golden_box_welds_to_602_vertices() {
        let made = Trial::of("Mesh Box").run().outputs[0].clone();
        let welded = Trial::of("Weld Mesh").tree(made).item(91.0 * PI / 180.0).run();
        assert_eq!(texts(&welded.outputs[0]), ["{0}: Mesh (V:602  F:600)"]);
        let again = Trial::of("Unweld Mesh").tree(welded.outputs[0].clone()).item(1.5);
        assert_eq!(again.texts(0), ["{0}: Mesh (V:726  F:600)"]);
    }

    #[test]
    fn joined() {
        let mesh = || two_faces(MeshFace::Triangle([1, 4, 2]));
        let joined = Trial::of("Mesh Join").list([mesh(), mesh()]).run();
        assert_eq!(texts(&joined.outputs[0]), ["{0}: Mesh (V:10  F:4)"]);
    }

    #[test]
    fn faces_turned_and_cut() {
        let wrong = || two_faces(MeshFace::Triangle([1, 2, 4]));
        assert_eq!(Trial::of("Unify Mesh").item(wrong()).texts(1), ["{0}: 1"]);
        let right = two_faces(MeshFace::Triangle([1, 4, 2]));
        assert_eq!(Trial::of("Unify Mesh").item(right).texts(1), ["{0}: 0"]);
        let cut = Trial::of("Triangulate").item(wrong()).run();
        assert_eq!(texts(&cut.outputs[0]), ["{0}: Mesh (V:5  F:3)"]);
        assert_eq!(texts(&cut.outputs[1]), ["{0}: 1"]);
        let back = Trial::of("Quadrangulate").tree(cut.outputs[0].clone()).run();
        assert_eq!(texts(&back.outputs[0]), ["{0}: Mesh (V:5  F:2)"]);
        assert_eq!(texts(&back.outputs[1]), ["{0}: 1"]);
        let flipped = Trial::of("Flip Mesh").item(wrong()).run().outputs[0].clone();
        assert!(Trial::of("Face Normals").tree(flipped).texts(1)[0].contains("-1}"));
    }
}
