//! Arc length and its inverse.

use super::Curve;
use super::piece::{Piece, Shape};
use super::speed::{Hodographs, Place, Speed};
use crate::curve::thresholds::{FINEST_LENGTH, LENGTH_AT, NEWTON_LANDS};
use crate::{Interval, cancellation};

/// What the rules for parts of a span must agree to, where nobody says otherwise.
const DEFAULT: f64 = 2e-13;

/// The arc length along a curve, prepared for many questions: its smooth pieces cut into parts on which one
/// quadrature rule is exact to rounding, with the length up to each.
///
/// Lengths are good to about 10⁻¹³ of the whole; parameters to the corresponding distance. A question about a NURBS
/// curve takes some hundred nanoseconds and no memory.
#[derive(Debug, Clone)]
pub struct ArcLength<'a> {
    pieces: Vec<Piece<'a>>,
    /// The length from the start of the curve to the start of each piece, and at last the whole length.
    sums: Vec<f64>,
    /// For each piece its first part and its hodograph; and the end of the parts at last.
    tables: Vec<(u32, Option<Place>)>,
    parts: Vec<Part>,
    hodographs: Hodographs,
}

/// A part of a span on which the speed is smooth.
#[derive(Debug, Clone, Copy)]
struct Part {
    /// Where it starts and ends, in 0…1 over the span.
    range: [f64; 2],
    /// The length from the start of the span to its start, and its own.
    before: f64,
    length: f64,
    /// The speeds at its ends.
    speeds: [f64; 2],
}

impl Part {
    /// About where the part has covered `length`: the cubic by both ends and their speeds, the other way round.
    fn guess(&self, length: f64) -> f64 {
        let [a, b] = self.range;
        let y = length / self.length;
        let chord = b - a;
        // dx/dy at the ends, bounded so that the cubic stays monotone (Fritsch & Carlson, SIAM J. Numer. Anal. 17,
        // 1980).
        let slope = |speed: f64| (self.length / speed).min(3.0 * chord);
        let (d0, d1) = (slope(self.speeds[0]), slope(self.speeds[1]));
        let z = 1.0 - y;
        a + chord * y * y * (3.0 - 2.0 * y) + y * z * (d0 * z - d1 * y)
    }
}

/// The length of a piece from its start to `to`, both in its own parameter; `None` for a span.
fn simple_length(piece: &Piece<'_>, to: f64) -> Option<f64> {
    let range = (to - piece.own.start).abs();
    match piece.shape {
        Shape::Segment(p, q) => Some(p.distance_to(q) * range),
        Shape::Arc(arc) => Some(arc.circle.radius * range),
        Shape::Span(..) => None,
    }
}

impl<'a> ArcLength<'a> {
    /// Measures the pieces of a curve.
    pub fn new(curve: &'a Curve) -> Self {
        let mut pieces = curve.pieces();
        // The parts and the hodograph of a span take some hundred bytes. Who has no room for that measures nothing: the
        // work is given up as soon as it is asked for.
        if cancellation::room::<[f64; 40]>(pieces.len()).is_err() {
            pieces.clear();
        }
        let mut sums = Vec::with_capacity(pieces.len() + 1);
        let mut tables = Vec::with_capacity(pieces.len() + 1);
        let (mut parts, mut hodographs) = (Vec::with_capacity(2 * pieces.len()), Hodographs::default());
        let (mut sum, mut measured) = (0.0, 0);
        sums.push(sum);
        for piece in &pieces {
            if cancellation::check().is_err() {
                break;
            }
            measured += 1;
            let first = parts.len() as u32;
            if let Shape::Span(nurbs, j) = piece.shape {
                let place = hodographs.push(nurbs, j);
                let speed = hodographs.get(place);
                let mut before = 0.0;
                speed.measure(DEFAULT, 0.01 * sum, |a, b, length| {
                    parts.push(Part { range: [a, b], before, length, speeds: [speed.at(a), speed.at(b)] });
                    before += length;
                });
                tables.push((first, Some(place)));
                sum += before;
            } else {
                tables.push((first, None));
                sum += simple_length(piece, piece.own.end).unwrap_or(0.0);
            }
            sums.push(sum);
        }
        tables.push((parts.len() as u32, None));
        pieces.truncate(measured);
        Self { pieces, sums, tables, parts, hodographs }
    }

    /// The whole length.
    pub fn total(&self) -> f64 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    /// The parts of piece `i`, and its speed; `None` for a segment or an arc.
    fn table(&self, i: usize) -> Option<(&[Part], Speed<'_>)> {
        let (first, place) = *self.tables.get(i)?;
        let parts = self.parts.get(first as usize..self.tables.get(i + 1)?.0 as usize)?;
        Some((parts, self.hodographs.get(place?)))
    }

    /// The length from the start to parameter `t`; a parameter outside the domain counts as its nearest end.
    pub fn length_at(&self, t: f64) -> f64 {
        let i = self.pieces.partition_point(|p| p.whole.end <= t);
        let Some(piece) = self.pieces.get(i) else { return self.total() };
        if !(t > piece.whole.start) {
            return self.sums[i];
        }
        let own = piece.own_parameter(t);
        let Some((parts, speed)) = self.table(i) else {
            return self.sums[i] + simple_length(piece, own).unwrap_or(0.0);
        };
        let x = piece.own.normalized(own);
        let Some(part) = parts.get(parts.partition_point(|p| p.range[1] <= x)) else {
            return self.sums[i + 1];
        };
        self.sums[i] + part.before + speed.rule(part.range[0], x).0
    }

    /// The parameter at a length from the start; a length outside 0…total counts as the nearest end.
    ///
    /// The part of the table by halving the list; inside it Newton's method on the length, kept in a bracket.
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
        let Some((parts, speed)) = self.table(i) else {
            return piece.whole_parameter(piece.own.at(wanted / size));
        };
        let k = parts.partition_point(|p| p.before <= wanted).saturating_sub(1);
        let Some(part) = parts.get(k) else { return piece.whole.start };
        let x = inside(part, speed, wanted - part.before, LENGTH_AT * self.total());
        piece.whole_parameter(piece.own.at(x))
    }
}

/// Where in a part its length is `wanted`, to within `tolerance`.
fn inside(part: &Part, speed: Speed<'_>, wanted: f64, tolerance: f64) -> f64 {
    let [mut low, mut high] = part.range;
    if !(part.length > 0.0) || wanted <= 0.0 {
        return low;
    }
    if wanted >= part.length {
        return high;
    }
    let mut x = part.guess(wanted);
    if !(low < x && x < high) {
        x = low + (high - low) * (wanted / part.length);
    }
    for _ in 0..100 {
        let miss = wanted - speed.rule(part.range[0], x).0;
        if miss.abs() <= tolerance {
            // Near the end of Newton's way one more step costs nothing and gives the last digits.
            let last = x + miss / speed.at(x);
            return if low < last && last < high { last } else { x };
        }
        if miss > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let rate = speed.at(x);
        let mut next = x + miss / rate;
        if !(low < next && next < high) {
            next = 0.5 * (low + high);
        } else if (miss * (next - x)).abs() <= NEWTON_LANDS * part.length * (high - low) && {
            // When the step is so small that the speed hardly changes over it, it lands within the tolerance.
            let other = speed.at(next);
            ((other - rate) * (next - x)).abs() <= tolerance
        } {
            return next;
        }
        if next == x || !(low < high) {
            break;
        }
        x = next;
    }
    x
}

impl Curve {
    /// The arc length, to about 10⁻¹³ of itself: exact formulas for segments and arcs, adaptive Gauss–Kronrod
    /// quadrature on NURBS spans.
    pub fn length(&self) -> f64 {
        self.measured(DEFAULT)
    }

    /// The arc length to within a fraction of itself, from 10⁻¹⁵ to 0.1 (others count as the nearest of them):
    /// 10⁻⁹ takes half the time of [`Curve::length`].
    ///
    /// Each span by the 31-point Gauss–Kronrod rule (R. Piessens et al., *QUADPACK*, 1983), halved until the
    /// estimated error is within the fraction of its own length: halving closes in on cusps.
    pub fn length_within(&self, fraction: f64) -> f64 {
        self.measured(fraction.clamp(FINEST_LENGTH, 0.1))
    }

    fn measured(&self, relative: f64) -> f64 {
        let mut hodographs = Hodographs::default();
        let mut sum = 0.0;
        for piece in &self.pieces() {
            if cancellation::check().is_err() {
                break;
            }
            if let Shape::Span(nurbs, j) = piece.shape {
                hodographs.clear();
                let place = hodographs.push(nurbs, j);
                sum += hodographs.get(place).measure(relative, 0.01 * sum, |_, _, _| ());
            } else {
                sum += simple_length(piece, piece.own.end).unwrap_or(0.0);
            }
        }
        sum
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
