//! Lower degree.

use super::NurbsCurve;
use super::curve::Controls;
use super::deviation::Approximation;
use crate::nurbs::thresholds::REDUCTION_ROUNDING;
use crate::{Error, Result};

impl NurbsCurve {
    /// The curve with its degree lowered by one. The deviation is a certified bound of the distance between points
    /// of equal parameters; ends stay. Exact, to rounding, when the degree was higher than needed.
    ///
    /// Each Bézier piece is reduced from both ends (P&T, *The NURBS Book*, §5.6 and algorithm A5.11); then knots are
    /// removed down to the continuity that the curve had, as far as the tolerance goes.
    ///
    /// # Errors
    /// The degree is 1, the deviation would be above `tolerance`, or a weight would not be positive.
    pub fn reduce_degree(&self, tolerance: f64) -> Result<Approximation> {
        if !(tolerance >= 0.0) {
            return Err(Error::OutOfRange { what: "tolerance", value: tolerance, must: "0 or more" });
        }
        let p = self.degree;
        if p < 2 {
            return Err(Error::OutOfRange { what: "degree to reduce", value: p as f64, must: "2 or more" });
        }
        let breaks = self.span_parameters();
        let mut points: Vec<[f64; 4]> = Vec::new();
        for piece in self.beziers_between(&breaks)? {
            let lower = reduced(&piece);
            let skip = usize::from(!points.is_empty());
            points.extend(lower.into_iter().skip(skip));
        }
        let knots = breaks.iter().flat_map(|&t| std::iter::repeat_n(t, p - 1)).collect();
        let controls = if self.is_rational() {
            Controls::Rational(points)
        } else {
            Controls::Plain(points.iter().map(|p| [p[0], p[1], p[2]]).collect())
        };
        let pieces = Self::from_controls(p - 1, controls, knots)?;
        let size = self.control_points().iter().fold(0.0_f64, |m, p| m.max(p.to_vector().length()));
        let rounding = REDUCTION_ROUNDING * size;
        let first = self.deviation_from(&pieces)?;
        if !(first <= tolerance + rounding) {
            return Err(Error::OutOfRange {
                what: "tolerance of the degree reduction",
                value: tolerance,
                must: "at least the deviation of the reduced curve",
            });
        }
        let spare = (tolerance - first).max(rounding);
        let curve = if spare.is_finite() {
            // At most as smooth as it was: a knot of multiplicity s had p − s continuous derivatives.
            let mut curve = pieces;
            for &t in breaks.iter().take(breaks.len() - 1).skip(1) {
                let wanted = self.multiplicity(t).saturating_sub(1);
                let times = (p - 1).saturating_sub(wanted);
                curve = curve.remove_knot(t, times, spare / breaks.len() as f64)?.0;
            }
            curve
        } else {
            pieces
        };
        let deviation = self.deviation_from(&curve)?;
        Ok(Approximation { curve, deviation })
    }
}

/// The Bézier points of one degree less: the lower half from the start, the upper half from the end, so that both
/// ends stay with as many derivatives as can be (P&T, eq. 5.41 to 5.46).
fn reduced(points: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let p = points.len().saturating_sub(1);
    if p < 2 {
        return points.to_vec();
    }
    let last = p - 1;
    let middle = (p - 1) / 2;
    let mut out = vec![[0.0; 4]; p];
    out[0] = points[0];
    out[last] = points[p];
    let forward = |i: usize, before: [f64; 4]| -> [f64; 4] {
        let a = i as f64 / p as f64;
        std::array::from_fn(|c| (points[i][c] - a * before[c]) / (1.0 - a))
    };
    let backward = |i: usize, after: [f64; 4]| -> [f64; 4] {
        let a = (i + 1) as f64 / p as f64;
        std::array::from_fn(|c| (points[i + 1][c] - (1.0 - a) * after[c]) / a)
    };
    for i in 1..=middle {
        out[i] = forward(i, out[i - 1]);
    }
    for i in (middle + 1..last).rev() {
        out[i] = backward(i, out[i + 1]);
    }
    if p % 2 == 1 && last > 0 && middle > 0 {
        // Odd degrees meet in one point: the mean of both ways to it.
        let other = backward(middle, out[middle + 1]);
        out[middle] = std::array::from_fn(|c| 0.5 * (out[middle][c] + other[c]));
    }
    out
}
