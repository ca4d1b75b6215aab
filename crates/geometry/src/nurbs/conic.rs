//! Arcs, circles and ellipses as exact rational quadratics.

use crate::nurbs::thresholds::OPEN_QUARTER;
use crate::thresholds;
use std::f64::consts::{FRAC_PI_2, TAU};

use katydid_elementary::Elementary;

use super::NurbsCurve;
use crate::{Arc, Circle, Ellipse, Interval, Plane, Result};

/// The conic rx cos, ry sin over a range of angles, with equal spans of at most a quarter turn.
///
/// Each span is a quadratic whose middle control point is where the end tangents meet, with the cosine of half the
/// span's angle as its weight (P&T, *The NURBS Book*, §7.3).
fn conic(plane: &Plane, rx: f64, ry: f64, angle: Interval, domain: Interval) -> Result<NurbsCurve> {
    let sweep = angle.length();
    let spans = Arc::spans_of(sweep);
    let half = sweep / (2 * spans) as f64;
    let weight = half.cosine();
    let at = |theta: f64, w: f64| {
        // Quadrant points of a whole conic are exact: no 6e-17 where a 0 belongs.
        let (sin, cos) = exact_sin_cos(theta);
        let p = plane.at(rx * cos / w, ry * sin / w, 0.0);
        [p.x * w, p.y * w, p.z * w, w]
    };
    let mut points = Vec::with_capacity(2 * spans + 1);
    let mut knots = Vec::with_capacity(2 * spans + 2);
    for i in 0..=2 * spans {
        let theta = if i == 2 * spans { angle.end } else { angle.start + half * i as f64 };
        points.push(at(theta, if i % 2 == 1 { weight } else { 1.0 }));
    }
    if (sweep.abs() - TAU).abs() <= thresholds::WHOLE_TURN
        && let Some(&first) = points.first()
    {
        points[2 * spans] = first;
    }
    for i in 0..=spans {
        let t = domain.at(i as f64 / spans as f64);
        knots.extend([t, t]);
    }
    NurbsCurve::rational(2, points, knots)
}

fn exact_sin_cos(theta: f64) -> (f64, f64) {
    let quarters = theta / FRAC_PI_2;
    if quarters == quarters.round() && quarters.abs() < 1e6 {
        return match (quarters as i64).rem_euclid(4) {
            0 => (0.0, 1.0),
            1 => (1.0, 0.0),
            2 => (0.0, -1.0),
            _ => (-1.0, 0.0),
        };
    }
    theta.sine_cosine()
}

impl Arc {
    /// The spans that the NURBS form of an arc of an angle has: one up to a quarter turn, two up to a half, else four, as
    /// openNURBS has it.
    pub(crate) fn spans_of(angle: f64) -> usize {
        let quarters = angle.abs() / FRAC_PI_2 - OPEN_QUARTER;
        match quarters {
            few if few <= 1.0 => 1,
            few if few <= 2.0 => 2,
            _ => 4,
        }
    }

    /// The exact NURBS form over `domain`: rational of degree 2, one, two or four spans of at most a quarter turn.
    ///
    /// # Errors
    /// The radius is not positive, the arc has no angle, or the domain does not increase.
    pub fn to_nurbs(&self, domain: Interval) -> Result<NurbsCurve> {
        let r = self.circle.radius;
        conic(&self.circle.plane, r, r, self.angle, domain)
    }
}

impl Circle {
    /// The exact NURBS form: rational of degree 2, nine control points, domain 0…2π.
    ///
    /// # Errors
    /// A number is not finite.
    pub fn to_nurbs(&self) -> Result<NurbsCurve> {
        let turn = Interval::new(0.0, TAU);
        conic(&self.plane, self.radius, self.radius, turn, turn)
    }
}

impl Ellipse {
    /// The exact NURBS form: rational of degree 2, nine control points, domain 0…2π.
    ///
    /// # Errors
    /// A number is not finite.
    pub fn to_nurbs(&self) -> Result<NurbsCurve> {
        let turn = Interval::new(0.0, TAU);
        conic(&self.plane, self.rx, self.ry, turn, turn)
    }
}
