//! Where a curve comes nearest to another curve, or to anything that can tell its nearest point.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::curve_curve::check;
use super::search::NOISE;
use super::thresholds::ROUNDED;
use super::tree::{Node, Tree};
use crate::curve::Piece;
use crate::{Curve, Point3, Result, Vector3};

/// A search that looks at more parts than this is lost between shapes that are equally far apart almost everywhere.
const MOST: u32 = 300_000;

/// The nearest points of two shapes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NearestPair {
    /// The parameter on the curve, or on the first of two.
    pub a: f64,
    /// The parameter on the second curve; 0 where the second shape is no curve.
    pub b: f64,
    /// The point on the curve, or on the first of two.
    pub point_a: Point3,
    /// The point on the other shape.
    pub point_b: Point3,
    /// How far they are apart.
    pub distance: f64,
}

/// Parts still to be looked at, the most promising first.
#[derive(Debug, Clone, Copy)]
struct Waiting {
    /// No points of the parts are nearer than this.
    bound: f64,
    parts: (u32, u32),
}

impl PartialEq for Waiting {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Waiting {}

impl PartialOrd for Waiting {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Waiting {
    fn cmp(&self, other: &Self) -> Ordering {
        other.bound.total_cmp(&self.bound).then(other.parts.cmp(&self.parts))
    }
}

fn box_distance(a: &Node, b: &Node) -> f64 {
    (0..3).map(|k| (a.min[k] - b.max[k]).max(b.min[k] - a.max[k]).max(0.0).powi(2)).sum::<f64>().sqrt()
}

/// The gap between two hulls along a direction: no points of them are nearer.
fn gap_along(a: &[Vector3], b: &[Vector3], direction: Vector3) -> f64 {
    let Some(d) = direction.unitized() else { return 0.0 };
    let low = a.iter().map(|p| p.dot(d)).fold(f64::INFINITY, f64::min);
    low - b.iter().map(|p| p.dot(d)).fold(f64::NEG_INFINITY, f64::max)
}

/// The nearest points of two curves: no others are nearer by more than `tolerance`, unless the search, which looks at
/// no more than 300,000 pairs of parts, was stopped by curves that are equally far apart almost everywhere.
///
/// Branch and bound, the most promising pair of parts first: a pair is discarded when the hulls of control points are
/// far enough apart, in boxes or along the direction between the nearest points of the two parts that damped
/// Gauss–Newton steps find. Where curves come near at an angle to all others, and where they run beside each other,
/// that bound is exact to second order. The result is polished to rounding.
///
/// # Errors
/// The tolerance is negative or not finite.
pub fn nearest_on_curves(a: &Curve, b: &Curve, tolerance: f64) -> Result<NearestPair> {
    check(tolerance)?;
    let (mut first, mut second) = (Tree::new(a.pieces()), Tree::new(b.pieces()));
    let tolerance = tolerance.max(NOISE * first.scale.max(second.scale));
    let ends = |s: f64, t: f64| {
        let (p, q) = (a.point_at(s), b.point_at(t));
        NearestPair { a: s, b: t, point_a: p, point_b: q, distance: p.distance_to(q) }
    };
    let mut best = ends(a.domain().start, b.domain().start);
    let mut heap = BinaryHeap::from([Waiting { bound: 0.0, parts: (first.root, second.root) }]);
    let mut budget = MOST;
    while let Some(Waiting { bound, parts: (ia, ib) }) = heap.pop() {
        if !(bound < best.distance - tolerance) || best.distance <= tolerance || budget == 0 {
            break;
        }
        budget -= 1;
        let (m, n) = (first.nodes[ia as usize], second.nodes[ib as usize]);
        let mut bound = bound;
        if let (Some(pa), Some(pb)) = (m.piece(), n.piece()) {
            let (pa, pb) = (first.pieces[pa], second.pieces[pb]);
            let [s, t] = settle(&pa, [m.from, m.to], &pb, [n.from, n.to]);
            let (p, q) = (pa.point(s), pb.point(t));
            let distance = p.distance_to(q);
            if distance < best.distance {
                let (s, t) = (pa.whole_parameter(s), pb.whole_parameter(t));
                best = NearestPair { a: s, b: t, point_a: p, point_b: q, distance };
            }
            bound = bound.max(gap_along(first.hull(&m), second.hull(&n), p - q));
            if !(bound < best.distance - tolerance) {
                continue;
            }
        }
        let open_a = match (m.piece().is_some(), n.piece().is_some()) {
            (false, true) => true,
            (true, false) => false,
            _ => m.size_squared() >= n.size_squared(),
        };
        let children = if open_a { first.children(ia) } else { second.children(ib) };
        let Some((l, r)) = children else { continue };
        for child in [l, r] {
            let parts = if open_a { (child, ib) } else { (ia, child) };
            let bound =
                bound.max(box_distance(&first.nodes[parts.0 as usize], &second.nodes[parts.1 as usize]));
            if bound < best.distance - tolerance {
                heap.push(Waiting { bound, parts });
            }
        }
    }
    Ok(best)
}

/// Parameters of two parts at which they are nearest, as far as a few steps from the middle show.
fn settle(a: &Piece<'_>, ra: [f64; 2], b: &Piece<'_>, rb: [f64; 2]) -> [f64; 2] {
    let clamp = |x: f64, r: [f64; 2]| x.clamp(r[0].min(r[1]), r[0].max(r[1]));
    let mut x = [0.5 * (ra[0] + ra[1]), 0.5 * (rb[0] + rb[1])];
    let miss = |x: [f64; 2]| (a.point(x[0]) - b.point(x[1])).length_squared();
    let mut here = miss(x);
    for _ in 0..12 {
        let ([p, u, _], [q, v, _]) = (a.jet(x[0]), b.jet(x[1]));
        let d = p - q;
        let (e, f, g) = (u.length_squared(), -u.dot(v), v.length_squared());
        let (r, s) = (-d.dot(u), d.dot(v));
        // A little damping settles parallel directions.
        let (e, g) = (e * (1.0 + ROUNDED), g * (1.0 + ROUNDED));
        let determinant = e * g - f * f;
        let mut next = [
            clamp(x[0] + (r * g - s * f) / determinant, ra),
            clamp(x[1] + (s * e - r * f) / determinant, rb),
        ];
        if !next.iter().all(|x| x.is_finite()) {
            break;
        }
        // At an end of one part the other goes on alone.
        if next[0] == ra[0] || next[0] == ra[1] {
            next[1] = clamp(x[1] + (s - f * (next[0] - x[0])) / g, rb);
        } else if next[1] == rb[0] || next[1] == rb[1] {
            next[0] = clamp(x[0] + (r - f * (next[1] - x[1])) / e, ra);
        }
        let there = miss(next);
        if !(there <= here) || next == x {
            break;
        }
        (x, here) = (next, there);
    }
    x
}

/// The point of a curve nearest to a shape that tells, by `nearest`, its point nearest to any given one: no point of
/// the curve is nearer by more than `tolerance`, if the search comes to its end (300,000 questions).
///
/// A part of the curve within r of a point is no nearer than the point's own distance less r; the most promising part
/// is halved until nothing better is left. Then point and shape are pulled to each other in turn.
///
/// # Errors
/// The tolerance is negative or not finite, or the first error of `nearest`.
pub fn nearest_to_shape(
    curve: &Curve,
    tolerance: f64,
    mut nearest: impl FnMut(Point3) -> Result<Point3>,
) -> Result<NearestPair> {
    check(tolerance)?;
    let mut tree = Tree::new(curve.pieces());
    let tolerance = tolerance.max(NOISE * tree.scale);
    let start = curve.start();
    let q = nearest(start)?;
    let at = curve.domain().start;
    let mut best = NearestPair { a: at, b: 0.0, point_a: start, point_b: q, distance: start.distance_to(q) };
    let mut heap = BinaryHeap::from([Waiting { bound: 0.0, parts: (tree.root, 0) }]);
    let mut budget = MOST;
    while let Some(Waiting { bound, parts: (i, _) }) = heap.pop() {
        if !(bound < best.distance - tolerance) || best.distance <= tolerance || budget == 0 {
            break;
        }
        budget -= 1;
        let node = tree.nodes[i as usize];
        let (center, radius) = match node.piece() {
            Some(k) => {
                let piece = tree.pieces[k];
                let t = 0.5 * (node.from + node.to);
                let p = piece.point(t);
                let q = nearest(p)?;
                let distance = p.distance_to(q);
                if distance < best.distance {
                    best =
                        NearestPair { a: piece.whole_parameter(t), b: 0.0, point_a: p, point_b: q, distance };
                }
                let hull = tree.hull(&node).iter();
                (distance, hull.map(|h| (*h - p.to_vector()).length()).fold(0.0, f64::max))
            }
            None => {
                let [low, high] = [node.min, node.max].map(Point3::from);
                let p = low.lerp(high, 0.5);
                (p.distance_to(nearest(p)?), p.distance_to(high))
            }
        };
        let bound = bound.max(center - radius);
        if !(bound < best.distance - tolerance) {
            continue;
        }
        if let Some((l, r)) = tree.children(i) {
            heap.extend([l, r].map(|child| Waiting { bound, parts: (child, 0) }));
        }
    }
    for _ in 0..40 {
        let on_curve = curve.closest_point(best.point_b)?;
        let q = nearest(on_curve.point)?;
        let distance = on_curve.point.distance_to(q);
        if !(distance < best.distance) {
            break;
        }
        best = NearestPair { a: on_curve.parameter, b: 0.0, point_a: on_curve.point, point_b: q, distance };
    }
    Ok(best)
}

#[cfg(test)]
mod tests {
    use super::{nearest_on_curves, nearest_to_shape};
    use crate::{Circle, Curve, Line, NurbsCurve, Plane, Point3, PolylineCurve, Sphere, Surface};

    fn p(x: f64, y: f64, z: f64) -> Point3 {
        Point3::new(x, y, z)
    }

    fn line(a: Point3, b: Point3) -> Curve {
        Line::new(a, b).into()
    }

    fn wave(seed: f64, lift: f64) -> Curve {
        let points: Vec<Point3> = (0..12)
            .map(f64::from)
            .map(|i| p(i, 3.0 * (i * 1.7 + seed).sin(), lift + (i * 0.9 + seed).cos()))
            .collect();
        NurbsCurve::clamped_uniform(3, &points).unwrap().into()
    }

    #[test]
    fn closed_forms() {
        let skew = nearest_on_curves(
            &line(p(-5.0, 0.0, 0.0), p(5.0, 0.0, 0.0)),
            &line(p(1.0, -4.0, 2.0), p(1.0, 4.0, 2.0)),
            1e-9,
        );
        let skew = skew.unwrap();
        assert!(skew.point_a.distance_to(p(1.0, 0.0, 0.0)) < 1e-7 && (skew.distance - 2.0).abs() < 1e-12);
        let circle = |x: f64, r: f64| -> Curve {
            Circle { plane: Plane::XY.with_origin(p(x, 0.0, 0.0)), radius: r }.into()
        };
        let apart = nearest_on_curves(&circle(0.0, 2.0), &circle(9.0, 3.0), 1e-9).unwrap();
        assert!((apart.distance - 4.0).abs() < 1e-9, "{apart:?}");
        assert!(apart.point_b.distance_to(p(6.0, 0.0, 0.0)) < 1e-6);
        // Everywhere equally far, or in one place.
        let around = nearest_on_curves(&circle(0.0, 2.0), &circle(0.0, 3.0), 1e-3).unwrap();
        assert!((around.distance - 1.0).abs() < 1e-3);
        let beside = nearest_on_curves(
            &line(p(0.0, 0.0, 0.0), p(9.0, 0.0, 0.0)),
            &line(p(20.0, 1.0, 0.0), p(3.0, 1.0, 0.0)),
            1e-9,
        );
        assert!((beside.unwrap().distance - 1.0).abs() < 1e-12);
        let cross = nearest_on_curves(&circle(0.0, 2.0), &circle(3.0, 2.0), 1e-9).unwrap();
        assert!(cross.distance < 1e-9);
        assert!(nearest_on_curves(&circle(0.0, 2.0), &circle(3.0, 2.0), f64::NAN).is_err());
    }

    #[test]
    fn as_near_as_any_samples() {
        for k in 0..20 {
            let (a, b) = (wave(f64::from(k), 0.0), wave(2.0 * f64::from(k) + 1.0, 4.0));
            let found = nearest_on_curves(&a, &b, 1e-9).unwrap();
            assert!(a.point_at(found.a).distance_to(found.point_a) < 1e-9);
            assert!((found.point_a.distance_to(found.point_b) - found.distance).abs() < 1e-12);
            let sampled = (0..=400)
                .map(|i| a.point_at(a.domain().at(f64::from(i) / 400.0)))
                .map(|q| b.closest_point(q).unwrap().distance)
                .fold(f64::INFINITY, f64::min);
            assert!(found.distance <= sampled + 1e-9 && found.distance > sampled - 0.02, "{k}");
            let shape = nearest_to_shape(&a, 1e-6, |q| Ok(b.closest_point(q)?.point)).unwrap();
            assert!((shape.distance - found.distance).abs() < 1e-6, "{k}");
        }
    }

    #[test]
    fn many_segments_and_surfaces() {
        let zigzag = |y: f64| -> Curve {
            let points = (0..2000).map(|i| p(f64::from(i), y + f64::from(i % 2), 0.0)).collect();
            PolylineCurve::new(points).unwrap().into()
        };
        let found = nearest_on_curves(&zigzag(0.0), &zigzag(5.0), 1e-6).unwrap();
        assert!((found.distance - 4.0).abs() < 0.8);
        let ball: Surface = Sphere::around(Point3::ORIGIN, 2.0).unwrap().into();
        let near = nearest_to_shape(&line(p(-9.0, 3.0, 0.0), p(9.0, 3.0, 0.0)), 1e-6, |q| {
            Ok(ball.closest_point(q)?.point)
        });
        let near = near.unwrap();
        assert!((near.distance - 1.0).abs() < 1e-6 && near.point_a.distance_to(p(0.0, 3.0, 0.0)) < 1e-2);
    }
}
