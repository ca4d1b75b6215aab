//! The point of a mesh nearest to a given one.

use super::Mesh;
use crate::{Error, Point3, Result};

/// A point on a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct MeshPoint {
    /// The index of the face.
    pub face: usize,
    /// How much each corner of the face takes part; they add up to 1, the last is 0 in a triangle.
    pub weights: [f64; 4],
    /// The point.
    pub point: Point3,
    /// Its distance from the point asked for.
    pub distance: f64,
}

impl Mesh {
    /// The point of the mesh nearest to `q`, over all faces; quads are two triangles.
    ///
    /// # Errors
    /// `q` is not finite, or the mesh has no faces.
    pub fn closest_point(&self, q: Point3) -> Result<MeshPoint> {
        if !q.is_finite() {
            return Err(Error::NotFinite("point to project on the mesh"));
        }
        let mut best: Option<MeshPoint> = None;
        for (f, face) in self.faces().iter().enumerate() {
            for (k, triangle) in face.triangles().enumerate() {
                let corners = triangle.map(|i| self.vertices()[i as usize]);
                let (point, [a, b, c]) = closest_on_triangle(corners, q);
                let distance = point.distance_to(q);
                if best.is_none_or(|found| distance < found.distance) {
                    // The second triangle of a quad has its corners 0, 2 and 3.
                    let weights = if k == 0 { [a, b, c, 0.0] } else { [a, 0.0, b, c] };
                    best = Some(MeshPoint { face: f, weights, point, distance });
                }
            }
        }
        best.ok_or(Error::degenerate("mesh", "it has no faces"))
    }
}

/// The nearest point of a triangle and its barycentric coordinates (C. Ericson, *Real-Time Collision Detection*, 2005,
/// §5.1.5: by the region the query lies in).
pub(super) fn closest_on_triangle([a, b, c]: [Point3; 3], q: Point3) -> (Point3, [f64; 3]) {
    let (ab, ac, aq) = (b - a, c - a, q - a);
    let at = |u: f64, v: f64| (a + ab * u + ac * v, [1.0 - u - v, u, v]);
    let (d1, d2) = (ab.dot(aq), ac.dot(aq));
    if d1 <= 0.0 && d2 <= 0.0 {
        return (a, [1.0, 0.0, 0.0]);
    }
    let bq = q - b;
    let (d3, d4) = (ab.dot(bq), ac.dot(bq));
    if d3 >= 0.0 && d4 <= d3 {
        return (b, [0.0, 1.0, 0.0]);
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 && d1 > d3 {
        return at(d1 / (d1 - d3), 0.0);
    }
    let cq = q - c;
    let (d5, d6) = (ab.dot(cq), ac.dot(cq));
    if d6 >= 0.0 && d5 <= d6 {
        return (c, [0.0, 0.0, 1.0]);
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 && d2 > d6 {
        return at(0.0, d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let x = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return (b + (c - b) * x, [0.0, 1.0 - x, x]);
    }
    let sum = va + vb + vc;
    at(vb / sum, vc / sum)
}
