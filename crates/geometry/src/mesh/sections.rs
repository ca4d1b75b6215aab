//! Sections of a mesh by many parallel planes.

use super::section::snap;
use super::{Mesh, MeshFace};
use crate::thresholds;
use crate::{Error, Plane, Point3, Result, Vector3};

/// A mesh prepared to be cut by planes across one direction: each looks only at the faces that it may cut.
#[derive(Debug, Clone)]
pub struct MeshSections<'a> {
    mesh: &'a Mesh,
    merged: Vec<u32>,
    snap: f64,
    direction: Vector3,
    /// From where to where each face reaches along the direction, a little more.
    spans: Vec<[f64; 2]>,
}

/// Normals are along the direction whose cosine with it is within this of 1.
const ALONG: f64 = 1e-14;

impl<'a> MeshSections<'a> {
    /// Prepares a mesh for planes whose normals have a direction.
    ///
    /// # Errors
    /// The direction is not finite or has no length.
    pub fn new(mesh: &'a Mesh, direction: Vector3) -> Result<Self> {
        let direction = direction
            .unitized()
            .filter(|d| d.is_finite())
            .ok_or(Error::degenerate("direction", "it has no length"))?;
        let (merged, snap) = (mesh.merged_indices(), snap(mesh));
        let heights: Vec<f64> = mesh.vertices().iter().map(|p| p.to_vector().dot(direction)).collect();
        // Heights are rounded by the size of the coordinates.
        let size = heights.iter().fold(0.0_f64, |m, h| m.max(h.abs()));
        let margin = 2.0 * snap + thresholds::ROUNDING * size;
        let span = |face: &MeshFace| {
            let all = face.indices().iter().filter_map(|i| heights.get(*i as usize));
            all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], h| {
                [low.min(h - margin), high.max(h + margin)]
            })
        };
        let spans = mesh.faces().iter().map(span).collect();
        Ok(Self { mesh, merged, snap, direction, spans })
    }

    /// What [`Mesh::section`] gives for each of some planes.
    ///
    /// Faces are dealt out to the planes between their ends: for n faces and m planes n·log m steps, and one for each
    /// face that a plane cuts.
    ///
    /// # Errors
    /// A plane is not finite, or its normal has another direction.
    pub fn at(&self, planes: &[Plane]) -> Result<Vec<Vec<Vec<Point3>>>> {
        let mut places: Vec<(f64, usize)> = Vec::with_capacity(planes.len());
        for (k, plane) in planes.iter().enumerate() {
            if !plane.is_finite() {
                return Err(Error::NotFinite("plane"));
            }
            if plane.z_axis.dot(self.direction).abs() < 1.0 - ALONG {
                return Err(Error::degenerate("plane", "its normal has another direction"));
            }
            places.push((plane.origin.to_vector().dot(self.direction), k));
        }
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        // A plane far away is rounded by its own size.
        let far = places.iter().fold(0.0_f64, |m, p| m.max(p.0.abs()));
        let mut faces: Vec<Vec<u32>> = vec![Vec::new(); planes.len()];
        for (&[low, high], face) in self.spans.iter().zip(0_u32..) {
            let from = places.partition_point(|p| p.0 < low - thresholds::ROUNDING * far);
            for (_, k) in places.iter().skip(from).take_while(|p| p.0 <= high + thresholds::ROUNDING * far) {
                if let Some(list) = faces.get_mut(*k) {
                    list.push(face);
                }
            }
        }
        let all = self.mesh.faces();
        Ok(planes
            .iter()
            .zip(faces)
            .map(|(plane, list)| {
                let cut = list.iter().filter_map(|i| all.get(*i as usize));
                self.mesh.section_of(cut, &self.merged, self.snap, plane)
            })
            .collect())
    }
}

#[cfg(test)]
mod tests {
    use super::MeshSections;
    use crate::{Box3, Interval, Mesh, Plane, Point3, Vector3};

    #[test]
    fn the_same_as_one_by_one() {
        let side = Interval::new(0.0, 2.0);
        let cuboid = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 4, 4, 4).unwrap();
        let sphere = Mesh::sphere(&Plane::XY.with_origin(Point3::new(1.0, 1.0, 1e3)), 3.0, 24, 17).unwrap();
        for mesh in [cuboid, sphere] {
            for direction in [Vector3::Z, Vector3::new(0.1, 0.2, 1.0), Vector3::new(-1.0, 0.0, 0.0)] {
                let center = mesh.bounding_box().unwrap().center();
                let first = Plane::from_normal(center, direction).unwrap();
                let planes: Vec<Plane> =
                    (-12..=12).rev().map(|k| first.offset(f64::from(k) * 0.25)).collect();
                let found = MeshSections::new(&mesh, direction).unwrap().at(&planes).unwrap();
                let one = |plane| mesh.section(plane).unwrap();
                assert_eq!(found, planes.iter().map(one).collect::<Vec<_>>());
                assert!(found.iter().any(|curves| !curves.is_empty()));
            }
        }
    }

    #[test]
    fn bad_input_is_refused() {
        let side = Interval::new(0.0, 2.0);
        let mesh = Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 1, 1, 1).unwrap();
        assert!(MeshSections::new(&mesh, Vector3::ZERO).is_err());
        let level = MeshSections::new(&mesh, Vector3::Z).unwrap();
        assert!(level.at(&[Plane::YZ]).is_err());
        assert!(level.at(&[Plane::XY.with_origin(Point3::new(0.0, 0.0, f64::NAN))]).is_err());
        assert!(level.at(&[]).unwrap().is_empty());
    }
}
