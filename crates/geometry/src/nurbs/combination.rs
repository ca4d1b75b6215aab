//! Curves added up by shares.

use super::NurbsCurve;
use super::compatible::compatible_curves;
use super::thresholds::SAME_WEIGHTS;
use crate::{Error, Point3, Result};

/// Curves with weights of their own are replaced by curves of this degree at least: cubics bend as they do.
const FITTED_DEGREE: usize = 3;

/// The affine combination of curves at equal parameters: its point at every parameter is the sum of their points there
/// times their shares, which shall add up to 1. Curves over other domains are mapped to the longest.
///
/// It is exact where the curves have the same weights over their common knots, as all have that are not rational and
/// circles of one start: then control points add up. The points of curves with different weights do not: their sum has
/// the product of all denominators. Rational ones are then replaced by polynomials within `tolerance`, as a sum of
/// homogeneous points leaves the mean and kinks at knots.
///
/// # Errors
/// There is no curve, the curves cannot be made compatible ([`compatible_curves`]) or not be fitted
/// ([`NurbsCurve::refit`]), or a share is not finite.
pub fn combined_curves(parts: &[(NurbsCurve, f64)], tolerance: f64) -> Result<NurbsCurve> {
    let curves: Vec<NurbsCurve> = parts.iter().map(|(curve, _)| curve.clone()).collect();
    let mut same = compatible_curves(&curves)?;
    if !have_same_weights(&same) {
        // Shares beyond 0 to 1 enlarge what the fits miss.
        let reach = parts.iter().map(|(_, share)| share.abs()).sum::<f64>().max(1.0);
        let plain: Vec<NurbsCurve> =
            curves.iter().map(|curve| without_weights(curve, tolerance / reach)).collect::<Result<_>>()?;
        same = compatible_curves(&plain)?;
    }
    let first = same.first().ok_or(Error::degenerate("curves", "there are none"))?;
    let mut sums = vec![[0.0; 3]; first.point_count()];
    for (curve, (_, share)) in same.iter().zip(parts) {
        for (sum, point) in sums.iter_mut().zip(curve.control_points()) {
            for (x, own) in sum.iter_mut().zip([point.x, point.y, point.z]) {
                *x += own * share;
            }
        }
    }
    let points: Vec<Point3> = sums.into_iter().map(Point3::from).collect();
    let knots = first.knots().to_vec();
    if !first.is_rational() {
        return NurbsCurve::new(first.degree(), points, knots);
    }
    let curve = NurbsCurve::with_weights(first.degree(), &points, &first.weights(), knots)?;
    Ok(curve.to_non_rational().unwrap_or(curve))
}

/// Whether compatible curves have the same weights but for a factor of each.
fn have_same_weights(curves: &[NurbsCurve]) -> bool {
    let shares = |curve: &NurbsCurve| -> Vec<f64> {
        let weights = curve.weights();
        let first = weights.first().copied().unwrap_or(1.0);
        weights.into_iter().map(|w| w / first).collect()
    };
    let mut all = curves.iter().map(shares);
    let first = all.next().unwrap_or_default();
    let same = |(a, b): (&f64, &f64)| (a - b).abs() <= SAME_WEIGHTS * a.abs().max(b.abs());
    all.all(|weights| first.iter().zip(&weights).all(same))
}

/// A polynomial curve within the tolerance of this one at every parameter, with its derivatives at both ends, so that
/// what closes smoothly still does.
fn without_weights(curve: &NurbsCurve, tolerance: f64) -> Result<NurbsCurve> {
    if let Some(plain) = curve.to_non_rational() {
        return Ok(plain);
    }
    let source = curve.clamped()?;
    let fitted = source.refit(source.degree().max(FITTED_DEGREE), 0.5 * tolerance)?.curve;
    let ended = with_end_derivatives(&fitted, &source)?;
    Ok(if source.deviation_from(&ended)? <= tolerance { ended } else { fitted })
}

/// A clamped curve whose second control points from either end give it the first derivatives of another one there.
fn with_end_derivatives(curve: &NurbsCurve, source: &NurbsCurve) -> Result<NurbsCurve> {
    let (domain, degree) = (curve.domain(), curve.degree());
    let slope = |t: f64, below: bool| {
        let (place, derivatives) = source.derivatives(t, 1, below);
        derivatives.first().map(|slope| (place, *slope))
    };
    let spans = curve.span_parameters();
    let (Some(start), Some(end), [first, second, ..], [.., before, last]) =
        (slope(domain.start, false), slope(domain.end, true), spans.as_slice(), spans.as_slice())
    else {
        return Ok(curve.clone());
    };
    // A clamped curve leaves its end at degree / span times its first step.
    let step = |from: f64, to: f64| (to - from) / degree as f64;
    let next = start.0 + start.1 * step(*first, *second);
    let previous = end.0 - end.1 * step(*before, *last);
    curve.with_control_point(1, next)?.with_control_point(curve.point_count() - 2, previous)
}
