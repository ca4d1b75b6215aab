//! Vertices that nearly coincide put together.

use crate::mesh::thresholds::ALIGN_OF_SIZE;
use std::collections::HashMap;

use super::Mesh;
use crate::{Error, Point3, Result, cancellation};

impl Mesh {
    /// The mesh with every vertex that lies within `tolerance` of an earlier one moved to it, and the number of those
    /// that moved. Of several the nearest is taken; a vertex that others moved to stays where it is, so nothing
    /// wanders farther than the tolerance. Faces are kept as they are; normals are computed anew when something moved.
    ///
    /// # Errors
    /// The tolerance is negative or not finite.
    pub fn with_aligned_vertices(&self, tolerance: f64) -> Result<(Self, usize)> {
        if !(tolerance >= 0.0 && tolerance.is_finite()) {
            return Err(Error::OutOfRange {
                what: "tolerance",
                value: tolerance,
                must: "finite and not negative",
            });
        }
        let mut vertices = self.vertices.clone();
        let moved = align_points(&mut vertices, tolerance)?;
        if moved == 0 {
            return Ok((self.clone(), 0));
        }
        let aligned = Self { vertices, normals: Vec::new(), ..self.clone() };
        Ok((aligned.with_normals(), moved))
    }
}

/// Moves every point that lies within `tolerance` of an earlier one that stayed to the nearest such; gives the number
/// that moved.
///
/// # Errors
/// Nobody waits any more.
pub(crate) fn align_points(points: &mut [Point3], tolerance: f64) -> Result<usize> {
    let size = points.iter().fold(0.0_f64, |m, p| m.max(p.x.abs()).max(p.y.abs()).max(p.z.abs()));
    // Below the resolution of the numbers only equal ones are near, and they are together already.
    if !(tolerance > size * ALIGN_OF_SIZE) {
        return Ok(0);
    }
    // Cells as wide as the tolerance: what is near lies in the cell or one beside it.
    let cell = |p: &Point3| [p.x, p.y, p.z].map(|x| (x / tolerance).floor() as i64);
    let mut anchors: HashMap<[i64; 3], Vec<Point3>> = HashMap::new();
    let mut moved = 0;
    for p in points {
        cancellation::check()?;
        let [x, y, z] = cell(p);
        let mut best: Option<(f64, Point3)> = None;
        for k in 0..27 {
            let beside = [x + k % 3 - 1, y + k / 3 % 3 - 1, z + k / 9 - 1];
            for anchor in anchors.get(&beside).into_iter().flatten() {
                let distance = anchor.distance_to(*p);
                if distance <= tolerance && best.is_none_or(|(d, _)| distance < d) {
                    best = Some((distance, *anchor));
                }
            }
        }
        match best {
            Some((distance, anchor)) => {
                moved += usize::from(distance > 0.0);
                *p = anchor;
            }
            None => anchors.entry([x, y, z]).or_default().push(*p),
        }
    }
    Ok(moved)
}

#[cfg(test)]
mod tests {
    use crate::{Mesh, MeshFace, Point3};

    #[test]
    fn nearby_vertices_meet() {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.04, 0.0, 0.0], [0.0, 0.96, 0.0]];
        let points: Vec<Point3> =
            points.map(Point3::from).into_iter().chain([Point3::new(1.0, 1.0, 0.0)]).collect();
        let faces = vec![MeshFace::Triangle([0, 1, 2]), MeshFace::Triangle([3, 5, 4])];
        let mesh = Mesh::new(points, faces).unwrap();
        assert!(mesh.edges().iter().all(|e| e.faces == 1));
        let (joined, moved) = mesh.with_aligned_vertices(0.1).unwrap();
        assert_eq!(moved, 2);
        assert_eq!(joined.vertices()[3], Point3::new(1.0, 0.0, 0.0));
        assert_eq!(joined.edges().iter().filter(|e| e.faces == 2).count(), 1);
        assert_eq!(mesh.with_aligned_vertices(0.01).unwrap().1, 0);
        assert_eq!(mesh.with_aligned_vertices(0.0).unwrap().1, 0);
        assert!(mesh.with_aligned_vertices(-1.0).is_err());
        // A row of points a half apart: with a reach of 1 every third holds two.
        let row: Vec<Point3> = (0..9).map(|i| Point3::new(f64::from(i) * 0.5, 0.0, 0.0)).collect();
        let (row, moved) = Mesh::new(row, vec![]).unwrap().with_aligned_vertices(1.0).unwrap();
        assert_eq!(moved, 6);
        assert_eq!(row.vertices()[8], Point3::new(3.0, 0.0, 0.0));
    }
}
