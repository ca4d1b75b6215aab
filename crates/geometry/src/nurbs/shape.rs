//! Other control points, weights, knots and parameters for the same or nearly the same curve.

use super::NurbsCurve;
use super::refine::make_knots_periodic;
use crate::nurbs::thresholds::STRAIGHT_SPAN;
use crate::{Error, Interval, Point3, Result};

impl NurbsCurve {
    /// The curve of textbook knots (control points + degree + 1 of them): the first and last, which act on nothing,
    /// are dropped.
    ///
    /// # Errors
    /// As [`NurbsCurve::with_weights`], which also gives the weights' rules; no weights mean a non-rational curve.
    pub fn from_textbook_knots(
        degree: usize,
        points: &[Point3],
        weights: Option<&[f64]>,
        knots: &[f64],
    ) -> Result<Self> {
        let wanted = points.len().saturating_add(degree).saturating_add(1);
        if knots.len() != wanted {
            return Err(Error::Invalid {
                what: "knot vector",
                why: format!(
                    "{} control points of degree {degree} need {wanted} knots in the textbook form, got {}",
                    points.len(),
                    knots.len()
                ),
            });
        }
        let inner = knots.get(1..knots.len().saturating_sub(1)).unwrap_or(&[]).to_vec();
        match weights {
            Some(weights) => Self::with_weights(degree, points, weights, inner),
            None => Self::new(degree, points.to_vec(), inner),
        }
    }

    /// The same curve with all these knots inserted at once, each as often as it is listed. A periodic curve stays
    /// periodic.
    ///
    /// # Errors
    /// A knot is outside the domain, or would be repeated more often than the degree.
    pub fn refined(&self, new_knots: &[f64]) -> Result<Self> {
        let domain = self.domain();
        let mut knots = self.knots.clone();
        for &t in new_knots {
            let t = self.snapped(t);
            if !(domain.start <= t && t <= domain.end) {
                return Err(Error::OutOfRange { what: "knot", value: t, must: "inside the curve's domain" });
            }
            let at = knots.partition_point(|&k| k <= t);
            knots.insert(at, t);
        }
        // End knots beyond those that a clamped end has say nothing.
        let (p, n) = (self.degree, knots.len());
        if let Some(i) = knots.windows(p + 1).position(|w| w[0] >= w[p]) {
            return Err(Error::OutOfRange {
                what: "knot multiplicity",
                value: knots.iter().filter(|&&k| k == knots[i]).count() as f64,
                must: "at most the degree",
            });
        }
        let at_ends = new_knots.iter().any(|&t| t == domain.start || t == domain.end);
        if at_ends {
            let inside: Vec<f64> =
                new_knots.iter().copied().filter(|&t| domain.start < t && t < domain.end).collect();
            return self.clamped()?.refined(&inside);
        }
        if self.is_periodic() && n >= 2 * p {
            make_knots_periodic(p, &mut knots);
        }
        self.over_knots(knots)
    }

    /// The curve with control point `i` in another place and its weight kept; on a periodic curve its repetition
    /// moves as well.
    ///
    /// # Errors
    /// There is no such control point, or the place is not finite.
    pub fn with_control_point(&self, i: usize, place: Point3) -> Result<Self> {
        let n = self.point_count();
        if i >= n {
            return Err(Error::OutOfRange {
                what: "control point index",
                value: i as f64,
                must: "less than the number of control points",
            });
        }
        let mut points = self.homogeneous_points();
        let period = if self.is_periodic() { n - self.degree } else { n };
        for k in (i % period..n).step_by(period) {
            let w = points[k][3];
            points[k] = [place.x * w, place.y * w, place.z * w, w];
        }
        if self.is_rational() {
            return Self::rational(self.degree, points, self.knots.clone());
        }
        Self::new(
            self.degree,
            points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect(),
            self.knots.clone(),
        )
    }

    /// The same periodic curve starting at `t`, still periodic: a simple knot is inserted at `t`, and knots and
    /// control points are turned round. The domain starts at `t` and keeps its length.
    ///
    /// # Errors
    /// The curve is not periodic, or `t` is outside its domain.
    pub fn with_periodic_seam(&self, t: f64) -> Result<Self> {
        if !self.is_periodic() {
            return Err(Error::degenerate("NURBS curve", "it is not periodic"));
        }
        let domain = self.domain();
        let curve = self.insert_knot(t, 1)?;
        let t = self.snapped(t);
        let p = self.degree;
        let n = curve.point_count() - p;
        let period = domain.length();
        let inner = &curve.knots[p - 1..=p - 1 + n];
        let at = inner.partition_point(|&k| k < t);
        if at == 0 || at >= n {
            return Ok(curve);
        }
        let mut knots = vec![0.0; curve.knots.len()];
        for i in 0..=n {
            let k = at + i;
            knots[p - 1 + i] = if k <= n { inner[k] } else { inner[k - n] + period };
        }
        make_knots_periodic(p, &mut knots);
        let old = curve.homogeneous_points();
        let points: Vec<[f64; 4]> = (0..n + p).map(|i| old[(i + at) % n]).collect();
        if self.is_rational() {
            return Self::rational(p, points, knots);
        }
        Self::new(p, points.iter().map(|p| Point3::new(p[0], p[1], p[2])).collect(), knots)
    }

    /// Whether the second derivative vanishes at the start and at the end, as in a natural spline: within 10⁻⁸ of the
    /// control polygon's length over the squared span.
    pub fn is_natural(&self) -> [bool; 2] {
        let domain = self.domain();
        let spans = self.span_parameters();
        let width = |a: Option<&f64>, b: Option<&f64>| match (a, b) {
            (Some(a), Some(b)) => b - a,
            _ => domain.length(),
        };
        let first = width(spans.first(), spans.get(1));
        let last = width(spans.len().checked_sub(2).and_then(|i| spans.get(i)), spans.last());
        let size = self.control_polygon_length();
        [(domain.start, false, first), (domain.end, true, last)].map(|(t, below, width)| {
            let (_, d) = self.derivatives(t, 2, below);
            d.get(1).is_some_and(|d| d.length() * width * width <= STRAIGHT_SPAN * size)
        })
    }

    /// The curve whose domain reaches beyond its ends to `range`, by the polynomials of its first and last span:
    /// the extension is as smooth as the span itself.
    ///
    /// # Errors
    /// The range does not hold the domain, or a weight of the extension would not be positive.
    pub fn extended_to(&self, range: Interval) -> Result<Self> {
        let domain = self.domain();
        if !(range.start <= domain.start && domain.end <= range.end && range.is_increasing()) {
            return Err(Error::Invalid {
                what: "extended domain",
                why: format!(
                    "{} to {} does not hold {} to {}",
                    range.start, range.end, domain.start, domain.end
                ),
            });
        }
        let curve = self.clamped()?;
        let (p, n) = (self.degree, curve.knots.len());
        let mut knots = curve.knots.clone();
        knots[..p].fill(range.start);
        knots[n - p..].fill(range.end);
        curve.over_knots(knots)
    }

    /// Whether these numbers make a NURBS curve: the checks of the constructors, without making one.
    ///
    /// # Errors
    /// The reason why not; knots in the textbook form are recognised and named.
    pub fn check(degree: usize, points: &[[f64; 4]], knots: &[f64]) -> Result<()> {
        if knots.len() == points.len().saturating_add(degree).saturating_add(1) && degree > 0 {
            return Err(Error::Invalid {
                what: "knot vector",
                why: format!(
                    "{} knots for {} control points of degree {degree} are the textbook form: drop the first and last",
                    knots.len(),
                    points.len()
                ),
            });
        }
        Self::rational(degree, points.to_vec(), knots.to_vec()).map(|_| ())
    }
}
