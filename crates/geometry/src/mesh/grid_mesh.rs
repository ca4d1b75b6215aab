//! Meshes of quads along the parameters of surfaces.

use super::{Mesh, MeshFace};
use crate::{Direction, Point3, Result, Surface};

/// No more vertices than this.
const MOST: usize = 250_000;

impl Surface {
    /// A mesh with vertices on the surface, at equal parameters within each span, so close together that the middles of
    /// its faces and sides are within `tolerance` of the surface's points there, or as close as 250,000 vertices allow;
    /// and the largest such distance found.
    ///
    /// # Errors
    /// A point of the surface is not finite.
    pub fn to_grid_mesh(&self, tolerance: f64) -> Result<(Mesh, f64)> {
        let spans = Direction::BOTH.map(|d| self.span_parameters(d));
        let mut parts = [2_usize; 2];
        loop {
            let [us, vs] = [0, 1].map(|d| places(&spans[d], parts[d]));
            let m = vs.len();
            let points: Vec<Point3> =
                us.iter().flat_map(|&u| vs.iter().map(move |&v| self.point_at(u, v))).collect();
            let at = |i: usize, j: usize| points.get(i * m + j).copied().unwrap_or(Point3::ORIGIN);
            // How far chords along u, and along v, leave the surface.
            let mut miss = [0.0_f64; 2];
            let mut twist = 0.0_f64;
            for (i, u) in us.windows(2).enumerate() {
                for (j, v) in vs.windows(2).enumerate() {
                    let (mid_u, mid_v) = (0.5 * (u[0] + u[1]), 0.5 * (v[0] + v[1]));
                    let chord = |p: Point3, q: Point3, s: Point3| p.lerp(q, 0.5).distance_to(s);
                    miss[0] = miss[0].max(chord(at(i, j), at(i + 1, j), self.point_at(mid_u, v[0])));
                    miss[1] = miss[1].max(chord(at(i, j), at(i, j + 1), self.point_at(u[0], mid_v)));
                    twist = twist.max(chord(at(i, j), at(i + 1, j + 1), self.point_at(mid_u, mid_v)));
                }
            }
            let worst = miss[0].max(miss[1]).max(twist);
            let count = |d: usize, k: usize| (spans[d].len().saturating_sub(1)).saturating_mul(k) + 1;
            let finer = if twist > 2.0 * (miss[0] + miss[1]) {
                [parts[0] * 2, parts[1] * 2]
            } else if miss[0] >= miss[1] {
                [parts[0] * 2, parts[1]]
            } else {
                [parts[0], parts[1] * 2]
            };
            let room = count(0, finer[0]).saturating_mul(count(1, finer[1])) <= MOST;
            if worst > tolerance && room {
                parts = finer;
                continue;
            }
            let index = |i: usize, j: usize| (i * m + j) as u32;
            let faces = (1..us.len()).flat_map(|i| {
                (1..m).map(move |j| {
                    MeshFace::Quad([index(i - 1, j - 1), index(i, j - 1), index(i, j), index(i - 1, j)])
                })
            });
            return Ok((Mesh::new(points.clone(), faces.collect())?, worst));
        }
    }
}

/// Each span in equal parts.
fn places(spans: &[f64], parts: usize) -> Vec<f64> {
    let mut out = Vec::new();
    for w in spans.windows(2) {
        out.extend((0..parts).map(|k| w[0] + (w[1] - w[0]) * (k as f64 / parts as f64)));
    }
    out.extend(spans.last());
    out
}

#[cfg(test)]
mod tests {
    use crate::{Interval, Plane, PlaneSurface, Point3, Sphere, Surface};

    #[test]
    fn meshes_follow_surfaces() {
        let ball: Surface = Sphere::around(Point3::ORIGIN, 2.0).unwrap().into();
        let (mesh, miss) = ball.to_grid_mesh(0.01).unwrap();
        assert!(miss <= 0.01);
        assert!((mesh.area() - 16.0 * std::f64::consts::PI).abs() < 0.5);
        let side = Interval::new(0.0, 4.0);
        let flat: Surface = PlaneSurface::new(Plane::XY, side, side).unwrap().into();
        let (mesh, miss) = flat.to_grid_mesh(0.01).unwrap();
        assert!(miss < 1e-15 && mesh.faces().len() == 4 && (mesh.area() - 16.0).abs() < 1e-12);
        assert!(ball.to_grid_mesh(0.0).unwrap().0.vertices().len() <= 250_000);
    }
}
