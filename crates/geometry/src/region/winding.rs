//! How often closed curves run around a point.

use std::ops::ControlFlow;

use crate::bernstein::{BUDGET, halves};
use crate::box_tree::{Bounds, BoxTree};
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
    /// The boxes of the pieces, where there are many.
    tree: Option<BoxTree>,
}

/// With more pieces than this an outline has a tree of them.
const MANY: usize = 24;
/// Boxes are wider by this part of the coordinates: what lies outside is proved to be there whatever the rounding.
const WIDER: f64 = 1e-12;

fn boxed([low, high]: [[f64; 2]; 2]) -> Bounds {
    let size = low.iter().chain(&high).fold(0.0_f64, |m, x| m.max(x.abs()));
    let margin = WIDER * size;
    [[low[0] - margin, low[1] - margin, 0.0], [high[0] + margin, high[1] + margin, 0.0]]
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
        let boxes: Vec<[[f64; 2]; 2]> = pieces.iter().map(|piece| bounds_of(piece)).collect();
        let bounds = boxes.iter().fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |all, own| {
            [[0, 1].map(|c| all[0][c].min(own[0][c])), [0, 1].map(|c| all[1][c].max(own[1][c]))]
        });
        let tree = (pieces.len() > MANY)
            .then(|| BoxTree::in_order(&boxes.into_iter().map(boxed).collect::<Vec<_>>()));
        Self { pieces, bounds, tree }
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
        let Some(tree) = &self.tree else {
            return self.pieces.iter().map(|piece| crossings(piece, p)).sum();
        };
        let mut sum = 0;
        // Pieces that lie above, below or left of the point do not cross the ray.
        tree.visit_where(
            |b| b[0][1] <= p[1] && p[1] <= b[1][1] && p[0] <= b[1][0],
            |i| {
                sum += self.pieces.get(i).map_or(0, |piece| crossings(piece, p));
                ControlFlow::Continue(())
            },
        );
        sum
    }
}

/// The box of a piece's control points.
fn bounds_of(piece: &[[f64; 3]]) -> [[f64; 2]; 2] {
    let mut bounds = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for &[x, y, w] in piece {
        for (c, value) in [x / w, y / w].into_iter().enumerate() {
            bounds[0][c] = bounds[0][c].min(value);
            bounds[1][c] = bounds[1][c].max(value);
        }
    }
    bounds
}

/// The boxes of many outlines, in a tree.
#[derive(Debug)]
pub(super) struct OutlineIndex {
    /// The place of each in the list.
    of: Vec<usize>,
    tree: BoxTree,
}

impl OutlineIndex {
    /// Of a list some of whose members have outlines.
    pub(super) fn new<'a>(outlines: impl Iterator<Item = Option<&'a Outline>>) -> Self {
        let (of, boxes): (Vec<usize>, Vec<Bounds>) =
            outlines.enumerate().filter_map(|(k, own)| Some((k, boxed(own?.bounds)))).unzip();
        Self { of, tree: BoxTree::by_place(&boxes) }
    }

    /// The places of those whose boxes hold one of some points, in order.
    pub(super) fn reaching(&self, points: &[[f64; 2]]) -> Vec<usize> {
        let holds = |b: &Bounds, p: &[f64; 2]| (0..2).all(|c| b[0][c] <= p[c] && p[c] <= b[1][c]);
        let mut out = Vec::new();
        self.tree.visit_where(
            |b| points.iter().any(|p| holds(b, p)),
            |i| {
                out.extend(self.of.get(i));
                ControlFlow::Continue(())
            },
        );
        out.sort_unstable();
        out
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

    #[test]
    fn many_pieces_count_as_one_by_one() {
        // A wave around the origin, and a level side that a ray runs along.
        let mut points: Vec<Point3> = (0..=200)
            .map(|k| {
                let angle = 1.5 * std::f64::consts::PI * f64::from(k) / 200.0;
                let radius = 2.0 + 0.7 * (17.0 * angle).sin();
                Point3::new(radius * angle.cos(), radius * angle.sin(), 0.0)
            })
            .collect();
        points.extend([Point3::new(1.5, -3.0, 0.0), Point3::new(1.5, -1.0, 0.0), points[0]]);
        let outline = Outline::new(&PolylineCurve::new(points).unwrap().into(), &Plane::XY);
        let plain = Outline { tree: None, ..outline.clone() };
        assert!(outline.tree.is_some());
        let mut inside = 0;
        for (i, j) in (-35..35).flat_map(|i| (-35..35).map(move |j| (i, j))) {
            let p = [f64::from(i) * 0.1, f64::from(j) * 0.1];
            assert_eq!(outline.winding(p), plain.winding(p), "{p:?}");
            inside += outline.winding(p);
        }
        assert!(inside > 700);
    }
}
