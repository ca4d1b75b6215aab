//! Curves pulled and projected onto meshes.

use super::{Mesh, MeshTree};
use crate::thresholds;
use crate::{Curve, Error, Line, Point3, PolylineCurve, PolylineLimits, Result, Vector3};

/// A segment is not halved more often than this.
const DEEPEST: u32 = 12;

fn corners(curve: &Curve, tolerance: f64) -> Result<Vec<Point3>> {
    if !(tolerance > 0.0 && tolerance.is_finite()) {
        return Err(Error::OutOfRange {
            what: "tolerance",
            value: tolerance,
            must: "finite and greater than 0",
        });
    }
    match curve.as_polyline() {
        Some(points) => Ok(points),
        None => Ok(curve.to_polyline(&PolylineLimits::within(tolerance))?.points().to_vec()),
    }
}

impl Mesh {
    /// The polyline that the nearest points of the mesh make for all points of a curve: its corners lie on the mesh, and
    /// its sides are within `tolerance` of the nearest points in their middles, but where those leap.
    ///
    /// # Errors
    /// A mesh without faces, a tolerance that is not above 0, or a curve that is pulled to a single point.
    pub fn pull_curve(&self, curve: &Curve, tolerance: f64) -> Result<PolylineCurve> {
        let tree = MeshTree::new(self);
        let mut out: Vec<Point3> = Vec::new();
        for w in corners(curve, tolerance)?.windows(2) {
            let mut stack = vec![(w[0], tree.nearest(w[0])?, w[1], tree.nearest(w[1])?, 0)];
            while let Some((a, p, b, q, depth)) = stack.pop() {
                crate::cancellation::check()?;
                let m = a.lerp(b, 0.5);
                let r = tree.nearest(m)?;
                // A first halving shows steps that the middle alone would miss.
                if depth >= DEEPEST || (depth >= 3 && Line::new(p, q).distance_to(r) <= tolerance) {
                    out.extend([p, r, q]);
                } else {
                    stack.push((m, r, b, q, depth + 1));
                    stack.push((a, p, m, r, depth + 1));
                }
            }
        }
        let size = self.bounding_box().map_or(0.0, |b| b.diagonal().length());
        out.dedup_by(|b, a| a.distance_to(*b) <= thresholds::ROUNDING * size);
        PolylineCurve::new(without_straight(out, 0.01 * tolerance))
    }

    /// The polylines in which the lines through all points of a curve, along a direction and against it, meet the mesh:
    /// exactly for straight curves, for others within `tolerance`. Faces along the direction give nothing.
    ///
    /// Each straight piece of the curve makes a strip, which is cut with the triangles near it.
    ///
    /// # Errors
    /// A direction of length 0, or a tolerance that is not above 0.
    pub fn project_curve(&self, curve: &Curve, direction: Vector3, tolerance: f64) -> Result<Vec<Curve>> {
        let along = direction.unitized().ok_or(Error::degenerate("direction", "it has no length"))?;
        let size = self.bounding_box().map_or(0.0, |b| b.diagonal().length());
        let tree = MeshTree::new(self);
        let mut pieces: Vec<Curve> = Vec::new();
        for w in corners(curve, tolerance)?.windows(2) {
            crate::cancellation::check()?;
            let way = w[1] - w[0];
            let across = way - along * way.dot(along);
            let reach = across.length();
            let Some(x) = across.unitized() else { continue };
            let normal = along.cross(x);
            tree.near_strip(w[0], x, reach, normal, |triangle| {
                let flat = triangle.map(|p| [(p - w[0]).dot(x), (p - w[0]).dot(normal)]);
                let mut ends: Vec<(f64, Point3)> = Vec::with_capacity(3);
                for k in 0..3 {
                    let (i, j) = (k, (k + 1) % 3);
                    let (a, b) = (flat[i][1], flat[j][1]);
                    // 0 counts as above, so that an edge in the strip belongs to one of its two faces.
                    if (a >= 0.0) != (b >= 0.0) {
                        let s = a / (a - b);
                        let p = triangle[i].lerp(triangle[j], s);
                        ends.push((flat[i][0] + (flat[j][0] - flat[i][0]) * s, p));
                    }
                }
                let &[mut a, mut b] = ends.as_slice() else { return };
                if a.0 > b.0 {
                    std::mem::swap(&mut a, &mut b);
                }
                let (low, high) = (a.0.max(0.0), b.0.min(reach));
                if !(high - low > thresholds::ROUNDING * size) {
                    return;
                }
                let at = |s: f64| a.1.lerp(b.1, (s - a.0) / (b.0 - a.0));
                pieces.push(Line::new(at(low), at(high)).into());
            });
        }
        let joined = crate::join_curves(&pieces, thresholds::SAME_POINT * size, false);
        Ok(joined
            .into_iter()
            .map(|c| match c.as_polyline() {
                Some(points) => PolylineCurve::new(without_straight(points, thresholds::SAME_POINT * size))
                    .map_or(c, Into::into),
                None => c,
            })
            .collect())
    }
}

/// Corners that lie on the line between their neighbours are left out.
fn without_straight(points: Vec<Point3>, reach: f64) -> Vec<Point3> {
    let mut out: Vec<Point3> = Vec::with_capacity(points.len());
    for (i, &p) in points.iter().enumerate() {
        let straight = out
            .last()
            .zip(points.get(i + 1))
            .is_some_and(|(&a, &b)| (p - a).dot(b - p) >= 0.0 && Line::new(a, b).distance_to(p) <= reach);
        if !straight {
            out.push(p);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use crate::{Box3, Circle, Curve, Interval, Line, Mesh, Plane, Point3, Vector3};

    fn cube() -> Mesh {
        let side = Interval::new(0.0, 2.0);
        Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: side, z: side }, 3, 3, 3).unwrap()
    }

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    #[test]
    fn pulled_and_projected() {
        let over: Curve = Line::new(p(-1.0, 0.7, 4.0), p(5.0, 0.7, 4.0)).into();
        let down = cube().project_curve(&over, -Vector3::Z, 1e-3).unwrap();
        // The top and the bottom; the sides stand along the direction.
        let lengths: Vec<f64> = down.iter().map(Curve::length).collect();
        assert!(lengths.len() == 2 && lengths.iter().all(|l| (l - 2.0).abs() < 1e-9), "{lengths:?}");
        let slanted = cube().project_curve(&over, Vector3::new(1.0, 0.0, -1.0), 1e-3).unwrap();
        let total: f64 = slanted.iter().map(Curve::length).sum();
        // From (1, 2) on top over the edge to (2, 1) on the side.
        assert!((total - 2.0).abs() < 1e-9, "{slanted:?}");
        let circle: Curve = Circle::new(Plane::XY.with_origin(p(1.0, 1.0, 9.0)), 0.5).unwrap().into();
        let rings = cube().project_curve(&circle, Vector3::Z, 1e-4).unwrap();
        assert!(rings.len() == 2 && rings.iter().all(|r| r.is_closed()));
        assert!((rings[0].length() - std::f64::consts::PI).abs() < 1e-3);
        assert!(cube().project_curve(&circle, Vector3::ZERO, 1e-4).is_err());

        let pulled = cube().pull_curve(&over, 1e-4).unwrap();
        let pulled: Curve = pulled.into();
        assert!((pulled.length() - 2.0).abs() < 1e-2, "{}", pulled.length());
        assert!(Mesh::default().pull_curve(&over, 1e-4).is_err());
    }
}
