//! Trims along lines of constant parameter, and which lines are one.

use crate::brep::CurvePart;
use crate::meshing::thresholds::{NARROW_PARTS, NARROWEST, WAVERS};
use crate::{Curve, Interval, Quadrant, Surface};

/// Lines whose distance in space is less than this part of the distance allowed are one.
const NARROW: f64 = 1e-3;

/// How a trim lies in the parameter plane.
pub(super) struct Along {
    /// The direction that stays constant along it, 0 for u and 1 for v, and its value.
    pub(super) aligned: Option<(usize, f64)>,
    /// The ranges of u and v that it reaches.
    pub(super) bounds: [[f64; 2]; 2],
}

/// How far apart in u and in v lines may be and still be one: so that no strip lies between them that is much thinner
/// than the mesh is exact.
pub(super) fn narrow(surface: &Surface, domain: [Interval; 2], distance: f64) -> [f64; 2] {
    const LOOKS: u32 = 4;
    let mut speed = [0.0_f64; 2];
    for i in 0..LOOKS {
        for j in 0..LOOKS {
            let at = |d: usize, k: u32| domain[d].at((f64::from(k) + 0.5) / f64::from(LOOKS));
            let d = surface.derivatives(at(0, i), at(1, j), 1, Quadrant::NorthEast);
            speed = [speed[0].max(d.get(1, 0).length()), speed[1].max(d.get(0, 1).length())];
        }
    }
    [0, 1].map(|d| {
        let length = domain[d].length();
        (NARROW * distance / speed[d]).min(NARROW_PARTS[1] * length).max(NARROW_PARTS[0] * length)
    })
}

/// What a trim runs along: it is aligned when one parameter changes by so little, `narrow`, that it is one line, and
/// then its value is that of the domain's end if that is as near.
pub(super) fn along(
    curve: &Curve,
    part: CurvePart,
    domain: [Interval; 2],
    narrow: [f64; 2],
) -> Option<Along> {
    let part = curve.trimmed(part.range).unwrap_or_else(|_| curve.clone());
    let bounds = part.bounding_box();
    let bounds = [[bounds.min.x, bounds.max.x], [bounds.min.y, bounds.max.y]];
    if bounds.iter().flatten().any(|x| !x.is_finite()) {
        return None;
    }
    let small = [0, 1].map(|d| NARROWEST * domain[d].length());
    let aligned = (0..2).find_map(|d| {
        let [low, high] = bounds[d];
        let long = bounds[1 - d][1] - bounds[1 - d][0];
        // In shares of the domain, a trim that wavers is much longer than it is wide.
        let wide = (high - low) / domain[d].length();
        let wavers = high - low > small[d];
        if high - low > narrow[d]
            || long <= small[1 - d]
            || (wavers && wide > WAVERS * long / domain[1 - d].length())
        {
            return None;
        }
        let middle = 0.5 * (low + high);
        let ends = [domain[d].start, domain[d].end];
        let end = ends.into_iter().find(|end| (middle - end).abs() <= narrow[d].max(4.0 * small[d]));
        Some((d, end.unwrap_or(middle)))
    });
    Some(Along { aligned, bounds })
}

/// The lines of one direction that a grid has to have, in order: both ends of a range, values that trims have, and
/// parameters at which pieces of the surface meet. What is as near to another as `narrow` is that line; trims come
/// before pieces, and the ends before both.
pub(super) fn lines([from, to]: [f64; 2], trims: &[f64], pieces: &[f64], narrow: f64) -> Vec<f64> {
    let mut out = vec![from, to];
    for &t in trims.iter().chain(pieces) {
        let place = out.partition_point(|&x| x < t);
        let near = |k: usize| out.get(k).is_some_and(|x| (x - t).abs() <= narrow);
        if t > from && t < to && !near(place) && !place.checked_sub(1).is_some_and(near) {
            out.insert(place, t);
        }
    }
    out.dedup();
    out
}

/// The line that a value lies on.
pub(super) fn line_of(lines: &[f64], value: f64, narrow: f64) -> f64 {
    let place = lines.partition_point(|&x| x < value);
    let around = [place.checked_sub(1), Some(place)].into_iter().flatten().filter_map(|k| lines.get(k));
    let best = around.copied().min_by(|a, b| (a - value).abs().total_cmp(&(b - value).abs()));
    best.filter(|x| (x - value).abs() <= narrow).unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::{line_of, lines};

    #[test]
    fn lines_that_are_one() {
        let found =
            lines([0.0, 9.0], &[8.0 + 3e-8, 6.0, 6.0 - 1e-15, 9.0 - 1e-9], &[0.0, 6.0, 8.0, 9.0], 1e-6);
        assert_eq!(found, [0.0, 6.0, 8.0 + 3e-8, 9.0]);
        assert_eq!(line_of(&found, 6.0 - 1e-15, 1e-6), 6.0);
        assert_eq!(line_of(&found, 9.0 - 1e-9, 1e-6), 9.0);
        assert_eq!(line_of(&found, 7.0, 1e-6), 7.0);
    }
}
