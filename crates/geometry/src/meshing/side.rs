//! Trims along lines of constant parameter.

use crate::brep::CurvePart;
use crate::{Curve, Interval};

/// How a trim lies in the parameter plane.
pub(super) struct Along {
    /// The direction that stays constant along it, 0 for u and 1 for v, and its value.
    pub(super) aligned: Option<(usize, f64)>,
    /// The ranges of u and v that it reaches.
    pub(super) bounds: [[f64; 2]; 2],
}

/// What a trim runs along: it is aligned when one parameter changes by no more than rounding, and then its value is
/// that of the domain's end if that is as near.
pub(super) fn along(curve: &Curve, part: CurvePart, domain: [Interval; 2]) -> Option<Along> {
    let part = curve.trimmed(part.range).unwrap_or_else(|_| curve.clone());
    let bounds = part.bounding_box();
    let bounds = [[bounds.min.x, bounds.max.x], [bounds.min.y, bounds.max.y]];
    if bounds.iter().flatten().any(|x| !x.is_finite()) {
        return None;
    }
    let small = [0, 1].map(|d| 1e-8 * domain[d].length());
    let aligned = (0..2).find_map(|d| {
        let [low, high] = bounds[d];
        let long = bounds[1 - d][1] - bounds[1 - d][0];
        if high - low > small[d] || long <= small[1 - d] {
            return None;
        }
        let middle = 0.5 * (low + high);
        let ends = [domain[d].start, domain[d].end];
        let end = ends.into_iter().find(|end| (middle - end).abs() <= 4.0 * small[d]);
        Some((d, end.unwrap_or(middle)))
    });
    Some(Along { aligned, bounds })
}
