//! Polygon meshes of triangles and quads.

mod align;
#[cfg(feature = "mesh-booleans")]
mod boolean;
mod change;
mod closest;
mod cut;
mod decimate;
mod depth;
mod edit;
mod face;
mod grid_mesh;
mod heal;
mod hits;
mod holes;
mod measure;
mod moments;
mod neighbours;
mod of_surface;
mod offset;
mod parts;
pub(crate) mod polygon;
mod primitives;
mod pull;
mod quadrangulate;
mod remesh;
mod section;
mod sections;
#[cfg(feature = "mesh-booleans")]
mod shadow;
mod smooth;
mod split;
mod thresholds;
mod topology;
mod tree;
mod unify;
mod unweld;

pub(crate) use align::align_points;
#[cfg(feature = "mesh-booleans")]
pub use boolean::Solid;
pub use closest::MeshPoint;
pub use decimate::Decimation;
pub use face::MeshFace;
pub use heal::Healing;
pub use hits::{MeshClash, MeshHit};
pub use of_surface::SurfaceMeshing;
pub use remesh::{GuideKind, QuadOptions, RemeshOptions, Remeshed};
pub use sections::MeshSections;
pub use smooth::Smoothing;
pub use topology::MeshEdge;
pub use tree::MeshTree;

use std::sync::Arc;

use crate::{Error, Point3, Result, Vector3};

/// A mesh: vertices, faces that index them, and per vertex, if at all, a normal and a colour.
///
/// Face indices are always in range, coordinates finite, and normals and colours either absent or one a vertex.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    vertices: Vec<Point3>,
    /// Shared by all copies and images that have the same.
    faces: Arc<Vec<MeshFace>>,
    normals: Vec<Vector3>,
    colours: Vec<[u8; 4]>,
}

impl Mesh {
    /// The mesh of vertices and faces, without normals and colours.
    ///
    /// # Errors
    /// A face index out of range, more than 2³² − 1 vertices, or a coordinate that is not finite.
    pub fn new(vertices: Vec<Point3>, faces: Vec<MeshFace>) -> Result<Self> {
        Self::from_parts(vertices, faces, Vec::new(), Vec::new())
    }

    /// The mesh with normals and RGBA colours; each of the two is empty or has one entry a vertex.
    ///
    /// # Errors
    /// As [`Mesh::new`], and when normals or colours are of another count than the vertices.
    pub fn from_parts(
        vertices: Vec<Point3>,
        faces: Vec<MeshFace>,
        normals: Vec<Vector3>,
        colours: Vec<[u8; 4]>,
    ) -> Result<Self> {
        let invalid = |why: String| Err(Error::Invalid { what: "mesh", why });
        let count = vertices.len();
        if u32::try_from(count).is_err() {
            return invalid(format!("{count} vertices are more than an index can count"));
        }
        if let Some(i) = vertices.iter().position(|p| !p.is_finite()) {
            return invalid(format!("vertex {i} is not finite"));
        }
        if let Some(i) = faces.iter().position(|f| f.indices().iter().any(|&v| v as usize >= count)) {
            return invalid(format!("face {i} refers to a vertex beyond the {count} there are"));
        }
        if !normals.is_empty() && normals.len() != count {
            return invalid(format!("{} normals for {count} vertices", normals.len()));
        }
        if normals.iter().any(|n| !n.is_finite()) {
            return Err(Error::NotFinite("mesh normal"));
        }
        if !colours.is_empty() && colours.len() != count {
            return invalid(format!("{} colours for {count} vertices", colours.len()));
        }
        Ok(Self { vertices, faces: Arc::new(faces), normals, colours })
    }

    /// The vertices.
    #[inline]
    pub fn vertices(&self) -> &[Point3] {
        &self.vertices
    }

    /// The faces.
    #[inline]
    pub fn faces(&self) -> &[MeshFace] {
        &self.faces
    }

    /// The vertex normals; empty when the mesh has none.
    #[inline]
    pub fn normals(&self) -> &[Vector3] {
        &self.normals
    }

    /// The vertex colours as red, green, blue, alpha; empty when the mesh has none.
    #[inline]
    pub fn colours(&self) -> &[[u8; 4]] {
        &self.colours
    }
}
