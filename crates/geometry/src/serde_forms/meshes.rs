//! Meshes.

use super::{Form, through_forms};
use crate::{Mesh, MeshFace, Point3, Result, Vector3};

/// A face by its corners: three or four.
impl Form for MeshFace {
    type Written = Vec<u32>;
    fn written(&self) -> Vec<u32> {
        self.indices().to_vec()
    }
    fn read(corners: Vec<u32>) -> Result<Self> {
        match corners.as_slice() {
            [a, b, c] => Ok(Self::Triangle([*a, *b, *c])),
            [a, b, c, d] => Ok(Self::Quad([*a, *b, *c, *d])),
            _ => Err(crate::Error::Invalid {
                what: "mesh face",
                why: format!("{} corners instead of 3 or 4", corners.len()),
            }),
        }
    }
}

/// A mesh by its lists; normals and colours may be left out.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(unreachable_pub, reason = "an associated type needs it")]
pub struct WrittenMesh {
    vertices: Vec<Point3>,
    faces: Vec<MeshFace>,
    #[serde(default)]
    normals: Vec<Vector3>,
    #[serde(default)]
    colours: Vec<[u8; 4]>,
}

impl Form for Mesh {
    type Written = WrittenMesh;
    fn written(&self) -> WrittenMesh {
        WrittenMesh {
            vertices: self.vertices().to_vec(),
            faces: self.faces().to_vec(),
            normals: self.normals().to_vec(),
            colours: self.colours().to_vec(),
        }
    }
    fn read(w: WrittenMesh) -> Result<Self> {
        Self::from_parts(w.vertices, w.faces, w.normals, w.colours)
    }
}

through_forms!(MeshFace, Mesh);
