//! Curves that are no cubics as cubic Béziers within a tolerance.

use katydid_elementary::Elementary;
use katydid_geometry::{Curve, NurbsCurve, Vector3};

use super::path::{Place, place};

/// A piece is halved at most this often.
const HALVINGS: u32 = 12;
/// Places at which a cubic is compared with the curve.
const SAMPLES: u32 = 9;

/// The control points of cubics, each without its first, that follow a curve without kinks. Each has the curve's ends and
/// its derivatives there; it is halved until it is within the tolerance at the same parameters, which is at least its
/// distance, looked at in nine places.
pub(super) fn cubics(curve: &NurbsCurve, tolerance: f64) -> Vec<[Place; 3]> {
    let mut out = Vec::new();
    let domain = curve.domain();
    divide(&curve.clone().into(), [domain.start, domain.end], tolerance, HALVINGS, &mut out);
    out
}

fn divide(curve: &Curve, [from, to]: [f64; 2], tolerance: f64, halvings: u32, out: &mut Vec<[Place; 3]>) {
    let third = (to - from) / 3.0;
    let (start, end) = (curve.point_at(from), curve.point_at(to));
    let derivative = |t: f64, from_below: bool| {
        let mut derivatives = [Vector3::ZERO; 2];
        curve.derivatives_into(t, from_below, &mut derivatives);
        derivatives[1]
    };
    let inner = [start + derivative(from, false) * third, end - derivative(to, true) * third];
    let cubic = [start, inner[0], inner[1], end].map(place);
    let middle = from + (to - from) / 2.0;
    let is_near = (1..=SAMPLES).all(|i| {
        let s = f64::from(i) / f64::from(SAMPLES + 1);
        let [x, y] = at(&cubic, s);
        let [p, q] = place(curve.point_at(from + (to - from) * s));
        (x - p).hypotenuse(y - q) <= tolerance
    });
    if is_near || halvings == 0 || !(from < middle && middle < to) {
        out.push([cubic[1], cubic[2], cubic[3]]);
        return;
    }
    divide(curve, [from, middle], tolerance, halvings - 1, out);
    divide(curve, [middle, to], tolerance, halvings - 1, out);
}

/// A place of a cubic Bézier curve.
fn at(cubic: &[Place; 4], s: f64) -> Place {
    let r = 1.0 - s;
    let shares = [r * r * r, 3.0 * r * r * s, 3.0 * r * s * s, s * s * s];
    [0, 1].map(|i| cubic.iter().zip(shares).map(|(p, share)| p[i] * share).sum())
}
