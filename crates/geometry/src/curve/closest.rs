//! The point of a curve nearest to a given one.

use super::Curve;
use super::piece::{Piece, Shape};
use crate::bernstein::{BUDGET, halves, squared_distance, value};
use crate::{Arc, Error, Point3, Result};

/// A point on a curve and how far it is from where one asked.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CurvePoint {
    /// The parameter on the curve.
    pub parameter: f64,
    /// The point there.
    pub point: Point3,
    /// Its distance from the point asked for.
    pub distance: f64,
}

/// The best candidate so far.
struct Best {
    squared: f64,
    piece: usize,
    own: f64,
}

impl Best {
    fn offer(&mut self, squared: f64, piece: usize, own: f64) {
        if squared < self.squared {
            *self = Self { squared, piece, own };
        }
    }
}

impl Curve {
    /// The point of the curve nearest to `q`: always the global one, and of equally near ones one of them.
    ///
    /// Segments and arcs by formula. A NURBS span by branch and bound on the Bernstein coefficients of the squared
    /// distance: a part is discarded when the coefficients prove it farther than the best found, or solved by
    /// Newton's method when they prove the distance function convex there (compare X.-D. Chen et al., *Improved
    /// algebraic algorithm on point projection for Bézier curves*, 2007).
    ///
    /// # Errors
    /// `q` is not finite, or so far away that the square of the distance overflows.
    pub fn closest_point(&self, q: Point3) -> Result<CurvePoint> {
        if !q.is_finite() {
            return Err(Error::NotFinite("point to project on the curve"));
        }
        let pieces = self.pieces();
        let mut best =
            Best { squared: f64::INFINITY, piece: 0, own: pieces.first().map_or(0.0, |p| p.own.start) };
        // Ends first: they cost little and cut most of what follows.
        for (i, piece) in pieces.iter().enumerate() {
            best.offer((piece.start() - q).length_squared(), i, piece.own.start);
            best.offer((piece.end() - q).length_squared(), i, piece.own.end);
        }
        for (i, piece) in pieces.iter().enumerate() {
            match piece.shape {
                Shape::Segment(a, b) => {
                    let u = crate::Line::new(a, b).closest_parameter(q).clamp(0.0, 1.0);
                    best.offer((piece.point(u) - q).length_squared(), i, u);
                }
                Shape::Arc(arc) => {
                    let u = arc.closest_angle(q);
                    best.offer((piece.point(u) - q).length_squared(), i, u);
                }
                Shape::Span(curve, j) => {
                    let reach = crate::BoundingBox::from_points(curve.span_hull(j));
                    if reach.is_none_or(|b| b.distance_to(q).powi(2) < best.squared) {
                        search_span(piece, i, q, &mut best);
                    }
                }
            }
        }
        if !best.squared.is_finite() {
            return Err(Error::NotFinite("square of the distance to the curve"));
        }
        let Some(piece) = pieces.get(best.piece) else {
            return Err(Error::degenerate("curve", "it has no extent"));
        };
        let own = if let Shape::Span(..) = piece.shape { polish(piece, best.own, q) } else { best.own };
        let point = piece.point(own);
        Ok(CurvePoint { parameter: piece.whole_parameter(own), point, distance: point.distance_to(q) })
    }
}

impl Arc {
    /// The angle, within the arc's own, of its point nearest to `q`; the start for a point on the axis.
    pub fn closest_angle(&self, q: Point3) -> f64 {
        let [x, y, _] = self.circle.plane.coordinates(q);
        let tiny = 1e-14 * self.circle.radius;
        if x.abs() <= tiny && y.abs() <= tiny {
            return self.angle.start;
        }
        let (low, high) = (self.angle.min(), self.angle.max());
        let turn = std::f64::consts::TAU;
        let mut angle = y.atan2(x);
        // The representative at or after the lower end.
        angle += ((low - angle) / turn).ceil() * turn;
        if angle <= high {
            return angle;
        }
        // Outside: the nearer end. Going back from `angle − 2π` the lower end is nearer when that is the smaller gap.
        if angle - high <= low - (angle - turn) { high } else { low }
    }
}

/// Newton's method on (C − q)·C′ from a good start; a step is taken only while the distance does not grow.
fn polish(piece: &Piece<'_>, start: f64, q: Point3) -> f64 {
    let mut u = start;
    let mut squared = (piece.point(u) - q).length_squared();
    for _ in 0..8 {
        let [c, d1, d2] = piece.jet(u);
        let r = c - q.to_vector();
        let slope = d1.length_squared() + r.dot(d2);
        if !(slope > 0.0) {
            break;
        }
        let next = piece.own.clamp(u - r.dot(d1) / slope);
        let found = (piece.point(next) - q).length_squared();
        if next == u || found > squared {
            break;
        }
        (u, squared) = (next, found);
    }
    u
}

fn search_span(piece: &Piece<'_>, index: usize, q: Point3, best: &mut Best) {
    let Some(points) = piece.beziers().pop() else { return };
    let rational = points.iter().any(|p| p[3] != 1.0);
    let coefficients = squared_distance(&points, q);
    let weight = coefficients.iter().fold(0.0_f64, |m, c| m.max(c[1]));
    let size = coefficients.iter().fold(0.0_f64, |m, c| m.max(c[0]));
    if !size.is_finite() || !weight.is_finite() {
        return;
    }
    let at = |x: f64| piece.own.at(x);
    let mut budget = BUDGET;
    let mut stack = vec![(coefficients, 0.0, 1.0, 0_u32)];
    while let Some((c, a, b, depth)) = stack.pop() {
        let excess = |best: &Best| -> Vec<f64> { c.iter().map(|c| c[0] - best.squared * c[1]).collect() };
        // What rounding could hide: 2e-13 of the distance found, or 1e-13 of the size of the problem.
        let slack = |best: &Best| 4e-13 * best.squared * weight + 1e-26 * size;
        let mut h = excess(best);
        if h.iter().all(|&x| x >= -slack(best)) {
            continue;
        }
        if h.windows(3).all(|w| w[0] - 2.0 * w[1] + w[2] >= 0.0) {
            // Convex: one minimum. With weights the quotient's is approached by raising the bar each time
            // (Dinkelbach's method).
            for _ in 0..if rational { 8 } else { 1 } {
                let own = at(a + (b - a) * convex_minimum(&h));
                let before = best.squared;
                best.offer((piece.point(own) - q).length_squared(), index, own);
                if before - best.squared <= 1e-15 * before {
                    break;
                }
                h = excess(best);
            }
            continue;
        }
        budget = budget.saturating_sub(1);
        if depth >= 52 || budget == 0 {
            continue;
        }
        let middle = 0.5 * (a + b);
        best.offer((piece.point(at(middle)) - q).length_squared(), index, at(middle));
        let (left, right) = halves(&c);
        let least = |c: &[[f64; 2]]| c.iter().fold(f64::INFINITY, |m, c| m.min(c[0]));
        if least(&left) < least(&right) {
            stack.push((right, middle, b, depth + 1));
            stack.push((left, a, middle, depth + 1));
        } else {
            stack.push((left, a, middle, depth + 1));
            stack.push((right, middle, b, depth + 1));
        }
    }
}

/// Where in 0…1 a convex polynomial is least: Newton's method on its derivative, kept in a bracket.
fn convex_minimum(h: &[f64]) -> f64 {
    let n = (h.len() - 1) as f64;
    let first: Vec<[f64; 1]> = h.windows(2).map(|w| [n * (w[1] - w[0])]).collect();
    let (Some(start), Some(end)) = (first.first(), first.last()) else { return 0.0 };
    if start[0] >= 0.0 {
        return 0.0;
    }
    if end[0] <= 0.0 {
        return 1.0;
    }
    let second: Vec<[f64; 1]> = first.windows(2).map(|w| [(n - 1.0) * (w[1][0] - w[0][0])]).collect();
    let (mut low, mut high) = (0.0, 1.0);
    let mut x = start[0] / (start[0] - end[0]);
    for _ in 0..60 {
        let slope = value(&first, x)[0];
        if slope < 0.0 {
            low = x;
        } else {
            high = x;
        }
        let mut next = x - slope / value(&second, x)[0];
        if !(low < next && next < high) {
            next = 0.5 * (low + high);
        }
        if (next - x).abs() <= 1e-16 {
            break;
        }
        x = next;
    }
    x
}
