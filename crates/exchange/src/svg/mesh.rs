//! The edges of a mesh that say what it looks like: borders, creases, and the outline towards the eye.

use std::collections::HashMap;

use katydid_geometry::{Mesh, Point3, Vector3};

/// Faces that turn by more than this, as its cosine, have a crease between them: 30°.
const CREASE: f64 = 0.866_025_403_784_438_6;

/// What lies along an edge.
struct Edge {
    ends: [u32; 2],
    normal: Vector3,
    /// The normal of the second face, turned over where the two faces do not look to the same side.
    other: Option<Vector3>,
    faces: usize,
}

/// The edges to draw of a mesh seen against z.
pub(super) fn edges_to_draw(mesh: &Mesh) -> Vec<[Point3; 2]> {
    let places = mesh.merged_indices();
    let place = |i: u32| places.get(i as usize).copied().unwrap_or(i);
    let mut known: HashMap<[u32; 2], usize> = HashMap::new();
    let mut edges: Vec<Edge> = Vec::new();
    for (face, normal) in mesh.faces().iter().zip(mesh.face_normals()) {
        let corners = face.indices();
        let next = corners.iter().cycle().skip(1);
        for (&a, &b) in corners.iter().zip(next) {
            let ends = [place(a), place(b)];
            if ends[0] == ends[1] {
                continue;
            }
            let key = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            let index = *known.entry(key).or_insert_with(|| {
                edges.push(Edge { ends, normal, other: None, faces: 0 });
                edges.len() - 1
            });
            let Some(edge) = edges.get_mut(index) else { continue };
            edge.faces += 1;
            if edge.faces == 2 {
                // Neighbours that look to the same side walk their edge in opposite directions.
                edge.other = Some(if edge.ends == ends { -normal } else { normal });
            }
        }
    }
    let point = |i: u32| mesh.vertices().get(i as usize).copied().unwrap_or_default();
    edges.iter().filter(|edge| edge.shows()).map(|edge| edge.ends.map(point)).collect()
}

impl Edge {
    fn shows(&self) -> bool {
        let Some(other) = self.other.filter(|_| self.faces == 2) else { return true };
        let is_crease = self.normal.dot(other) < CREASE;
        let is_outline = (self.normal.z >= 0.0) != (other.z >= 0.0);
        is_crease || is_outline
    }
}

#[cfg(test)]
mod tests {
    use katydid_geometry::{Box3, Interval, Plane, Point3};

    use super::*;

    #[test]
    fn a_box_of_many_faces_has_its_twelve_edges() {
        let side = Interval::new(0.0, 4.0);
        let cube = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 4, 4, 4).unwrap();
        let edges = edges_to_draw(&cube);
        assert_eq!(edges.len(), 12 * 4);
    }

    #[test]
    fn a_ball_has_its_outline() {
        let ball = Mesh::sphere(&Plane::XY, 2.0, 64, 32).unwrap();
        let edges = edges_to_draw(&ball);
        assert_eq!(edges.len(), 64);
        assert!(
            edges
                .iter()
                .flatten()
                .all(|p| (p.distance_to(Point3::ORIGIN) - 2.0).abs() < 1e-9 && p.z.abs() < 0.5)
        );
    }
}
