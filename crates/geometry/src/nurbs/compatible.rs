//! Curves brought to one degree, domain and knot vector.

use super::NurbsCurve;
use crate::thresholds;
use crate::{Error, Interval, Result};

/// The most control points of all curves together: curves that share no knots get those of one another.
const MOST: usize = 10_000_000;

/// The same curves with one degree, one domain and one knot vector, all rational when one of them is.
///
/// The degree is the highest, the domain the longest (the first of several), and the knots are all that any of them
/// has; knots nearer than 1e-9 of the domain's length to one another become one. Ends are clamped. The point sets do
/// not change; parameters of curves that were given another domain are mapped linearly. This is how openNURBS
/// prepares two curves for a ruled surface.
///
/// # Errors
/// There is no curve, knots that fall together would be repeated more often than the degree, or the curves share so few
/// knots that they would have more than ten million control points.
pub fn compatible_curves(curves: &[NurbsCurve]) -> Result<Vec<NurbsCurve>> {
    let first = curves.first().ok_or(Error::degenerate("curves", "there are none"))?;
    let degree = curves.iter().map(NurbsCurve::degree).max().unwrap_or(1);
    let rational = curves.iter().any(NurbsCurve::is_rational);
    let domain = curves
        .iter()
        .map(NurbsCurve::domain)
        .fold(first.domain(), |best, d| if d.length() > best.length() { d } else { best });
    let mut same = Vec::with_capacity(curves.len());
    for curve in curves {
        let curve = curve.raised_to(degree)?.with_domain(domain)?.clamped()?;
        same.push(if rational { curve.to_rational() } else { curve });
    }
    let knots = common_knots(&mut same, degree, domain)?;
    same.iter()
        .map(|c| if c.knots() == knots { Ok(c.clone()) } else { c.over_knots(knots.clone()) })
        .collect()
}

/// Moves knots that are nearly equal together and returns the union of all knot vectors.
fn common_knots(curves: &mut [NurbsCurve], degree: usize, domain: Interval) -> Result<Vec<f64>> {
    let tolerance = thresholds::SAME_PARAMETER * domain.length();
    let mut values: Vec<f64> = curves
        .iter()
        .flat_map(|c| c.span_parameters())
        .filter(|&t| domain.start < t && t < domain.end)
        .collect();
    values.sort_by(f64::total_cmp);
    let mut places: Vec<f64> = Vec::new();
    for t in values {
        if places.last().is_none_or(|&last| t - last > tolerance) {
            places.push(t);
        }
    }
    let points = places.len().saturating_add(degree + 1).saturating_mul(curves.len());
    if points > MOST {
        let what = "count of control points over common knots";
        return Err(Error::OutOfRange { what, value: points as f64, must: "at most 10,000,000" });
    }
    let mut multiplicities = vec![0; places.len()];
    for curve in curves.iter_mut() {
        let mut knots = curve.knots().to_vec();
        let mut counts = vec![0; places.len()];
        for k in &mut knots {
            // The last place not above the knot is the one it was merged into.
            let i = places.partition_point(|p| p <= k);
            if let Some(&place) = i.checked_sub(1).and_then(|i| places.get(i))
                && *k - place <= tolerance
            {
                *k = place;
                if let Some(count) = counts.get_mut(i - 1) {
                    *count += 1;
                }
            }
        }
        if knots != curve.knots() {
            *curve = NurbsCurve::from_controls(degree, curve.controls.clone(), knots)?;
        }
        for (all, own) in multiplicities.iter_mut().zip(counts) {
            *all = own.max(*all);
        }
    }
    let inner = places.iter().zip(multiplicities).flat_map(|(&t, count)| std::iter::repeat_n(t, count));
    let ends = |t: f64| std::iter::repeat_n(t, degree);
    Ok(ends(domain.start).chain(inner).chain(ends(domain.end)).collect())
}
