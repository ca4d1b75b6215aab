//! Edges of meshes that belong to the picture.

use std::collections::HashMap;

use super::{Silhouette, SilhouetteKind, SilhouettePart, Viewpoint};
use crate::{Mesh, Tolerance, Vector3};

/// Cosines below this count as edge-on.
const FLAT: f64 = 1e-9;

/// How one face runs along an edge.
#[derive(Debug, Clone, Copy)]
struct Along {
    face: usize,
    /// The face's own vertices at the edge's ends.
    vertices: [u32; 2],
    /// Whether it runs the way in which the edge was named first.
    forwards: bool,
}

pub(super) fn silhouettes(mesh: &Mesh, viewpoint: Viewpoint, tolerance: &Tolerance) -> Vec<Silhouette> {
    let normals = mesh.face_normals();
    let centres = mesh.face_centers();
    let mut out = Vec::new();
    for (i, (ends, faces)) in edges(mesh).into_iter().enumerate() {
        let seen = |a: &Along| -> (i8, Vector3) {
            let normal = normals.get(a.face).copied().unwrap_or(Vector3::ZERO);
            let facing = centres.get(a.face).map_or(0.0, |c| viewpoint.facing(normal, *c));
            let sign = if facing.abs() <= FLAT { 0 } else { facing.signum() as i8 };
            (sign, normal)
        };
        let kind = match faces.as_slice() {
            [_] => SilhouetteKind::Boundary,
            [a, b] => {
                let ((s, n), (mut t, mut m)) = (seen(a), seen(b));
                if a.forwards == b.forwards {
                    (t, m) = (-t, -m);
                }
                let welded = if a.forwards == b.forwards {
                    a.vertices == b.vertices
                } else {
                    a.vertices == [b.vertices[1], b.vertices[0]]
                };
                let crease = !welded && n.angle_to(m).is_some_and(|x| x > tolerance.angle);
                match (s, t) {
                    (0, x) | (x, 0) if x != 0 => SilhouetteKind::Projecting,
                    (s, t) if s * t < 0 && crease => SilhouetteKind::Crease,
                    (s, t) if s * t < 0 => SilhouetteKind::Tangent,
                    _ if crease => SilhouetteKind::NonSilhouetteCrease,
                    _ => continue,
                }
            }
            _ => SilhouetteKind::Crease,
        };
        let at = |k: u32| mesh.vertices().get(k as usize).copied();
        let (Some(a), Some(b)) = (at(ends[0]), at(ends[1])) else { continue };
        if a != b {
            let curve = crate::Line::new(a, b).into();
            out.push(Silhouette { curve, kind, part: SilhouettePart::MeshEdge(i) });
        }
    }
    out
}

/// All edges in the order of [`Mesh::edges`], with the faces along them.
fn edges(mesh: &Mesh) -> Vec<([u32; 2], Vec<Along>)> {
    let merged = mesh.merged_indices();
    let mut found: HashMap<(u32, u32), usize> = HashMap::new();
    let mut out: Vec<([u32; 2], Vec<Along>)> = Vec::new();
    for (face, corners) in mesh.faces().iter().enumerate() {
        let indices = corners.indices();
        for (k, &i) in indices.iter().enumerate() {
            let next = indices.get((k + 1) % indices.len()).copied().unwrap_or(i);
            let [a, b] = [i, next].map(|x| merged.get(x as usize).copied().unwrap_or(x));
            if a == b {
                continue;
            }
            let at = *found.entry((a.min(b), a.max(b))).or_insert(out.len());
            if at == out.len() {
                out.push(([a, b], Vec::with_capacity(2)));
            }
            if let Some((ends, faces)) = out.get_mut(at) {
                faces.push(Along { face, vertices: [i, next], forwards: ends[0] == a });
            }
        }
    }
    out
}
