//! How smoothly curves run and join, measured.

use super::{Continuity, Curve};
use crate::curve::thresholds::{
    COINCIDENT, DERIVATIVE_FLOOR, DERIVATIVE_NOISE, POINT_NOISE, SAME_CURVATURE, SAME_DERIVATIVE,
    STRAIGHT_END_FLOOR,
};
use crate::{Tolerance, Vector3};

/// What counts as equal when continuity is asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContinuityTolerance {
    /// Distance of points, in model units.
    pub distance: f64,
    /// Angle of tangents, in radians.
    pub angle: f64,
    /// Difference of derivatives by the parameter, as a share of the larger one.
    pub derivative: f64,
    /// Difference of curvature vectors, and of their rates of change, as a share of the larger one.
    pub curvature: f64,
}

impl Default for ContinuityTolerance {
    /// Those of openNURBS: points as its coincidence, 1°, derivatives 10⁻⁸, curvature 10⁻³.
    fn default() -> Self {
        Self {
            distance: COINCIDENT,
            angle: std::f64::consts::PI / 180.0,
            derivative: SAME_DERIVATIVE,
            curvature: SAME_CURVATURE,
        }
    }
}

impl From<&Tolerance> for ContinuityTolerance {
    fn from(t: &Tolerance) -> Self {
        Self { distance: t.absolute, angle: t.angle, ..Self::default() }
    }
}

/// The join of two curves: what differs there, and the orders of continuity that follow on both scales.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct JoinContinuity {
    /// The distance between the end and the start.
    pub distance: f64,
    /// The angle between the tangents in radians; `None` where one has no direction.
    pub angle: Option<f64>,
    /// The curvature vectors of the end and the start.
    pub curvature: [Vector3; 2],
    /// The length of their difference.
    pub curvature_difference: f64,
    /// The length of the difference of the curvature vectors' rates of change by arc length; infinite where one has
    /// none.
    pub curvature_rate_difference: f64,
    /// The lengths of the differences of the first, second and third derivatives by the parameter.
    pub derivative_differences: [f64; 3],
    /// The highest n up to 3 with equal points and derivatives up to order n (Cⁿ); `None` for a gap.
    pub parametric: Option<u8>,
    /// The highest n up to 3 on the geometric scale (Gⁿ): 0 position, 1 tangent direction, 2 curvature vector, 3 its
    /// rate of change by arc length; `None` for a gap.
    pub geometric: Option<u8>,
}

impl Curve {
    /// The continuity of this curve's end with the start of `next`, on both scales and with the measured differences.
    ///
    /// G2 is equality of curvature vectors; equal derivative vectors are C1, a stronger demand than G1.
    pub fn join_continuity(&self, next: &Self, tolerance: &ContinuityTolerance) -> JoinContinuity {
        compare(self, self.domain().end, next, next.domain().start, tolerance)
    }

    /// The continuity at a parameter of this curve, from below to above; at the end of a closed curve over its seam.
    pub fn continuity_at(&self, t: f64, tolerance: &ContinuityTolerance) -> JoinContinuity {
        let domain = self.domain();
        let (mut below, mut above) = (t, t);
        if self.is_closed() && (t <= domain.start || t >= domain.end) {
            (below, above) = (domain.end, domain.start);
        }
        compare(self, below, self, above, tolerance)
    }

    /// The first parameter strictly beyond `from` towards `to`, and up to it, at which the curve lacks a kind of
    /// continuity; with `to` below `from` the search goes down. `None` when there is none.
    ///
    /// Joints of pieces are all there can be, so none is missed. As in openNURBS the ends of an open curve are not
    /// discontinuities, and the seam of a closed one counts where the range ends in it.
    pub fn next_discontinuity(
        &self,
        kind: Continuity,
        from: f64,
        to: f64,
        tolerance: &ContinuityTolerance,
    ) -> Option<f64> {
        let domain = self.domain();
        let pieces = self.pieces();
        let mut joints: Vec<f64> = pieces.iter().skip(1).map(|p| p.whole.start).collect();
        if self.is_closed() {
            joints.extend([domain.start, domain.end]);
        }
        joints.sort_by(f64::total_cmp);
        let forward = from <= to;
        let inside = |t: &f64| if forward { from < *t && *t <= to } else { to <= *t && *t < from };
        let lacks = |t: &f64| !self.continuity_at_order(*t, kind, tolerance);
        let mut inner = joints.into_iter().filter(inside);
        if forward { inner.find(lacks) } else { inner.rev().find(lacks) }
    }

    /// Whether the curve has a kind of continuity at a parameter.
    pub fn is_continuous_at(&self, t: f64, kind: Continuity, tolerance: &ContinuityTolerance) -> bool {
        self.continuity_at_order(t, kind, tolerance)
    }

    fn continuity_at_order(&self, t: f64, kind: Continuity, tolerance: &ContinuityTolerance) -> bool {
        let at_most = |n: u8| {
            // Derivatives of higher order than a polynomial has are all zero.
            let domain = self.domain();
            let seam = self.is_closed() && (t <= domain.start || t >= domain.end);
            let (below, above) = if seam { (domain.end, domain.start) } else { (t, t) };
            let count = usize::from(n);
            let (a, da) = self.derivatives(below, count, true);
            let (b, db) = self.derivatives(above, count, false);
            let span = domain.length();
            let mut scale = 1.0;
            a.distance_to(b) <= tolerance.distance.max(POINT_NOISE * a.to_vector().length())
                && da.iter().zip(&db).all(|(x, y)| {
                    let size = x.length().max(y.length());
                    // Noise of lower derivatives, magnified by the domain, is no difference.
                    let floor = DERIVATIVE_NOISE * scale * da.first().map_or(0.0, |d| d.length());
                    scale *= 8.0 / span;
                    (*x - *y).length() <= tolerance.derivative * size + floor
                })
        };
        let report = || self.continuity_at(t, tolerance);
        match kind {
            Continuity::C0 => at_most(0),
            Continuity::C1 => at_most(1),
            Continuity::C2 => at_most(2),
            Continuity::Cn(n) => at_most(n),
            Continuity::CInfinity => {
                at_most(u8::try_from(self.to_nurbs().map_or(2, |c| c.degree())).unwrap_or(31).max(1))
            }
            Continuity::G0 => report().geometric.is_some(),
            Continuity::G1 => report().geometric >= Some(1),
            Continuity::G2 => report().geometric >= Some(2),
            Continuity::G3 => report().geometric >= Some(3),
        }
    }
}

fn compare(a: &Curve, end: f64, b: &Curve, start: f64, tolerance: &ContinuityTolerance) -> JoinContinuity {
    let (p, da) = a.derivatives(end, 3, true);
    let (q, db) = b.derivatives(start, 3, false);
    let distance = p.distance_to(q);
    let at = |d: &[Vector3], k: usize| d.get(k).copied().unwrap_or(Vector3::ZERO);
    let derivative_differences = [0, 1, 2].map(|k| (at(&da, k) - at(&db, k)).length());
    let angle = match (a.tangent_on_side(end, true), b.tangent_on_side(start, false)) {
        (Some(x), Some(y)) => x.angle_to(y),
        _ => None,
    };
    let curvature = [a.curvature_on_side(end, true), b.curvature_on_side(start, false)];
    let curvature_difference = (curvature[0] - curvature[1]).length();
    let rates = [a.arc_length_derivatives(end, true), b.arc_length_derivatives(start, false)];
    let (rate_difference, rate_size) = match rates {
        [Some([.., x]), Some([.., y])] => ((x - y).length(), x.length().max(y.length())),
        _ => (f64::INFINITY, 0.0),
    };
    let touches = distance <= tolerance.distance || p.coincides(q);
    let bend = curvature[0].length().max(curvature[1].length());
    // A straight end has no curvature to take a share of: what a polyline of the model's size would not show.
    let floor = STRAIGHT_END_FLOOR * (1.0 + bend * bend);
    let geometric = touches.then(|| {
        if !angle.is_some_and(|x| x <= tolerance.angle) {
            0
        } else if !(curvature_difference <= tolerance.curvature * bend + STRAIGHT_END_FLOOR) {
            1
        } else if !(rate_difference <= tolerance.curvature * rate_size + floor) {
            2
        } else {
            3
        }
    });
    let parametric = touches.then(|| {
        let speed = at(&da, 0).length().max(at(&db, 0).length());
        let span = a.domain().length().min(b.domain().length());
        let mut floor = 0.0;
        let mut order = 0;
        for (k, difference) in derivative_differences.iter().enumerate() {
            let size = at(&da, k).length().max(at(&db, k).length());
            if !(*difference <= tolerance.derivative * size + floor) {
                break;
            }
            order += 1;
            floor = DERIVATIVE_FLOOR * speed / span.powi(order);
        }
        u8::try_from(order).unwrap_or(0)
    });
    JoinContinuity {
        distance,
        angle,
        curvature,
        curvature_difference,
        curvature_rate_difference: rate_difference,
        derivative_differences,
        parametric,
        geometric,
    }
}
