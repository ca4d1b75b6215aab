//! How often closed curves run around a point.

use crate::bernstein::{BUDGET, halves};
use crate::{Curve, Plane, Point3};

/// A closed curve prepared for questions about winding: its Bézier pieces in coordinates of the plane, each starting
/// exactly where the one before ends, so that the count of crossings with a ray is a whole number that no rounding
/// can spoil.
#[derive(Debug, Clone)]
pub(crate) struct Outline {
    /// Homogeneous plane coordinates (x, y, w).
    pieces: Vec<Vec<[f64; 3]>>,
    /// The box of the control points: least and greatest coordinates.
    bounds: [[f64; 2]; 2],
}

impl Outline {
    /// Prepares a curve that lies in the plane. A gap between its ends is closed by moving the start.
    pub(crate) fn new(curve: &Curve, plane: &Plane) -> Self {
        let mut pieces: Vec<Vec<[f64; 3]>> = Vec::new();
        for piece in curve.pieces() {
            for bezier in piece.beziers() {
                let flat = bezier.iter().map(|&[x, y, z, w]| {
                    let v = crate::Vector3::new(x, y, z) - plane.origin.to_vector() * w;
                    [v.dot(plane.x_axis), v.dot(plane.y_axis), w]
                });
                pieces.push(flat.collect());
            }
        }
        let mut before = pieces.last().and_then(|p| p.last().copied());
        for piece in &mut pieces {
            if let (Some([x, y, w]), Some(first)) = (before, piece.first_mut()) {
                *first = [x / w * first[2], y / w * first[2], first[2]];
            }
            before = piece.last().copied();
        }
        // The last step closes the round: what the first piece took over is what the last one has.
        let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for &[x, y, w] in pieces.iter().flatten() {
            for (c, value) in [x / w, y / w].into_iter().enumerate() {
                bounds[0][c] = bounds[0][c].min(value);
                bounds[1][c] = bounds[1][c].max(value);
            }
        }
        Self { pieces, bounds }
    }

    /// Whether the point lies in the box of the control points; outside it the winding number is 0.
    pub(crate) fn reaches(&self, [x, y]: [f64; 2]) -> bool {
        self.bounds[0][0] <= x && x <= self.bounds[1][0] && self.bounds[0][1] <= y && y <= self.bounds[1][1]
    }

    /// How often the curve runs counter-clockwise around a point of the plane that is not on it: signed crossings
    /// with the ray along x.
    pub(crate) fn winding(&self, p: [f64; 2]) -> i32 {
        if !self.reaches(p) {
            return 0;
        }
        self.pieces.iter().map(|piece| crossings(piece, p)).sum()
    }
}

/// The coordinates of a point in a plane that holds it.
pub(super) fn flat(plane: &Plane, p: Point3) -> [f64; 2] {
    let [x, y, _] = plane.coordinates(p);
    [x, y]
}

/// What control points about the origin prove: the count of crossings with the positive x axis, or nothing.
fn proved(points: impl Iterator<Item = [f64; 2]> + Clone) -> Option<i32> {
    let (mut above, mut below, mut right, mut left) = (true, true, true, true);
    let (mut first, mut last) = (None, false);
    for [x, y] in points {
        let up = y >= 0.0;
        first.get_or_insert(up);
        last = up;
        above &= up;
        below &= !up;
        right &= x > 0.0;
        left &= x <= 0.0;
    }
    if above || below || left {
        return Some(0);
    }
    right.then(|| i32::from(last) - i32::from(first.unwrap_or(last)))
}

/// Upward less downward crossings of a Bézier curve with the ray from `p` along x.
fn crossings(piece: &[[f64; 3]], [px, py]: [f64; 2]) -> i32 {
    let about = piece.iter().map(|&[x, y, w]| [x - w * px, y - w * py]);
    if let Some(count) = proved(about.clone()) {
        return count;
    }
    let mut stack = vec![(about.collect::<Vec<_>>(), 0_u32)];
    let (mut sum, mut budget) = (0, BUDGET);
    while let Some((points, depth)) = stack.pop() {
        budget = budget.saturating_sub(1);
        if let Some(count) = proved(points.iter().copied()) {
            sum += count;
        } else if points.len() == 2 || depth >= 60 || budget == 0 {
            if let (Some(a), Some(b)) = (points.first(), points.last()) {
                let count = i32::from(b[1] >= 0.0) - i32::from(a[1] >= 0.0);
                if (a[0] * b[1] - b[0] * a[1]) * f64::from(count) > 0.0 {
                    sum += count;
                }
            }
        } else {
            let (left, right) = halves(&points);
            stack.push((right, depth + 1));
            stack.push((left, depth + 1));
        }
    }
    sum
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a failing assertion is how a test reports")]
    use super::Outline;
    use crate::{Circle, Curve, Plane, Point3, PolylineCurve};

    #[test]
    fn turns_of_circles_and_stars() {
        let circle: Curve = Circle::new(Plane::XY, 1.0).unwrap().into();
        let around = Outline::new(&circle, &Plane::XY);
        for (p, want) in
            [([0.0, 0.0], 1), ([0.999, 0.0], 1), ([1.001, 0.0], 0), ([-0.7, 0.7], 1), ([0.8, 0.8], 0)]
        {
            assert_eq!(around.winding(p), want, "{p:?}");
        }
        assert_eq!(Outline::new(&circle.reversed(), &Plane::XY).winding([0.1, 0.0]), -1);
        // A five-pointed star runs twice around its middle, and heights of its vertices are no exception.
        let vertex = |k: i32| {
            let angle = std::f64::consts::TAU * 0.4 * f64::from(k % 5);
            Point3::new(angle.cos(), angle.sin(), 0.0)
        };
        let star: Curve = PolylineCurve::new((0..6).map(vertex).collect()).unwrap().into();
        let star = Outline::new(&star, &Plane::XY);
        assert_eq!(star.winding([0.0, 0.0]), 2);
        assert_eq!(star.winding([0.0, vertex(1).y]), 0);
        assert_eq!(star.winding([0.9, 0.0]), 1);
    }
}
