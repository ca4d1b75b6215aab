//! Parts of a curve, and the same curve in another direction or domain.

use super::NurbsCurve;
use super::curve::Controls;
use crate::{Error, Interval, Result};

impl NurbsCurve {
    /// The distinct knots of the domain, start and end among them: where the polynomial pieces meet.
    pub fn span_parameters(&self) -> Vec<f64> {
        let mut spans: Vec<f64> = self.knots[self.degree - 1..=self.knots.len() - self.degree].to_vec();
        spans.dedup();
        spans
    }

    /// The part between two parameters, clamped at its ends, with its part of the domain.
    ///
    /// # Errors
    /// The range does not increase or leaves the domain.
    pub fn trimmed(&self, range: Interval) -> Result<Self> {
        let domain = self.domain();
        let (a, b) = (self.snapped(range.start), self.snapped(range.end));
        if !(a < b && domain.start <= a && b <= domain.end) {
            return Err(Error::Invalid {
                what: "trim range",
                why: format!(
                    "{} to {} is not an increasing part of {} to {}",
                    range.start, range.end, domain.start, domain.end
                ),
            });
        }
        let p = self.degree;
        let inside = self.knots.partition_point(|&k| k <= a)..self.knots.partition_point(|&k| k < b);
        let inside = self.knots.get(inside).unwrap_or(&[]).iter().copied();
        let knots =
            std::iter::repeat_n(a, p).chain(inside).chain(std::iter::repeat_n(b, p)).collect::<Vec<_>>();
        self.over_knots(knots)
    }

    /// The parts before and after `t`.
    ///
    /// # Errors
    /// `t` is not inside the domain.
    pub fn split(&self, t: f64) -> Result<(Self, Self)> {
        let domain = self.domain();
        Ok((self.trimmed(Interval::new(domain.start, t))?, self.trimmed(Interval::new(t, domain.end))?))
    }

    /// The polynomial pieces as Bézier curves, each over its own span.
    pub fn bezier_pieces(&self) -> Result<Vec<Self>> {
        let spans = self.span_parameters();
        spans.windows(2).map(|w| self.trimmed(Interval::new(w[0], w[1]))).collect()
    }

    /// The same curve walked backwards; the domain a…b becomes −b…−a, as in openNURBS.
    #[must_use]
    pub fn reversed(&self) -> Self {
        let knots = self.knots.iter().rev().map(|k| -k).collect();
        let controls = match &self.controls {
            Controls::Plain(p) => Controls::Plain(p.iter().rev().copied().collect()),
            Controls::Rational(p) => Controls::Rational(p.iter().rev().copied().collect()),
        };
        Self { degree: self.degree, knots, controls }
    }

    /// The same curve over another domain: the parameter is mapped linearly.
    ///
    /// # Errors
    /// The domain does not increase, or is so small or so far from 0 that knots would fall together.
    pub fn with_domain(&self, domain: Interval) -> Result<Self> {
        if !domain.is_increasing() {
            return Err(Error::Invalid {
                what: "domain",
                why: format!("{} to {} does not increase", domain.start, domain.end),
            });
        }
        let old = self.domain();
        if old == domain {
            return Ok(self.clone());
        }
        let knots = self.knots.iter().map(|&k| domain.at(old.normalized(k))).collect();
        Self::from_controls(self.degree, self.controls.clone(), knots)
    }
}
