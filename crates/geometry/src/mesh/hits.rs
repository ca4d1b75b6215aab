//! Where lines pass through a mesh, what of it is nearest to a point, and where two meshes clash.

use crate::mesh::thresholds::{ALONG_FACE, FLAT_BOX};
use crate::thresholds;
use std::ops::ControlFlow;

use super::MeshTree;
use super::closest::{MeshPoint, closest_on_triangle};
use crate::{Error, Point3, Result, Vector3};

/// Where a line passes through a mesh.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshHit {
    /// The place on the line: start + t·direction.
    pub t: f64,
    /// The face.
    pub face: usize,
    /// The point.
    pub point: Point3,
}

/// The nearest points of two parts of meshes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshClash {
    /// The face of the first mesh.
    pub first: usize,
    /// The face of the second mesh.
    pub second: usize,
    /// The point halfway between the two faces, or one they share.
    pub point: Point3,
    /// How far the faces are apart: 0 where they meet.
    pub distance: f64,
}

type Triangle = [Point3; 3];

impl MeshTree {
    fn face(&self, i: usize) -> usize {
        self.faces.get(i).map_or(0, |&f| f as usize)
    }

    /// All places from `range[0]` to `range[1]` at which the line start + t·direction passes through the mesh, in
    /// order. Through an edge or a corner it passes once. Faces along the line do not count.
    ///
    /// The test is T. Möller's and B. Trumbore's (*Fast, minimum storage ray/triangle intersection*, 1997), with edges
    /// widened by 10⁻¹² so that lines do not slip between faces.
    ///
    /// # Errors
    /// The start or the direction is not finite.
    pub fn line_hits(&self, start: Point3, direction: Vector3, range: [f64; 2]) -> Result<Vec<MeshHit>> {
        if !(start.is_finite() && direction.is_finite()) {
            return Err(Error::NotFinite("line"));
        }
        let (origin, along): ([f64; 3], [f64; 3]) = (start.into(), [direction.x, direction.y, direction.z]);
        let mut hits: Vec<MeshHit> = Vec::new();
        let wanted = |bounds: &[[f64; 3]; 2]| {
            let (mut low, mut high) = (range[0], range[1]);
            for c in 0..3 {
                // Boxes of level faces have no height: give them some.
                let slack = FLAT_BOX * (bounds[0][c].abs() + bounds[1][c].abs() + origin[c].abs());
                let (a, b) = (bounds[0][c] - slack - origin[c], bounds[1][c] + slack - origin[c]);
                if along[c] == 0.0 {
                    if a > 0.0 || b < 0.0 {
                        return false;
                    }
                } else {
                    let (s, t) = (a / along[c], b / along[c]);
                    low = low.max(s.min(t));
                    high = high.min(s.max(t));
                }
            }
            low <= high * (1.0 + FLAT_BOX * high.signum()) || low - high <= FLAT_BOX
        };
        self.tree.visit_where(wanted, |i| {
            let t = self.triangles.get(i).and_then(|t| through_triangle(*t, start, direction));
            if let Some(t) = t.filter(|t| (range[0]..=range[1]).contains(t)) {
                hits.push(MeshHit { t, face: self.face(i), point: start + direction * t });
            }
            ControlFlow::Continue(())
        });
        hits.sort_by(|a, b| a.t.total_cmp(&b.t).then(a.face.cmp(&b.face)));
        let size = direction.length();
        hits.dedup_by(|b, a| {
            (b.t - a.t) * size <= thresholds::SAME_POINT * (1.0 + a.point.to_vector().length())
        });
        Ok(hits)
    }

    /// The point of the mesh nearest to `q`.
    ///
    /// # Errors
    /// `q` is not finite, or the mesh has no faces.
    pub fn nearest(&self, q: Point3) -> Result<Point3> {
        Ok(self.closest(q)?.point)
    }

    /// The point of the mesh nearest to `q` with its face, as [`super::Mesh::closest_point`] gives it; of equally near ones
    /// that on the first face.
    ///
    /// # Errors
    /// `q` is not finite, or the mesh has no faces.
    pub fn closest(&self, q: Point3) -> Result<MeshPoint> {
        if !q.is_finite() {
            return Err(Error::NotFinite("point to project on the mesh"));
        }
        let mut best: Option<(f64, usize, Point3, [f64; 3])> = None;
        self.tree.visit_near(&q.into(), f64::INFINITY, |i| {
            if let Some(&triangle) = self.triangles.get(i) {
                let (p, weights) = closest_on_triangle(triangle, q);
                let distance = p.distance_to(q);
                if best.is_none_or(|(b, first, ..)| distance < b || (distance == b && i < first)) {
                    best = Some((distance, i, p, weights));
                }
            }
            // A little more than the square, so that triangles as near as the best one are looked at too.
            best.map_or(f64::INFINITY, |(b, ..)| (b * b * (1.0 + 8.0 * f64::EPSILON)).next_up())
        });
        let (distance, i, point, [a, b, c]) = best.ok_or(Error::degenerate("mesh", "it has no faces"))?;
        let face = self.faces.get(i).copied().unwrap_or(0);
        // The second triangle of a quad has its corners 0, 2 and 3.
        let second = i > 0 && self.faces.get(i - 1) == Some(&face);
        let weights = if second { [a, 0.0, b, c] } else { [a, b, c, 0.0] };
        Ok(MeshPoint { face: face as usize, weights, point, distance })
    }

    /// Visits the triangles that may meet a strip without end: from `start` for `reach` along `x`, and across `normal` no
    /// width.
    pub(super) fn near_strip(
        &self,
        start: Point3,
        x: Vector3,
        reach: f64,
        normal: Vector3,
        mut visit: impl FnMut([Point3; 3]),
    ) {
        let extent = |bounds: &[[f64; 3]; 2], d: Vector3| {
            let (d, o): ([f64; 3], [f64; 3]) = ([d.x, d.y, d.z], start.into());
            (0..3).fold([0.0, 0.0], |[low, high], c| {
                let (a, b) = ((bounds[0][c] - o[c]) * d[c], (bounds[1][c] - o[c]) * d[c]);
                [low + a.min(b), high + a.max(b)]
            })
        };
        let wanted = |bounds: &[[f64; 3]; 2]| {
            let ([low, high], [below, above]) = (extent(bounds, x), extent(bounds, normal));
            let slack = FLAT_BOX * (high - low).abs().max(above - below).max(reach);
            low <= reach + slack && high >= -slack && below <= slack && above >= -slack
        };
        self.tree.visit_where(wanted, |i| {
            if let Some(&triangle) = self.triangles.get(i) {
                visit(triangle);
            }
            ControlFlow::Continue(())
        });
    }

    /// Whether two meshes come within `reach` of each other anywhere.
    pub fn meets(&self, other: &Self, reach: f64) -> bool {
        !self.clashes(other, reach, 1).is_empty()
    }

    /// Pairs of faces of two meshes that come within `reach` of each other, `most` of them at most, in no particular
    /// order. A face and another meet where an edge of one passes through the other; else the distance is that of their
    /// edges and corners. A mesh inside another meets it nowhere.
    pub fn clashes(&self, other: &Self, reach: f64, most: usize) -> Vec<MeshClash> {
        let mut found = Vec::new();
        if most == 0 {
            return found;
        }
        let reach = reach.max(0.0);
        self.tree.visit_pairs(&other.tree, reach, |i, j| {
            if let (Some(&a), Some(&b)) = (self.triangles.get(i), other.triangles.get(j)) {
                let (p, q) = nearest_of_triangles(a, b);
                let distance = p.distance_to(q);
                if distance <= reach {
                    let point = p.lerp(q, 0.5);
                    found.push(MeshClash { first: self.face(i), second: other.face(j), point, distance });
                }
            }
            if found.len() < most { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        });
        found
    }
}

/// Where a line passes through a triangle, edges included.
fn through_triangle([a, b, c]: Triangle, p: Point3, direction: Vector3) -> Option<f64> {
    const EDGE: f64 = -1e-12;
    let (ab, ac) = (b - a, c - a);
    let h = direction.cross(ac);
    let det = ab.dot(h);
    // Along the face, to rounding.
    if det.abs() <= ALONG_FACE * ab.length() * ac.length() * direction.length() {
        return None;
    }
    let s = p - a;
    let u = s.dot(h) / det;
    let q = s.cross(ab);
    let v = direction.dot(q) / det;
    (u >= EDGE && v >= EDGE && u + v <= 1.0 - EDGE).then(|| ac.dot(q) / det)
}

fn edges([a, b, c]: Triangle) -> [(Point3, Point3); 3] {
    [(a, b), (b, c), (c, a)]
}

/// The nearest points of two triangles: a common one, or the nearest of edge and edge and of corner and face.
fn nearest_of_triangles(a: Triangle, b: Triangle) -> (Point3, Point3) {
    for (one, other) in [(a, b), (b, a)] {
        for (p, q) in edges(one) {
            if let Some(t) = through_triangle(other, p, q - p).filter(|t| (0.0..=1.0).contains(t)) {
                let x = p.lerp(q, t);
                return (x, x);
            }
        }
    }
    let mut best = (f64::INFINITY, a[0], b[0]);
    let mut offer = |p: Point3, q: Point3| {
        let squared = (p - q).length_squared();
        if squared < best.0 {
            best = (squared, p, q);
        }
    };
    for p in a {
        offer(p, closest_on_triangle(b, p).0);
    }
    for q in b {
        offer(closest_on_triangle(a, q).0, q);
    }
    for (p, q) in edges(a) {
        for (r, s) in edges(b) {
            let (x, y) = nearest_of_segments((p, q), (r, s));
            offer(x, y);
        }
    }
    (best.1, best.2)
}

/// The nearest points of two segments (C. Ericson, *Real-Time Collision Detection*, 2005, §5.1.9).
fn nearest_of_segments((p, q): (Point3, Point3), (r, s): (Point3, Point3)) -> (Point3, Point3) {
    let (u, v, w) = (q - p, s - r, p - r);
    let (a, e, f) = (u.length_squared(), v.length_squared(), v.dot(w));
    let (c, b) = (u.dot(w), u.dot(v));
    let share = |x: f64| if x.is_finite() { x.clamp(0.0, 1.0) } else { 0.0 };
    let determinant = a * e - b * b;
    let mut x = if determinant > ALONG_FACE * a * e { share((b * f - c * e) / determinant) } else { 0.0 };
    let y = share((b * x + f) / e);
    x = share((b * y - c) / a);
    (p + u * x, r + v * y)
}

#[cfg(test)]
mod tests {
    use super::MeshTree;
    use crate::{Box3, Interval, Mesh, Plane, Point3, Vector3};

    fn cube(x: f64) -> Mesh {
        let unit = Interval::new(0.0, 1.0);
        let side = Interval::new(x, x + 1.0);
        Mesh::cuboid(&Box3 { plane: Plane::XY, x: side, y: unit, z: unit }, 4, 4, 4).unwrap()
    }

    const ALL: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];

    #[test]
    fn lines_pass_once() {
        let tree = MeshTree::new(&cube(0.0));
        // Through faces, through edges and corners of faces, and outside.
        for (y, z) in [(0.3, 0.4), (0.25, 0.25), (0.5, 0.1), (0.125, 0.125)] {
            let hits = tree.line_hits(Point3::new(-1.0, y, z), Vector3::X, ALL).unwrap();
            let t: Vec<f64> = hits.iter().map(|h| h.t).collect();
            assert_eq!(t.len(), 2, "{y} {z}");
            assert!((t[0] - 1.0).abs() < 1e-12 && (t[1] - 2.0).abs() < 1e-12);
        }
        assert!(tree.line_hits(Point3::new(-1.0, 2.0, 0.0), Vector3::X, ALL).unwrap().is_empty());
        let short = tree.line_hits(Point3::new(-1.0, 0.3, 0.4), Vector3::X, [0.0, 1.5]).unwrap();
        assert_eq!(short.len(), 1);
        let through =
            tree.line_hits(Point3::new(-1.0, -1.0, -1.0), Vector3::new(1.0, 1.0, 1.0), ALL).unwrap();
        assert_eq!(through.len(), 2);
        assert!(tree.line_hits(Point3::new(f64::NAN, 0.0, 0.0), Vector3::X, ALL).is_err());
        assert!(
            MeshTree::new(&Mesh::default()).line_hits(Point3::ORIGIN, Vector3::X, ALL).unwrap().is_empty()
        );
    }

    #[test]
    fn nearest_points() {
        let mesh = cube(0.0);
        let tree = MeshTree::new(&mesh);
        for k in 0..200 {
            let k = f64::from(k);
            let q = Point3::new(3.0 * (k * 1.3).sin(), 3.0 * (k * 0.7).cos(), 3.0 * (k * 2.1).sin());
            let want = mesh.closest_point(q).unwrap().distance;
            assert!((tree.nearest(q).unwrap().distance_to(q) - want).abs() < 1e-12);
        }
        assert!(MeshTree::new(&Mesh::default()).nearest(Point3::ORIGIN).is_err());
    }

    /// The same face and weights as by looking at every face, also where many faces are equally near.
    #[test]
    fn nearest_faces_are_those_of_a_search_through_all() {
        let ball = Mesh::sphere(&Plane::XY, 2.0, 16, 8).unwrap();
        for mesh in [cube(0.0), ball] {
            let tree = MeshTree::new(&mesh);
            let places = (0..300).map(f64::from).map(|k| {
                // On a coarse lattice, so that edges and middles are met exactly.
                [1.3, 0.7, 2.1].map(|x| (6.0 * (k * x).sin()).round() / 2.0)
            });
            for q in places.map(Point3::from).chain([Point3::ORIGIN, Point3::new(0.5, 0.5, 0.5)]) {
                assert_eq!(tree.closest(q).unwrap(), mesh.closest_point(q).unwrap(), "{q:?}");
            }
        }
    }

    #[test]
    fn meshes_meet() {
        let (a, b, c) = (MeshTree::new(&cube(0.0)), MeshTree::new(&cube(0.5)), MeshTree::new(&cube(1.25)));
        assert!(a.meets(&b, 0.0) && !a.meets(&c, 0.0) && !a.meets(&c, 0.2) && a.meets(&c, 0.25));
        let near = a.clashes(&c, 0.3, 10_000);
        assert!(near.iter().all(|n| (n.distance - 0.25).abs() < 1e-12 || n.distance <= 0.3));
        assert!(near.iter().any(|n| (n.distance - 0.25).abs() < 1e-12));
        assert_eq!(a.clashes(&c, 0.3, 3).len(), 3);
        assert!(a.clashes(&b, 0.0, 0).is_empty());
    }
}
