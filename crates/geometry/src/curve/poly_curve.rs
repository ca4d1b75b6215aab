use super::Curve;
use crate::{Error, Interval, Point3, Result};

/// Poly-curves may hold poly-curves; this deep and no deeper.
pub(crate) const MAX_NESTING: usize = 32;

/// Curves end to end, as one curve.
///
/// Segment i occupies `parameters[i]`…`parameters[i + 1]`; within it the parameter maps linearly to the segment's
/// own domain. There is at least one segment, and one parameter more than segments, increasing.
#[derive(Debug, Clone, PartialEq)]
pub struct PolyCurve {
    segments: Vec<Curve>,
    parameters: Vec<f64>,
    depth: usize,
}

impl PolyCurve {
    /// The curves one after another, each keeping the length of its own domain, from the first one's start on.
    ///
    /// # Errors
    /// As [`PolyCurve::with_parameters`].
    pub fn new(segments: Vec<Curve>) -> Result<Self> {
        let mut t = segments.first().map_or(0.0, |c| c.domain().start);
        let mut parameters = Vec::with_capacity(segments.len() + 1);
        parameters.push(t);
        for segment in &segments {
            t += segment.domain().length();
            parameters.push(t);
        }
        Self::with_parameters(segments, parameters)
    }

    /// The curves with given parameters at their joints. Whether the ends meet is not asked here: see
    /// [`PolyCurve::largest_gap`].
    ///
    /// # Errors
    /// No segments, a wrong count of parameters, parameters that are not finite or do not increase, or poly-curves
    /// nested more than 32 deep.
    pub fn with_parameters(segments: Vec<Curve>, parameters: Vec<f64>) -> Result<Self> {
        if segments.is_empty() {
            return Err(Error::Invalid { what: "poly-curve", why: "it has no segments".into() });
        }
        if parameters.len() != segments.len() + 1 {
            return Err(Error::Invalid {
                what: "poly-curve",
                why: format!(
                    "{} segments need {} parameters, got {}",
                    segments.len(),
                    segments.len() + 1,
                    parameters.len()
                ),
            });
        }
        if !parameters.iter().all(|t| t.is_finite()) {
            return Err(Error::NotFinite("poly-curve parameter"));
        }
        if parameters.windows(2).any(|w| w[0] >= w[1]) {
            return Err(Error::Invalid { what: "poly-curve", why: "its parameters do not increase".into() });
        }
        let depth =
            1 + segments.iter().map(|s| if let Curve::Poly(p) = s { p.depth } else { 0 }).max().unwrap_or(0);
        if depth > MAX_NESTING {
            return Err(Error::Invalid {
                what: "poly-curve",
                why: format!("it is nested more than {MAX_NESTING} deep"),
            });
        }
        Ok(Self { segments, parameters, depth })
    }

    /// Other segments of the same nesting, known to fit.
    pub(super) fn with_same_depth(&self, segments: Vec<Curve>, parameters: Vec<f64>) -> Self {
        Self { segments, parameters, depth: self.depth }
    }

    /// The segments in order.
    #[inline]
    pub fn segments(&self) -> &[Curve] {
        &self.segments
    }

    /// The parameters at the joints and both ends.
    #[inline]
    pub fn parameters(&self) -> &[f64] {
        &self.parameters
    }

    /// The parameters of start and end.
    pub fn domain(&self) -> Interval {
        match (self.parameters.first(), self.parameters.last()) {
            (Some(&a), Some(&b)) => Interval::new(a, b),
            _ => Interval::UNIT,
        }
    }

    /// The index of the segment that holds `t`: at a joint the one that begins there, outside the domain the first
    /// or last.
    pub fn segment_at(&self, t: f64) -> usize {
        self.parameters.partition_point(|&p| p <= t).saturating_sub(1).min(self.segments.len() - 1)
    }

    /// Where segment `i` lies in the domain.
    pub fn segment_domain(&self, i: usize) -> Interval {
        match (self.parameters.get(i), self.parameters.get(i + 1)) {
            (Some(&a), Some(&b)) => Interval::new(a, b),
            _ => self.domain(),
        }
    }

    /// The parameter on segment `i` that belongs to parameter `t` of the whole.
    pub fn to_segment_parameter(&self, i: usize, t: f64) -> f64 {
        let whole = self.segment_domain(i);
        let own = self.segments.get(i).map_or(Interval::UNIT, Curve::domain);
        if own == whole { t } else { own.at(whole.normalized(t)) }
    }

    /// The parameter of the whole that belongs to parameter `s` on segment `i`.
    pub fn from_segment_parameter(&self, i: usize, s: f64) -> f64 {
        let whole = self.segment_domain(i);
        let own = self.segments.get(i).map_or(Interval::UNIT, Curve::domain);
        if own == whole { s } else { whole.at(own.normalized(s)) }
    }

    /// The point at parameter `t`.
    pub fn point_at(&self, t: f64) -> Point3 {
        let i = self.segment_at(t);
        self.segments[i].point_at(self.to_segment_parameter(i, t))
    }

    /// The largest distance between the end of one segment and the start of the next.
    pub fn largest_gap(&self) -> f64 {
        self.segments.windows(2).map(|w| w[0].end().distance_to(w[1].start())).fold(0.0, f64::max)
    }

    /// Segments and parameters, for code that takes the curve apart.
    pub fn into_parts(self) -> (Vec<Curve>, Vec<f64>) {
        (self.segments, self.parameters)
    }
}
