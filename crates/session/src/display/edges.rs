//! The edges of a mesh that are drawn.

use katydid_geometry::{Mesh, MeshFace};

/// The edges of a mesh of more faces would cover it whole.
const MOST_FACES: usize = 60_000;

/// The sides of the faces, each once; none of a mesh whose edges would cover it.
pub(super) fn of(mesh: &Mesh) -> Vec<[u32; 2]> {
    if mesh.faces().len() > MOST_FACES {
        return Vec::new();
    }
    let sides = |face: &MeshFace| {
        let corners = face.indices().to_vec();
        (0..corners.len()).filter_map(move |k| {
            let (a, b) = (*corners.get(k)?, *corners.get((k + 1) % corners.len())?);
            (a != b).then_some([a.min(b), a.max(b)])
        })
    };
    let mut edges: Vec<[u32; 2]> = mesh.faces().iter().flat_map(sides).collect();
    edges.sort_unstable();
    edges.dedup();
    edges
}
