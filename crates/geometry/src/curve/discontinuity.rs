//! Where a curve is not smooth.

use super::Curve;
use super::evaluate::curvature;
use crate::curve::thresholds::{LEAP_OF_CURVATURE, SAME_DERIVATIVE, STRAIGHT_CURVATURE};
use crate::{Tolerance, Vector3};

/// A kind of smoothness.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Continuity {
    /// Position.
    C0,
    /// Position and first derivative.
    C1,
    /// Position, first and second derivative.
    C2,
    /// Position and tangent direction.
    G1,
    /// Position, tangent direction and curvature.
    G2,
    /// Position, and all derivatives up to this order.
    Cn(u8),
    /// Position and all derivatives: every knot at which the polynomial changes lacks it.
    CInfinity,
    /// Position, on the geometric scale.
    G0,
    /// Position, tangent direction, curvature and its rate of change.
    G3,
}

impl Curve {
    /// The parameters at which the curve lacks a kind of continuity, in order. The ends of an open curve are not
    /// among them; the seam of a closed one is, as the start of the domain, when it lacks it there.
    ///
    /// Derivatives and curvatures count as equal within 10⁻⁸ of their size, positions within
    /// `tolerance.absolute`, directions within `tolerance.angle`.
    pub fn discontinuities(&self, kind: Continuity, tolerance: &Tolerance) -> Vec<f64> {
        let domain = self.domain();
        let mut out = Vec::new();
        if self.is_closed() && self.breaks(domain.end, domain.start, kind, tolerance) {
            out.push(domain.start);
        }
        let pieces = self.pieces();
        for piece in pieces.iter().skip(1) {
            let t = piece.whole.start;
            if self.breaks(t, t, kind, tolerance) {
                out.push(t);
            }
        }
        out
    }

    /// Whether the curve that arrives at `below` and leaves at `above` lacks continuity there.
    fn breaks(&self, below: f64, above: f64, kind: Continuity, tolerance: &Tolerance) -> bool {
        if let Continuity::Cn(_) | Continuity::CInfinity | Continuity::G0 | Continuity::G3 = kind {
            return !self.is_continuous_at(above, kind, &tolerance.into());
        }
        let (a, da) = self.derivatives(below, 2, true);
        let (b, db) = self.derivatives(above, 2, false);
        let differ = |x: Vector3, y: Vector3| (x - y).length() > SAME_DERIVATIVE * x.length().max(y.length());
        if a.distance_to(b) > tolerance.absolute {
            return true;
        }
        let turns = || match (self.tangent_on_side(below, true), self.tangent_on_side(above, false)) {
            (Some(a), Some(b)) => a.angle_to(b).is_some_and(|x| x > tolerance.angle),
            _ => false,
        };
        // Second derivatives are differences of first ones: noise of 1e-8 of those is no step.
        let size = da[0].length().max(db[0].length()) / self.domain().length();
        match kind {
            Continuity::C0 | Continuity::G0 | Continuity::G3 | Continuity::Cn(_) | Continuity::CInfinity => {
                false
            }
            Continuity::C1 => differ(da[0], db[0]),
            Continuity::C2 => {
                differ(da[0], db[0])
                    || (differ(da[1], db[1]) && (da[1] - db[1]).length() > SAME_DERIVATIVE * size)
            }
            Continuity::G1 => turns(),
            Continuity::G2 => {
                let (x, y) = (curvature(da[0], da[1]), curvature(db[0], db[1]));
                turns()
                    || (x - y).length() > LEAP_OF_CURVATURE * x.length().max(y.length()) + STRAIGHT_CURVATURE
            }
        }
    }
}
