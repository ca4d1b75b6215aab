//! Arc length and its inverse.

use super::Curve;
use super::piece::{Piece, Shape};
use crate::Interval;
use crate::quadrature::integrate;

/// The arc length along a curve, prepared for many questions: the lengths of its smooth pieces.
///
/// Lengths are good to about 10⁻¹³ of the whole; parameters to the corresponding distance.
#[derive(Debug, Clone)]
pub struct ArcLength<'a> {
    pieces: Vec<Piece<'a>>,
    /// The length from the start of the curve to the start of each piece, and at last the whole length.
    sums: Vec<f64>,
}

fn piece_length(piece: &Piece<'_>, a: f64, b: f64, tolerance: f64) -> f64 {
    match piece.shape {
        Shape::Segment(p, q) => p.distance_to(q) * (b - a).abs(),
        Shape::Arc(arc) => arc.circle.radius * (b - a).abs(),
        Shape::Span(curve, j) => {
            let speed = |u: f64| [curve.velocity(j, u).length()];
            integrate(&speed, a, b, tolerance)[0].abs()
        }
    }
}

impl<'a> ArcLength<'a> {
    /// Measures the pieces of a curve.
    pub fn new(curve: &'a Curve) -> Self {
        let pieces = curve.pieces();
        let mut sums = Vec::with_capacity(pieces.len() + 1);
        let mut sum = 0.0;
        sums.push(sum);
        // The polygon of the control points gives the scale of the tolerance.
        for piece in &pieces {
            let polygon: f64 = match piece.shape {
                Shape::Span(curve, j) => {
                    let points: Vec<_> = curve.span_hull(j).collect();
                    points.windows(2).map(|w| w[0].distance_to(w[1])).sum()
                }
                _ => 0.0,
            };
            sum += piece_length(piece, piece.own.start, piece.own.end, 1e-13 * polygon);
            sums.push(sum);
        }
        Self { pieces, sums }
    }

    /// The whole length.
    pub fn total(&self) -> f64 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    /// The length from the start to parameter `t`; a parameter outside the domain counts as its nearest end.
    pub fn length_at(&self, t: f64) -> f64 {
        let i = self.pieces.partition_point(|p| p.whole.end <= t);
        let Some(piece) = self.pieces.get(i) else { return self.total() };
        if t <= piece.whole.start {
            return self.sums[i];
        }
        let size = self.sums[i + 1] - self.sums[i];
        self.sums[i] + piece_length(piece, piece.own.start, piece.own_parameter(t), 1e-13 * size)
    }

    /// The parameter at a length from the start; a length outside 0…total counts as the nearest end.
    ///
    /// Newton's method on the length, kept inside a bracket; each step integrates only over what lies between it
    /// and the step before.
    pub fn parameter_at(&self, length: f64) -> f64 {
        let (Some(first), Some(last)) = (self.pieces.first(), self.pieces.last()) else { return 0.0 };
        if !(length > 0.0) {
            return first.whole.start;
        }
        if length >= self.total() {
            return last.whole.end;
        }
        let i = (self.sums.partition_point(|&s| s <= length).saturating_sub(1)).min(self.pieces.len() - 1);
        let piece = &self.pieces[i];
        let (size, wanted) = (self.sums[i + 1] - self.sums[i], length - self.sums[i]);
        if !(size > 0.0) || wanted <= 0.0 {
            return piece.whole.start;
        }
        let Shape::Span(curve, j) = piece.shape else {
            return piece.whole_parameter(piece.own.at(wanted / size));
        };
        let (mut low, mut high) = (piece.own.start, piece.own.end);
        let mut u = piece.own.at(wanted / size);
        let mut have = piece_length(piece, low, u, 1e-13 * size);
        for _ in 0..100 {
            let miss = wanted - have;
            if miss.abs() <= 5e-14 * self.total() {
                break;
            }
            if miss > 0.0 {
                low = u;
            } else {
                high = u;
            }
            let speed = curve.velocity(j, u).length();
            let mut next = u + miss / speed;
            if !(low < next && next < high) {
                next = 0.5 * (low + high);
            }
            if next == u || !(low < high) {
                break;
            }
            have += piece_length(piece, u, next, 1e-13 * size) * (next - u).signum();
            u = next;
        }
        piece.whole_parameter(u)
    }
}

impl Curve {
    /// The arc length, to about 10⁻¹³ of itself: exact formulas for segments and arcs, adaptive Gauss–Kronrod
    /// quadrature on NURBS spans.
    pub fn length(&self) -> f64 {
        ArcLength::new(self).total()
    }

    /// The length of the part between two parameters.
    pub fn length_between(&self, range: Interval) -> f64 {
        let measure = ArcLength::new(self);
        (measure.length_at(range.end) - measure.length_at(range.start)).abs()
    }

    /// The parameter at a length from the start; `None` outside 0…length. For many of them use [`ArcLength`].
    pub fn parameter_at_length(&self, length: f64) -> Option<f64> {
        let measure = ArcLength::new(self);
        (0.0..=measure.total()).contains(&length).then(|| measure.parameter_at(length))
    }

    /// The parameter at a fraction 0…1 of the length; `None` outside.
    pub fn parameter_at_normalized_length(&self, fraction: f64) -> Option<f64> {
        let measure = ArcLength::new(self);
        (0.0..=1.0).contains(&fraction).then(|| measure.parameter_at(fraction * measure.total()))
    }
}
