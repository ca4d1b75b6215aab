//! STL, binary: 80 bytes of header, the count, then for each triangle its normal, three corners and 16 bits of 0.

use katydid_geometry::Vector3;

use crate::{Scene, Shape, Written};

pub(crate) fn write(scene: &Scene) -> Written {
    let mut triangles: u32 = 0;
    let mut body = Vec::new();
    let mut left_out = scene.left_out();
    let mut others = 0;
    for thing in &scene.things {
        let Shape::Mesh(mesh) = &thing.shape else {
            others += 1;
            continue;
        };
        for corners in mesh.faces().iter().flat_map(|face| face.triangles()) {
            let vertex = |i: u32| mesh.vertices().get(i as usize).copied().unwrap_or_default();
            let [a, b, c] = corners.map(vertex);
            let normal = (b - a).cross(c - a).unitized().unwrap_or(Vector3::ZERO);
            for v in [normal, a.to_vector(), b.to_vector(), c.to_vector()] {
                for x in [v.x, v.y, v.z] {
                    body.extend_from_slice(&(x as f32).to_le_bytes());
                }
            }
            body.extend_from_slice(&[0, 0]);
            triangles = triangles.saturating_add(1);
        }
    }
    if others > 0 {
        left_out.push(format!("{others} points and curves: STL holds meshes only"));
    }
    let mut bytes = b"Katydid, binary STL".to_vec();
    bytes.resize(80, b' ');
    bytes.extend_from_slice(&triangles.to_le_bytes());
    bytes.append(&mut body);
    Written { bytes, left_out }
}

#[cfg(test)]
mod tests {
    use katydid_geometry::{Mesh, MeshFace, Point3};

    use super::*;
    use crate::Thing;

    #[test]
    fn a_quad_is_two_triangles_of_fifty_bytes() {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|[x, y]| Point3::new(x, y, 0.0));
        let mesh = Mesh::new(corners.to_vec(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap();
        let things = vec![
            Thing { name: String::new(), shape: Shape::Mesh(mesh) },
            Thing { name: String::new(), shape: Shape::Point(Point3::ORIGIN) },
        ];
        let written = write(&Scene { things, unknown: Vec::new() });
        assert_eq!(written.bytes.len(), 84 + 2 * 50);
        assert_eq!(written.bytes[80..84], 2u32.to_le_bytes());
        assert_eq!(written.bytes[84 + 8..84 + 12], 1f32.to_le_bytes(), "the normal looks up");
        assert_eq!(written.left_out.len(), 1);
    }
}
