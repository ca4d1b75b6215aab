//! Knots inserted, ends clamped, degree raised: the same curve with more control points.

use super::NurbsCurve;
use super::blossom::{over_knots, raised};
use super::curve::Controls;
use super::knots::MAX_DEGREE;
use crate::nurbs::thresholds::SAME_KNOT;
use crate::thresholds;
use crate::{Error, Result};

/// Applies a function on control points of any dimension to either kind of them.
pub(crate) fn map_controls(
    controls: &Controls,
    plain: impl FnOnce(&[[f64; 3]]) -> Option<Vec<[f64; 3]>>,
    rational: impl FnOnce(&[[f64; 4]]) -> Option<Vec<[f64; 4]>>,
) -> Option<Controls> {
    match controls {
        Controls::Plain(p) => plain(p).map(Controls::Plain),
        Controls::Rational(p) => rational(p).map(Controls::Rational),
    }
}

impl NurbsCurve {
    /// The same curve over other knots, which must refine these on their own domain.
    pub(crate) fn over_knots(&self, knots: Vec<f64>) -> Result<Self> {
        let controls = map_controls(
            &self.controls,
            |p| over_knots(self.degree, &self.knots, p, &knots),
            |p| over_knots(self.degree, &self.knots, p, &knots),
        )
        .ok_or(Error::degenerate("knot vector", "a control point acts on no span"))?;
        Self::from_controls(self.degree, controls, knots)
    }

    /// How often `t` occurs among the knots.
    pub fn multiplicity(&self, t: f64) -> usize {
        self.knots.iter().filter(|&&k| k == t).count()
    }

    /// A parameter so near to a knot that no curve could tell them apart becomes that knot.
    pub(crate) fn snapped(&self, t: f64) -> f64 {
        let tolerance =
            SAME_KNOT * self.domain().start.abs().max(self.domain().end.abs()).max(thresholds::LEAST_DIVISOR);
        let first = self.knots.partition_point(|&k| t - k > tolerance);
        self.knots.get(first).copied().filter(|k| (k - t).abs() <= tolerance).unwrap_or(t)
    }

    /// The same curve with the knot `t` repeated `multiplicity` times at least. A periodic curve stays periodic.
    ///
    /// By blossoming; the classic method with the same result is W. Boehm, *Inserting new knots into B-spline
    /// curves*, CAD 12 (1980).
    ///
    /// # Errors
    /// `t` is outside the domain, or the multiplicity is above the degree.
    pub fn insert_knot(&self, t: f64, multiplicity: usize) -> Result<Self> {
        let domain = self.domain();
        let t = self.snapped(t);
        if !domain.contains(t) {
            return Err(Error::OutOfRange { what: "knot", value: t, must: "inside the curve's domain" });
        }
        if multiplicity > self.degree {
            return Err(Error::OutOfRange {
                what: "knot multiplicity",
                value: multiplicity as f64,
                must: "at most the degree",
            });
        }
        let present = self.multiplicity(t);
        if present >= multiplicity {
            return Ok(self.clone());
        }
        if t == domain.start || t == domain.end {
            return self.clamped();
        }
        let mut knots = self.knots.clone();
        let at = knots.partition_point(|&k| k < t);
        knots.splice(at..at, std::iter::repeat_n(t, multiplicity - present));
        if self.is_periodic() {
            make_knots_periodic(self.degree, &mut knots);
        }
        self.over_knots(knots)
    }

    /// The same curve with full multiplicity at both ends, so that it starts and ends in control points.
    pub fn clamped(&self) -> Result<Self> {
        let (p, domain) = (self.degree, self.domain());
        let mut knots = self.knots.clone();
        let n = knots.len();
        knots[..p].fill(domain.start);
        knots[n - p..].fill(domain.end);
        self.over_knots(knots)
    }

    /// The same curve with a higher degree; every knot becomes as much more multiple. Ends are clamped first.
    ///
    /// # Errors
    /// The degree wanted is above 31.
    pub fn raised_to(&self, degree: usize) -> Result<Self> {
        if degree > MAX_DEGREE {
            return Err(Error::OutOfRange { what: "degree", value: degree as f64, must: "from 1 to 31" });
        }
        if degree <= self.degree {
            return Ok(self.clone());
        }
        let mut curve = if self.is_clamped() {
            std::borrow::Cow::Borrowed(self)
        } else {
            std::borrow::Cow::Owned(self.clamped()?)
        };
        while curve.degree < degree {
            let mut knots = Vec::with_capacity(2 * curve.knots.len());
            for (i, &k) in curve.knots.iter().enumerate() {
                knots.push(k);
                if curve.knots.get(i + 1) != Some(&k) {
                    knots.push(k);
                }
            }
            let controls = map_controls(
                &curve.controls,
                |p| raised(curve.degree, &curve.knots, p, &knots),
                |p| raised(curve.degree, &curve.knots, p, &knots),
            )
            .ok_or(Error::degenerate("knot vector", "a control point acts on no span"))?;
            curve = std::borrow::Cow::Owned(Self::from_controls(curve.degree + 1, controls, knots)?);
        }
        Ok(curve.into_owned())
    }
}

/// Sets the knots outside the domain so that they repeat those inside.
pub(crate) fn make_knots_periodic(degree: usize, knots: &mut [f64]) {
    let n = knots.len();
    let (first, last) = (degree - 1, n - degree);
    let period = knots[last] - knots[first];
    for i in 1..degree {
        knots[last + i] = knots[first + i] + period;
        knots[first - i] = knots[last - i] - period;
    }
}
