//! How thick a mesh is, from place to place.

use super::{Mesh, MeshTree};
use crate::cancellation::check;
use crate::parallel::each;
use crate::thresholds;
use crate::{Point3, Result};

impl Mesh {
    /// At each vertex the way through the mesh: along the inner normal to the first face that is met from inside.
    ///
    /// `None` where there is none: at an open mesh, where the normals point inwards, and at vertices that no face has.
    /// Vertices in one place have one normal.
    ///
    /// # Errors
    /// Nobody waits any more.
    pub fn depths(&self) -> Result<Vec<Option<f64>>> {
        let tree = MeshTree::new(self);
        let (merged, face_normals) = (self.merged_indices(), self.face_normals());
        let joined = self.with_faces_on(&merged)?;
        let normals = joined.vertex_normals();
        // Faces at the vertex itself are met where the way begins.
        let nearest = thresholds::SAME_POINT * tree.size();
        let places: Vec<(usize, Point3)> = self.vertices().iter().copied().enumerate().collect();
        let depth = |&(i, p): &(usize, Point3)| -> Result<Option<f64>> {
            check()?;
            let normal = merged.get(i).and_then(|&m| normals.get(m as usize));
            let Some(inward) = normal.and_then(|n| (-*n).unitized()) else { return Ok(None) };
            let hits = tree.line_hits(p, inward, [nearest, f64::INFINITY])?;
            let leaves = |face: usize| face_normals.get(face).is_some_and(|n| n.dot(inward) > 0.0);
            Ok(hits.into_iter().find(|hit| leaves(hit.face)).map(|hit| hit.t))
        };
        each(&places, depth).into_iter().collect()
    }

    /// The mesh with its faces on other vertices of its own.
    fn with_faces_on(&self, places: &[u32]) -> Result<Self> {
        let faces = self.faces().iter().map(|f| f.map(|i| places.get(i as usize).copied().unwrap_or(i)));
        Self::new(self.vertices().to_vec(), faces.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Box3, Interval, Plane, Rectangle};

    #[test]
    fn spheres_and_plates() {
        let sphere = Mesh::sphere(&Plane::XY, 2.0, 64, 32).unwrap();
        let depths = sphere.depths().unwrap();
        assert_eq!(depths.len(), sphere.vertices().len());
        assert!(depths.iter().all(|d| d.is_some_and(|d| (d - 4.0).abs() < 0.02)), "{depths:?}");
        // In the middle of a plate it is its thickness, and turned inside out it has none.
        let plate = Box3 {
            plane: Plane::XY,
            x: Interval::new(0.0, 4.0),
            y: Interval::new(0.0, 4.0),
            z: Interval::new(0.0, 0.5),
        };
        let plate = Mesh::cuboid(&plate, 4, 4, 1).unwrap();
        let depths = plate.depths().unwrap();
        for (p, d) in plate.vertices().iter().zip(&depths) {
            if (p.x - 2.0).abs() < 1.5 && (p.y - 2.0).abs() < 1.5 {
                assert!(d.is_some_and(|d| (d - 0.5).abs() < 1e-12), "{p:?} {d:?}");
            }
        }
        assert!(plate.flipped().depths().unwrap().iter().all(Option::is_none));
    }

    #[test]
    fn a_sheet_has_no_depth() {
        let square = Rectangle { plane: Plane::XY, x: Interval::UNIT, y: Interval::UNIT };
        let sheet = Mesh::plane(&square, 2, 2).unwrap();
        assert!(sheet.depths().unwrap().iter().all(Option::is_none));
        assert!(Mesh::default().depths().unwrap().is_empty());
    }
}
