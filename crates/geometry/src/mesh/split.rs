//! Meshes cut by planes.

use std::collections::HashMap;

use super::{Mesh, MeshFace};
use crate::{Error, Plane, Result};

/// What one side of the cut is made of: corners that were there and corners where an edge is cut.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Corner {
    Old(u32),
    /// The ends of the edge: above, then below.
    Cut(u32, u32),
}

impl Mesh {
    /// The parts on both sides of a plane: above, where its normal points, and below. Faces across it are cut; a
    /// vertex within `tolerance` of the plane counts as on it, and is not moved. Faces in the plane go above. Normals and
    /// colours are kept, along the cut between those of the edges' ends.
    ///
    /// # Errors
    /// The plane is not finite, or the tolerance is negative or not finite.
    pub fn split_by_plane(&self, plane: &Plane, tolerance: f64) -> Result<[Self; 2]> {
        if !plane.is_finite() {
            return Err(Error::NotFinite("cutting plane"));
        }
        if !(tolerance >= 0.0 && tolerance.is_finite()) {
            return Err(Error::OutOfRange {
                what: "tolerance",
                value: tolerance,
                must: "finite and not negative",
            });
        }
        let height = |p| {
            let d = plane.signed_distance(p);
            if d.abs() <= tolerance { 0.0 } else { d }
        };
        let heights: Vec<f64> = self.vertices.iter().map(|&p| height(p)).collect();
        let at = |i: u32| heights.get(i as usize).copied().unwrap_or(0.0);
        let mut sides = [Side::default(), Side::default()];
        for face in self.faces.iter() {
            let signs = || face.indices().iter().map(|&i| at(i));
            let above = signs().any(|h| h > 0.0);
            let below = signs().any(|h| h < 0.0);
            if !(above && below) {
                sides[usize::from(below)]
                    .add(&face.indices().iter().map(|&i| Corner::Old(i)).collect::<Vec<_>>());
                continue;
            }
            // A quad whose corners lie above and below by turns is cut as two triangles.
            let list: Vec<f64> = signs().filter(|h| *h != 0.0).collect();
            let changes = (0..list.len()).filter(|&k| list[k] * list[(k + 1) % list.len()] < 0.0).count();
            let parts: Vec<Vec<u32>> = if changes > 2 {
                face.triangles().map(|t| t.to_vec()).collect()
            } else {
                vec![face.indices().to_vec()]
            };
            for part in parts {
                for (k, side) in sides.iter_mut().enumerate() {
                    side.add(&clipped(&part, at, k == 1));
                }
            }
        }
        let [a, b] = sides;
        Ok([a.finish(self, &at)?, b.finish(self, &at)?])
    }
}

/// The part of a polygon on one side (J. Sutherland, G. Hodgman, *Reentrant polygon clipping*, CACM 17, 1974).
fn clipped(part: &[u32], at: impl Fn(u32) -> f64, below: bool) -> Vec<Corner> {
    let height = |i: u32| if below { -at(i) } else { at(i) };
    let mut out = Vec::with_capacity(part.len() + 1);
    for (&i, &j) in part.iter().zip(part.iter().cycle().skip(1)) {
        if height(i) >= 0.0 {
            out.push(Corner::Old(i));
        }
        if at(i) * at(j) < 0.0 {
            out.push(if at(i) > 0.0 { Corner::Cut(i, j) } else { Corner::Cut(j, i) });
        }
    }
    out
}

/// The faces of one side.
#[derive(Default)]
struct Side {
    number: HashMap<Corner, u32>,
    corners: Vec<Corner>,
    faces: Vec<MeshFace>,
}

impl Side {
    /// Adds a polygon of up to five corners; with fewer than three there is nothing to add.
    fn add(&mut self, polygon: &[Corner]) {
        let mut index = |c: &Corner| {
            let next = self.corners.len() as u32;
            *self.number.entry(*c).or_insert_with(|| {
                self.corners.push(*c);
                next
            })
        };
        match polygon {
            [a, b, c] => self.faces.push(MeshFace::Triangle([index(a), index(b), index(c)])),
            [a, b, c, d] => self.faces.push(MeshFace::Quad([index(a), index(b), index(c), index(d)])),
            [a, b, c, d, e] => {
                let [a, b, c, d, e] = [a, b, c, d, e].map(index);
                self.faces.extend([MeshFace::Quad([a, b, c, d]), MeshFace::Triangle([a, d, e])]);
            }
            _ => {}
        }
    }

    fn finish(self, mesh: &Mesh, at: &impl Fn(u32) -> f64) -> Result<Mesh> {
        // The place on a cut edge depends on its ends alone, so that what meets there stays together.
        let share = |i: u32, j: u32| at(i) / (at(i) - at(j));
        let blend = |corner: &Corner| match *corner {
            Corner::Old(i) => (i as usize, i as usize, 0.0),
            Corner::Cut(i, j) => (i as usize, j as usize, share(i, j)),
        };
        let (mut vertices, mut normals, mut colours) = (Vec::new(), Vec::new(), Vec::new());
        for (i, j, t) in self.corners.iter().map(blend) {
            let ends = |k: usize| mesh.vertices.get(k).copied().unwrap_or_default();
            vertices.push(if t == 0.0 { ends(i) } else { ends(i).lerp(ends(j), t) });
            if let (Some(&a), Some(&b)) = (mesh.normals.get(i), mesh.normals.get(j)) {
                let mixed = a * (1.0 - t) + b * t;
                normals.push(mixed.unitized().unwrap_or(mixed));
            }
            if let (Some(a), Some(b)) = (mesh.colours.get(i), mesh.colours.get(j)) {
                let mix = |k: usize| (f64::from(a[k]) * (1.0 - t) + f64::from(b[k]) * t).round() as u8;
                colours.push([mix(0), mix(1), mix(2), mix(3)]);
            }
        }
        Mesh::from_parts(vertices, self.faces, normals, colours)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Box3, Interval, Mesh, MeshFace, Plane, Point3, Vector3};

    fn cube(n: usize) -> Mesh {
        let side = Interval::new(-1.0, 1.0);
        Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, n, n, n).unwrap()
    }

    #[test]
    fn areas_add_up() {
        for n in 1..5 {
            for (x, y, z) in [(0.0, 0.0, 1.0), (1.0, 1.0, 1.0), (0.3, -0.2, 0.7), (1.0, -1.0, 0.0)] {
                for height in [0.0, 0.25, 0.5, -0.9, 3.0] {
                    let plane =
                        Plane::from_normal(Point3::ORIGIN, Vector3::new(x, y, z)).unwrap().offset(height);
                    let [above, below] = cube(n).split_by_plane(&plane, 1e-9).unwrap();
                    assert!((above.area() + below.area() - 24.0).abs() < 1e-9);
                    assert!(above.vertices().iter().all(|p| plane.signed_distance(*p) >= -1e-9));
                    assert!(below.vertices().iter().all(|p| plane.signed_distance(*p) <= 1e-9));
                    assert_eq!(above.normals().len(), above.vertices().len());
                    // Open only along the cut, both sides in the same places.
                    let rim = |m: &Mesh| m.edges().iter().filter(|e| e.faces == 1).count();
                    assert_eq!(rim(&above), rim(&below), "{n} {x} {y} {z} {height}");
                }
            }
        }
    }

    #[test]
    fn saddles_and_faces_in_the_plane() {
        let points = [[0.0, 0.0, 1.0], [1.0, 0.0, -1.0], [1.0, 1.0, 1.0], [0.0, 1.0, -1.0]];
        let saddle =
            Mesh::new(points.map(Point3::from).to_vec(), vec![MeshFace::Quad([0, 1, 2, 3])]).unwrap();
        let [above, below] = saddle.split_by_plane(&Plane::XY, 0.0).unwrap();
        assert!((above.area() + below.area() - saddle.area()).abs() < 1e-12);
        let top = Plane { origin: Point3::new(0.0, 0.0, 1.0), ..Plane::XY };
        let [above, below] = cube(1).split_by_plane(&top, 0.0).unwrap();
        assert_eq!((above.faces().len(), below.faces().len()), (1, 5));
        assert!(cube(1).split_by_plane(&top, -1.0).is_err());
        let [a, b] = Mesh::default().split_by_plane(&top, 0.0).unwrap();
        assert!(a.faces().is_empty() && b.faces().is_empty());
    }
}
