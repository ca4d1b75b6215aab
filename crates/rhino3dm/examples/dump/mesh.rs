//! Meshes.

use katydid_geometry::Mesh;
use serde_json::{Value, json};

use crate::numbers::{points, vectors};

pub(crate) fn mesh(mesh: &Mesh) -> Value {
    let faces: Vec<&[u32]> = mesh.faces().iter().map(|face| face.indices()).collect();
    json!({"vertices": points(mesh.vertices()), "faces": faces, "normals": vectors(mesh.normals()),
        "colours": mesh.colours()})
}
