//! Curves between two curves.

use super::{ArcLength, Curve};
use crate::{Error, Interval, KnotSpacing, NurbsCurve, Point3, Result, compatible_curves};

/// Which points of two curves belong together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TweenMatch {
    /// Control points, after both curves have been given the same degree and knots: exact, and the same as points of
    /// equal normalised parameters where neither is rational.
    ControlPoints,
    /// Points of equal normalised parameters, so many on each curve; the result interpolates the points between them.
    Parameters(usize),
    /// Points of equal shares of the lengths, likewise.
    Lengths(usize),
}

impl Curve {
    /// The curve a share `x` of the way to another one: this one's shape at 0, the other's at 1. Over 0…1.
    ///
    /// # Errors
    /// `x` is not finite, a rational result would have weights that are not positive (only outside 0…1), or fewer
    /// than two or more than a million points are to be matched.
    pub fn tween(&self, other: &Self, x: f64, matching: TweenMatch) -> Result<NurbsCurve> {
        if !x.is_finite() {
            return Err(Error::NotFinite("share of the way"));
        }
        let count = match matching {
            TweenMatch::ControlPoints => {
                let unit = |curve: &Self| curve.to_nurbs()?.with_domain(Interval::UNIT);
                let pair = compatible_curves(&[unit(self)?, unit(other)?])?;
                let [a, b] = pair.as_slice() else {
                    return Err(Error::degenerate("curves", "they cannot be made compatible"));
                };
                // Places and weights apart: so each control point lies between its two.
                let points: Vec<Point3> =
                    a.control_points().iter().zip(b.control_points()).map(|(p, q)| p.lerp(q, x)).collect();
                if !a.is_rational() {
                    return NurbsCurve::new(a.degree(), points, a.knots().to_vec());
                }
                let weights: Vec<f64> =
                    a.weights().iter().zip(b.weights()).map(|(v, w)| (1.0 - x) * v + x * w).collect();
                return NurbsCurve::with_weights(a.degree(), &points, &weights, a.knots().to_vec());
            }
            TweenMatch::Parameters(n) | TweenMatch::Lengths(n) => n,
        };
        if !(2..=1_000_000).contains(&count) {
            return Err(Error::OutOfRange {
                what: "points to match",
                value: count as f64,
                must: "2 to a million",
            });
        }
        let (first, second) = (ArcLength::new(self), ArcLength::new(other));
        let shares: Vec<f64> = (0..count).map(|i| i as f64 / (count - 1) as f64).collect();
        let points: Vec<Point3> = shares
            .iter()
            .map(|&s| {
                let (a, b) = match matching {
                    TweenMatch::Lengths(_) => {
                        (first.parameter_at(s * first.total()), second.parameter_at(s * second.total()))
                    }
                    _ => (self.domain().at(s), other.domain().at(s)),
                };
                self.point_at(a).lerp(other.point_at(b), x)
            })
            .collect();
        let degree = 3.min(count - 1);
        let degree = if degree == 2 { 1 } else { degree };
        NurbsCurve::interpolate(degree, &points, KnotSpacing::Chord, None, None)?.with_domain(Interval::UNIT)
    }

    /// The curve halfway between two: see [`Curve::tween`].
    ///
    /// # Errors
    /// As [`Curve::tween`].
    pub fn mean_with(&self, other: &Self) -> Result<NurbsCurve> {
        self.tween(other, 0.5, TweenMatch::ControlPoints)
    }
}
