use crate::{Curve, Interval, Point3, Vector3};

/// The part of a curve that an edge or trim runs along.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CurvePart {
    /// The curve's place in its list; none for an edge or trim that has no curve.
    pub curve: Option<usize>,
    /// The part of the curve's domain.
    pub range: Interval,
    /// Whether it is run against the curve.
    pub reversed: bool,
    /// The domain of the edge or trim itself, which maps linearly onto `range`: backwards when reversed.
    pub domain: Interval,
}

impl CurvePart {
    /// The whole of a curve, forwards, over the curve's own domain.
    pub fn whole(curve: usize, domain: Interval) -> Self {
        Self { curve: Some(curve), range: domain, reversed: false, domain }
    }

    /// The curve's parameter for a parameter of the part.
    pub fn to_curve_parameter(&self, t: f64) -> f64 {
        if !self.reversed && self.range == self.domain {
            return t;
        }
        let x = self.domain.normalized(t);
        self.range.at(if self.reversed { 1.0 - x } else { x })
    }

    /// The point at a parameter of the part.
    pub(super) fn point_at(&self, curve: &Curve, t: f64) -> Point3 {
        curve.point_at(self.to_curve_parameter(t))
    }

    /// The unit tangent at the start or the end, in the part's own sense.
    pub(super) fn end_tangent(&self, curve: &Curve, at_end: bool) -> Option<Vector3> {
        let t = self.to_curve_parameter(if at_end { self.domain.end } else { self.domain.start });
        // What lies beyond the part does not count.
        let tangent = curve.tangent_on_side(t, at_end != self.reversed)?;
        Some(if self.reversed { -tangent } else { tangent })
    }
}
