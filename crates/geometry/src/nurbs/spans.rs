//! Knots one by one, and the polynomial spans as Bézier curves.

use super::NurbsCurve;
use super::curve::Controls;
use crate::{BoundingBox, Error, Result};

impl NurbsCurve {
    /// Whether the start and the end have full knot multiplicity, each for itself.
    pub fn clamped_ends(&self) -> [bool; 2] {
        let (n, p) = (self.knots.len(), self.degree);
        let equal = |a: usize, b: usize| self.knots.get(a) == self.knots.get(b);
        [equal(0, p - 1), equal(n - p, n - 1)]
    }

    /// For every knot how often its value occurs, in the order of [`NurbsCurve::knots`].
    pub fn knot_multiplicities(&self) -> Vec<usize> {
        let mut out = Vec::with_capacity(self.knots.len());
        for run in self.knots.chunk_by(|a, b| a == b) {
            out.extend(std::iter::repeat_n(run.len(), run.len()));
        }
        out
    }

    /// The number of spans that are not empty.
    pub fn span_count(&self) -> usize {
        self.spans().count()
    }

    /// Whether every knot has full multiplicity, so that the control points are those of Bézier curves end to end.
    pub fn has_bezier_spans(&self) -> bool {
        self.knots.chunk_by(|a, b| a == b).all(|run| run.len() == self.degree)
    }

    /// The two knots, one before the first and one after the last, that systems store which write degree +
    /// control points + 1 knots: the end knots again, or for an unclamped end of an order above 2 with at least
    /// 2·order − 2 and at least 6 control points the knot that goes on with the period (as
    /// `ON_SuperfluousKnot` has it).
    pub fn superfluous_knots(&self) -> [f64; 2] {
        let (k, order, count) = (&self.knots, self.order(), self.point_count());
        let at = |i: usize| k.get(i).copied().unwrap_or(0.0);
        let (mut first, mut last) = (at(0), at(k.len() - 1));
        if order > 2 && count >= 2 * order - 2 && count >= 6 {
            if at(count - 1) < last {
                last += at(order + 1) - at(order);
            }
            if first < at(order - 2) {
                first -= at(count - order + 1) - at(count - order);
            }
        }
        [first, last]
    }

    /// The box around the control points in space; it holds the curve.
    pub fn control_box(&self) -> Option<BoundingBox> {
        BoundingBox::from_points(self.control_points())
    }

    /// The same curve with full multiplicity at every knot: all spans as Bézier curves in one curve.
    ///
    /// # Errors
    /// Not for a value that exists; the result is checked like any other.
    pub fn with_bezier_spans(&self) -> Result<Self> {
        let spans = self.span_parameters();
        let knots = spans.iter().flat_map(|&t| std::iter::repeat_n(t, self.degree)).collect();
        self.over_knots(knots)
    }

    /// Span `i` of those that are not empty as a Bézier curve over 0…1.
    ///
    /// # Errors
    /// There is no such span.
    pub fn bezier_span(&self, i: usize) -> Result<Self> {
        let j = self.spans().nth(i).ok_or(Error::OutOfRange {
            what: "span index",
            value: i as f64,
            must: "less than the number of spans",
        })?;
        let points = self.bezier_points(j);
        let knots = [0.0, 1.0].iter().flat_map(|&t| std::iter::repeat_n(t, self.degree)).collect();
        let controls = match self.controls {
            Controls::Plain(_) => Controls::Plain(points.iter().map(|&[x, y, z, _]| [x, y, z]).collect()),
            Controls::Rational(_) => Controls::Rational(points),
        };
        Self::from_controls(self.degree, controls, knots)
    }
}
