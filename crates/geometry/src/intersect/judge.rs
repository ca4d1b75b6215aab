//! What the control points of two parts of curves prove about their meeting.
//!
//! A Bézier curve with positive weights lies in the hull of its control points, and every chord of it is a sum of
//! the differences of consecutive ones with factors of at least 0 (also with weights: the quotients of its weighted
//! Bernstein polynomials are monotone). Hence: hulls apart, nothing in common; no difference of one parallel to one
//! of the other, at most one point in common (T. Sederberg and R. Meyers, *Loop detection in surface patch
//! intersections*, 1988, have the argument for surfaces).

use super::thresholds::NO_PLANE_SQUARED;
use crate::Vector3;

/// The verdict on a pair of parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Verdict {
    /// Further apart than the tolerance.
    Apart,
    /// At most one common point; the guess is the parameters, 0…1, at which the chords meet.
    Single(f64, f64),
    /// Both run along `along` or, the second, against it, and come within reach only where one begins and the other
    /// ends. The flags say which end of each: `true` for its last point.
    Corner(bool, bool),
    /// Both run along `along` (the second against it when `opposite`), side by side from `low` to `high`.
    Parallel { along: Vector3, opposite: bool, low: f64, high: f64 },
    /// Nothing proved: halve.
    Unclear,
}

/// The least and greatest p·d.
#[inline]
fn extent(points: &[Vector3], d: Vector3) -> (f64, f64) {
    points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| {
        let x = p.dot(d);
        (l.min(x), h.max(x))
    })
}

/// Whether two hulls are further apart than `reach` along `d`.
#[inline]
pub(super) fn separated(a: &[Vector3], b: &[Vector3], d: Vector3, reach: f64) -> bool {
    let squared = d.length_squared();
    if !(squared > 0.0) || !squared.is_finite() {
        return false;
    }
    let ((la, ha), (lb, hb)) = (extent(a, d), extent(b, d));
    let gap = (lb - ha).max(la - hb);
    gap > 0.0 && gap * gap > reach * reach * squared
}

/// Whether all differences of consecutive points lead along `d`, at most 60° off.
pub(super) fn runs_along(points: &[Vector3], d: Vector3, sign: f64) -> bool {
    points.windows(2).all(|w| {
        let v = w[1] - w[0];
        let along = sign * v.dot(d);
        along >= 0.0 && along * along >= 0.25 * v.length_squared() * d.length_squared()
    })
}

/// Whether no difference of `a` is parallel to one of `b`, proved by the normal of their chords.
#[inline]
fn cones_apart(a: &[Vector3], b: &[Vector3], n: Vector3) -> bool {
    if !(n.length_squared() > 0.0) {
        return false;
    }
    let mut rows = [Vector3::ZERO; crate::nurbs::MAX_DEGREE + 1];
    let mut count = 0;
    for w in a.windows(2) {
        let v = w[1] - w[0];
        if v != Vector3::ZERO {
            rows[count] = v;
            count += 1;
        }
    }
    b.windows(2).all(|w| {
        let v = w[1] - w[0];
        if v == Vector3::ZERO {
            return true;
        }
        let m = v.cross(n);
        let bound = m.length_squared() * NO_PLANE_SQUARED;
        rows[..count].iter().all(|u| {
            let x = u.dot(m);
            x > 0.0 && x * x > bound * u.length_squared()
        })
    })
}

/// Judges two parts by their control points; `reach` is the tolerance.
pub(super) fn judge(a: &[Vector3], b: &[Vector3], reach: f64) -> Verdict {
    let (&[a0, .., a1], &[b0, .., b1]) = (a, b) else { return Verdict::Unclear };
    let (ca, cb) = (a1 - a0, b1 - b0);
    let (la, lb) = (ca.length_squared(), cb.length_squared());
    // Rotated boxes: across each chord, in the direction of the other part.
    let between = (b0 + b1 - a0 - a1) * 0.5;
    for (c, squared) in [(ca, la), (cb, lb)] {
        if squared > 0.0 && separated(a, b, between - c * (between.dot(c) / squared), reach) {
            return Verdict::Apart;
        }
    }
    let n = ca.cross(cb);
    let nn = n.length_squared();
    if nn > NO_PLANE_SQUARED * la * lb && cones_apart(a, b, n) {
        let w = b0 - a0;
        let (s, t) = (w.cross(cb).dot(n) / nn, w.cross(ca).dot(n) / nn);
        return Verdict::Single(s, t);
    }
    side_by_side(a, b, reach)
}

/// What two parts prove that run in one direction: [`Verdict::Corner`], [`Verdict::Parallel`], [`Verdict::Apart`], or
/// nothing.
pub(super) fn side_by_side(a: &[Vector3], b: &[Vector3], reach: f64) -> Verdict {
    let (&[a0, .., a1], &[b0, .., b1]) = (a, b) else { return Verdict::Unclear };
    let (Some(ua), Some(ub)) = ((a1 - a0).unitized(), (b1 - b0).unitized()) else { return Verdict::Unclear };
    let opposite = ua.dot(ub) < 0.0;
    let sign = if opposite { -1.0 } else { 1.0 };
    let Some(along) = (ua + ub * sign).unitized() else { return Verdict::Unclear };
    if !(runs_along(a, along, 1.0) && runs_along(b, along, sign)) {
        return Verdict::Unclear;
    }
    let (a0, a1) = (a0.dot(along), a1.dot(along));
    let (b0, b1) = if opposite { (b1.dot(along), b0.dot(along)) } else { (b0.dot(along), b1.dot(along)) };
    let (low, high) = (a0.max(b0), a1.min(b1));
    if high - low < -reach {
        Verdict::Apart
    } else if high - low <= reach {
        // One ends where the other begins.
        let a_first = a1 - b0 <= b1 - a0;
        Verdict::Corner(a_first, a_first == opposite)
    } else {
        Verdict::Parallel { along, opposite, low, high }
    }
}
