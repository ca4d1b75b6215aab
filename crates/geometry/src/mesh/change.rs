//! One vertex or face set or added in the mesh itself: loops set them one by one, and a new mesh for each would make the
//! loop quadratic.

use std::sync::Arc;

use super::{Mesh, MeshFace};
use crate::{Error, Point3, Result};

fn finite(vertex: Point3) -> Result<Point3> {
    if vertex.is_finite() { Ok(vertex) } else { Err(Error::NotFinite("mesh vertex")) }
}

impl Mesh {
    /// Moves a vertex; false where there is none of that index.
    ///
    /// # Errors
    /// A coordinate that is not finite; the mesh is as it was.
    pub fn set_vertex(&mut self, index: usize, to: Point3) -> Result<bool> {
        let to = finite(to)?;
        match self.vertices.get_mut(index) {
            Some(vertex) => {
                *vertex = to;
                Ok(true)
            }
            None => Ok(false),
        }
    }

    /// Adds a vertex and gives its index. Normals and colours are dropped: there would be fewer than vertices.
    ///
    /// # Errors
    /// A coordinate that is not finite, or more vertices than an index can count; the mesh is as it was.
    pub fn add_vertex(&mut self, vertex: Point3) -> Result<usize> {
        let vertex = finite(vertex)?;
        let index = self.vertices.len();
        if u32::try_from(index + 1).is_err() {
            let why = format!("{} vertices are more than an index can count", index + 1);
            return Err(Error::Invalid { what: "mesh", why });
        }
        self.vertices.push(vertex);
        self.normals.clear();
        self.colours.clear();
        Ok(index)
    }

    /// Adds a face and gives its index.
    ///
    /// # Errors
    /// An index out of range; the mesh is as it was.
    pub fn add_face(&mut self, face: MeshFace) -> Result<usize> {
        let (index, count) = (self.faces.len(), self.vertices.len());
        if face.indices().iter().any(|&v| v as usize >= count) {
            let why = format!("face {index} refers to a vertex beyond the {count} there are");
            return Err(Error::Invalid { what: "mesh", why });
        }
        Arc::make_mut(&mut self.faces).push(face);
        Ok(index)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Vector3;

    #[test]
    fn what_is_refused_changes_nothing() -> Result<()> {
        let corners = vec![Point3::ORIGIN, Point3::new(1.0, 0.0, 0.0), Point3::new(0.0, 1.0, 0.0)];
        let up = vec![Vector3::new(0.0, 0.0, 1.0); 3];
        let mut mesh = Mesh::from_parts(corners, vec![MeshFace::Triangle([0, 1, 2])], up, Vec::new())?;
        let before = mesh.clone();
        assert_eq!(mesh.set_vertex(3, Point3::ORIGIN), Ok(false));
        assert!(mesh.set_vertex(0, Point3::new(f64::NAN, 0.0, 0.0)).is_err());
        assert!(mesh.add_vertex(Point3::new(0.0, f64::INFINITY, 0.0)).is_err());
        assert!(mesh.add_face(MeshFace::Triangle([0, 1, 3])).is_err());
        assert_eq!(mesh, before);
        assert_eq!(mesh.set_vertex(2, Point3::new(0.0, 2.0, 0.0)), Ok(true));
        assert_eq!((mesh.vertices()[2].y, mesh.normals().len()), (2.0, 3));
        assert_eq!(mesh.add_vertex(Point3::new(1.0, 1.0, 0.0)), Ok(3));
        assert_eq!(mesh.add_face(MeshFace::Triangle([1, 3, 2])), Ok(1));
        assert_eq!((mesh.vertices().len(), mesh.faces().len(), mesh.normals().len()), (4, 2, 0));
        Ok(())
    }
}
