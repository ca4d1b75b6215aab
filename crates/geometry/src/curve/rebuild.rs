//! A curve again, with another structure.

use super::closest::ClosestOnCurve;
use super::{ArcLength, Curve};
use crate::nurbs::{Approximation, LeastSquares};
use crate::{Error, Interval, NurbsCurve, Result, Tolerance};

impl Curve {
    /// A non-rational curve with uniform knots, a degree and a number of control points that follows this one: the
    /// least-squares fit to points at equal lengths, with the ends kept and, if asked, the directions there. The
    /// domain stays. A curve that closes smoothly becomes periodic, `count` then being its different control points.
    ///
    /// The deviation is measured both ways, at sixteen points a span: the largest distance of a point of either curve
    /// from the other one.
    ///
    /// # Errors
    /// A degree outside 1…31, no more control points than the degree or more than 10,000, or a curve without length.
    pub fn rebuilt(&self, degree: usize, count: usize, keep_tangents: bool) -> Result<Approximation> {
        if count > 10_000 {
            return Err(Error::OutOfRange {
                what: "control points",
                value: count as f64,
                must: "at most 10,000",
            });
        }
        crate::clamped_uniform_knots(degree, count)?;
        let domain = self.domain();
        let closed = degree >= 2 && count >= 3.max(degree + 1) && self.closes_smoothly();
        let measure = ArcLength::new(self);
        let total = measure.total();
        if !(total > 0.0) {
            return Err(Error::degenerate("curve to rebuild", "it has no length"));
        }
        let samples = 8 * count.max(16);
        let shares: Vec<f64> = (0..=samples).map(|i| i as f64 / samples as f64).collect();
        let mut points = Vec::with_capacity(shares.len());
        for x in &shares {
            crate::cancellation::check()?;
            points.push(match *x {
                0.0 => self.start(),
                1.0 => self.end(),
                x => self.point_at(measure.parameter_at(x * total)),
            });
        }
        let parameters: Vec<f64> = shares.iter().map(|&x| domain.at(x)).collect();
        let curve = if closed {
            let open = points.len() - 1;
            NurbsCurve::least_squares_periodic(degree, count, domain, &points[..open], &parameters[..open])?
        } else {
            let uniform = crate::clamped_uniform_knots(degree, count)?;
            let last = uniform.last().copied().unwrap_or(1.0);
            let knots: Vec<f64> = uniform.iter().map(|k| domain.at(k / last)).collect();
            let speed = total / domain.length();
            let along = |t: f64, below: bool| self.tangent_on_side(t, below).map(|v| v * speed);
            let tangents = keep_tangents && count >= 4;
            let options = LeastSquares {
                start_derivative: if tangents { along(domain.start, false) } else { None },
                end_derivative: if tangents { along(domain.end, true) } else { None },
                ..LeastSquares::default()
            };
            NurbsCurve::least_squares(degree, &knots, &points, &parameters, &options)?
        };
        let deviation = self.measured_deviation(&curve.clone().into())?;
        Ok(Approximation { curve, deviation })
    }

    /// A non-rational NURBS curve of a degree within `tolerance` of this one, its kinks kept. The deviation is
    /// certified; it is that of equal parameters of the exact NURBS form: see [`NurbsCurve::refit`].
    ///
    /// # Errors
    /// As [`NurbsCurve::refit`].
    pub fn refitted(&self, degree: usize, tolerance: f64) -> Result<Approximation> {
        self.to_nurbs()?.refit(degree, tolerance)
    }

    fn closes_smoothly(&self) -> bool {
        if !self.is_closed() {
            return false;
        }
        let domain = self.domain();
        match (self.tangent_on_side(domain.end, true), self.tangent_on_side(domain.start, false)) {
            (Some(a), Some(b)) => a.angle_to(b).is_some_and(|x| x <= Tolerance::default().angle),
            _ => false,
        }
    }

    /// The largest distance, among sixteen points on every span of either curve, of a point from the other curve.
    ///
    /// # Errors
    /// As [`Curve::closest_point`].
    pub fn measured_deviation(&self, other: &Self) -> Result<f64> {
        let mut worst = 0.0_f64;
        for (a, b) in [(self, other), (other, self)] {
            let search = ClosestOnCurve::new(b);
            for piece in a.pieces() {
                for k in 0..=16 {
                    let p = piece.point(Interval::at(piece.own, f64::from(k) / 16.0));
                    worst = worst.max(search.nearest(p)?.distance);
                }
            }
        }
        Ok(worst)
    }
}
