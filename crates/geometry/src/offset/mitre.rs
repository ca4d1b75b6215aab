//! The offset of a polygon with sharp corners, where no loop has to be removed.

use katydid_elementary::Elementary;

use super::simple::right_of;
use crate::curve::{Curve, PolylineCurve};
use crate::{Plane, Point2, Point3};

/// Sides are compared pair by pair: polygons of more go the general way.
const MOST_SIDES: usize = 64;
/// A corner that turns back by less than this, as 1 + cos of the turn, has a tip too far away to be judged.
const LEAST_TIP: f64 = 1e-6;

impl Curve {
    /// The offset of a simple polygon as the polygon of its offset sides, when that is simple too and every side keeps
    /// its direction; `None` when it is not, or when that cannot be told within `tolerance`.
    ///
    /// The lengths of the sides change linearly with the distance, so none has vanished on the way, and a corner that had
    /// passed another side would have left a crossing. What such a polygon encloses is the offset region: where the
    /// winding number of the offset of a boundary is positive (X. Chen and S. McMains, *Polygon offsetting by computing
    /// winding numbers*, ASME DETC 2005).
    pub(super) fn plain_mitre(&self, plane: &Plane, distance: f64, tolerance: f64) -> Option<Self> {
        let points =
            self.as_polyline().filter(|points| points.len() <= MOST_SIDES + 1 && self.is_closed())?;
        let n = points.len().checked_sub(1).filter(|n| *n >= 3)?;
        let side = |points: &[Point3], k: usize| points[(k + 1) % n] - points[k % n];
        let normals = (0..n).map(|k| right_of(side(&points, k), plane).ok()).collect::<Option<Vec<_>>>()?;
        let mut moved = Vec::with_capacity(n + 1);
        for k in 0..n {
            let (before, after) = (normals[(k + n - 1) % n], normals[k]);
            let tip = 1.0 + before.dot(after);
            if tip < LEAST_TIP {
                return None;
            }
            moved.push(points[k] + (before + after) * (distance / tip));
        }
        let kept = (0..n).all(|k| {
            let (old, new) = (side(&points, k), side(&moved, k));
            new.dot(old) > 0.0 && new.length() > tolerance && old.length() > tolerance
        });
        let flat = |points: &[Point3]| -> Vec<Point2> {
            let coordinates = |p: &Point3| plane.coordinates(*p);
            points.iter().take(n).map(coordinates).map(|[x, y, _]| Point2::new(x, y)).collect()
        };
        if !(kept && is_simple(&flat(&points), tolerance) && is_simple(&flat(&moved), tolerance)) {
            return None;
        }
        moved.push(moved[0]);
        let parameters = match self {
            Self::Polyline(c) if c.parameters().len() == moved.len() => Some(c.parameters().to_vec()),
            _ => None,
        };
        let made = match parameters {
            Some(parameters) => PolylineCurve::with_parameters(moved, parameters),
            None => PolylineCurve::new(moved),
        };
        made.ok().map(Self::from)
    }
}

/// Whether sides of a polygon that are not neighbours stay apart by more than a distance.
fn is_simple(corners: &[Point2], distance: f64) -> bool {
    let n = corners.len();
    let side = |k: usize| [corners[k % n], corners[(k + 1) % n]];
    (0..n).all(|i| {
        let last = if i == 0 { n - 1 } else { n };
        (i + 2..last).all(|j| are_apart(side(i), side(j), distance))
    })
}

fn are_apart(a: [Point2; 2], b: [Point2; 2], distance: f64) -> bool {
    let beyond = |of: fn(&Point2) -> f64| {
        let ([p, q], [r, s]) = (a.map(|p| of(&p)), b.map(|p| of(&p)));
        p.max(q) + distance < r.min(s) || r.max(s) + distance < p.min(q)
    };
    if beyond(|p| p.x) || beyond(|p| p.y) {
        return true;
    }
    let side = |[p, q]: [Point2; 2], r: Point2| (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    let parts = |line, ends: [Point2; 2]| side(line, ends[0]) * side(line, ends[1]) <= 0.0;
    if parts(a, b) && parts(b, a) {
        return false;
    }
    let far = |p: Point2, segment| distance_to(segment, p) > distance;
    a.iter().all(|p| far(*p, b)) && b.iter().all(|p| far(*p, a))
}

fn distance_to([a, b]: [Point2; 2], p: Point2) -> f64 {
    let (u, v) = ([b.x - a.x, b.y - a.y], [p.x - a.x, p.y - a.y]);
    let squared = u[0] * u[0] + u[1] * u[1];
    let t = if squared > 0.0 { ((u[0] * v[0] + u[1] * v[1]) / squared).clamp(0.0, 1.0) } else { 0.0 };
    (v[0] - t * u[0]).hypotenuse(v[1] - t * u[1])
}

#[cfg(test)]
mod tests {
    use crate::{Curve, OffsetCorner, Plane, Point3, PolylineCurve, Tolerance};

    fn polygon(corners: &[[f64; 2]]) -> Curve {
        let mut points: Vec<Point3> = corners.iter().map(|[x, y]| Point3::new(*x, *y, 0.0)).collect();
        points.extend(points.first().copied());
        PolylineCurve::new(points).unwrap().into()
    }

    fn area(curve: &Curve) -> f64 {
        curve.area_and_centroid(1e-3).unwrap().0
    }

    /// An L of two bars of width 2: as long as nothing vanishes the area is A + P·d + 4·d² (five corners turn out, one in,
    /// and a mitred right angle adds d²).
    #[test]
    fn areas_of_an_l() {
        let l = polygon(&[[0.0, 0.0], [6.0, 0.0], [6.0, 2.0], [2.0, 2.0], [2.0, 5.0], [0.0, 5.0]]);
        for d in [-0.9, -0.3, 0.2, 3.0] {
            let made = l.plain_mitre(&Plane::XY, d, 1e-6).unwrap();
            let wanted = 18.0 + 22.0 * d + 4.0 * d * d;
            assert!((area(&made) - wanted).abs() < 1e-9, "{d}: {}", area(&made));
        }
        // The bars vanish at half their width.
        assert!(l.plain_mitre(&Plane::XY, -1.0, 1e-6).is_none());
        assert!(l.plain_mitre(&Plane::XY, -1.5, 1e-6).is_none());
    }

    /// A dumbbell falls in two when its handle vanishes, and a slot closes: both are left to the general way.
    #[test]
    fn what_meets_itself_is_left() {
        let handle = [[0.0, 0.0], [4.0, 0.0], [4.0, 1.8], [8.0, 1.8], [8.0, 0.0], [12.0, 0.0], [12.0, 4.0]];
        let back = [[8.0, 4.0], [8.0, 2.2], [4.0, 2.2], [4.0, 4.0], [0.0, 4.0]];
        let dumbbell = polygon(&[&handle[..], &back[..]].concat());
        assert!(dumbbell.plain_mitre(&Plane::XY, -0.1, 1e-3).is_some());
        assert!(dumbbell.plain_mitre(&Plane::XY, -0.3, 1e-3).is_none());
        let both = dumbbell.offset(&Plane::XY, -0.3, OffsetCorner::Sharp, &Tolerance::default()).unwrap();
        assert_eq!(both.len(), 2);
        let slot =
            [[0.0, 0.0], [5.0, 0.0], [5.0, 4.0], [2.6, 4.0], [2.6, 1.0], [2.4, 1.0], [2.4, 4.0], [0.0, 4.0]];
        assert!(polygon(&slot).plain_mitre(&Plane::XY, 0.05, 1e-3).is_some());
        assert!(polygon(&slot).plain_mitre(&Plane::XY, 0.2, 1e-3).is_none());
        // A bow tie has no inside of its own.
        let tie = polygon(&[[0.0, 0.0], [2.0, 2.0], [2.0, 0.0], [0.0, 2.0]]);
        assert!(tie.plain_mitre(&Plane::XY, 0.1, 1e-3).is_none());
    }
}
