//! Where a curve meets a plane.

use super::Curve;
use crate::bernstein::{BUDGET, halves};
use crate::curve::thresholds::{LONG_TOUCH, SHORTEST_RANGE, SMALLEST_TOLERANCE};
use crate::thresholds;
use crate::{Error, Interval, Plane, Result};

impl Curve {
    /// The parameters at which the curve meets a plane, in order: all crossings and touches within `tolerance` of it.
    /// A stretch that lies in the plane gives its two ends; [`crate::intersect::curve_plane`] tells them apart.
    ///
    /// # Errors
    /// The plane or the tolerance is not finite.
    pub fn intersect_plane(&self, plane: &Plane, tolerance: f64) -> Result<Vec<f64>> {
        let contacts = self.plane_contacts(plane, tolerance)?;
        let ends = |c: Interval| std::iter::once(c.start).chain((c.end > c.start).then_some(c.end));
        Ok(contacts.into_iter().flat_map(ends).collect())
    }

    /// Where the curve is within `tolerance` of a plane: a range of length 0 for a point, else a stretch.
    ///
    /// Each piece is halved until the Bernstein coefficients of its distance have one sign (nothing to find) or vary
    /// in one direction only (one crossing, found by bisection).
    ///
    /// # Errors
    /// The plane or the tolerance is not finite.
    pub(crate) fn plane_contacts(&self, plane: &Plane, tolerance: f64) -> Result<Vec<Interval>> {
        if !(plane.is_finite() && tolerance.is_finite()) {
            return Err(Error::NotFinite("plane or tolerance"));
        }
        let tolerance = tolerance.max(0.0);
        let [a, b, c, d] = plane.equation();
        // Ranges of parameter within the tolerance of the plane, and how near they come to it.
        let mut hits: Vec<(f64, f64, f64)> = Vec::new();
        for part in self.located_beziers() {
            let distance: Vec<[f64; 2]> =
                part.points.iter().map(|p| [a * p[0] + b * p[1] + c * p[2] + d * p[3], p[3]]).collect();
            for (low, high, best) in near_zero(distance, tolerance) {
                hits.push((part.at(low).1, part.at(high).1, part.at(best).1));
            }
        }
        // Neighbouring ranges are one contact: a crossing at a joint, or a stretch in the plane.
        let mut out: Vec<Interval> = Vec::new();
        let mut open: Option<(f64, f64, Vec<f64>)> = None;
        let join = thresholds::SAME_PARAMETER * self.domain().length();
        let mut close = |contact: Option<(f64, f64, Vec<f64>)>| {
            let Some((low, high, best)) = contact else { return };
            let flat = |t: f64| plane.signed_distance(self.point_at(t)).abs();
            // By the middle too: the stretch may be a whole closed curve.
            let from = self.point_at(low);
            let far = [0.5 * (low + high), high].map(|t| self.point_at(t).distance_to(from));
            let long = far[0].max(far[1]) > LONG_TOUCH * tolerance.max(SMALLEST_TOLERANCE);
            let stays = (0..=16).all(|k| flat(low + (high - low) * f64::from(k) / 16.0) <= tolerance);
            if long && stays {
                out.push(Interval::new(low, high));
            } else if let Some(t) = best.into_iter().min_by(|&x, &y| flat(x).total_cmp(&flat(y))) {
                out.push(Interval::new(t, t));
            }
        };
        for (low, high, best) in hits {
            match &mut open {
                Some((_, end, all)) if low <= *end + join => {
                    *end = end.max(high);
                    all.push(best);
                }
                _ => {
                    close(open.take());
                    open = Some((low, high, vec![best]));
                }
            }
        }
        close(open);
        Ok(out)
    }
}

/// The ranges in 0…1 where a quotient of Bernstein polynomials is within `tolerance` of 0, as unions of small
/// intervals, and in each the place where it is nearest to 0.
fn near_zero(coefficients: Vec<[f64; 2]>, tolerance: f64) -> Vec<(f64, f64, f64)> {
    let mut found: Vec<(f64, f64, f64)> = Vec::new();
    let mut stack = vec![(coefficients, 0.0, 1.0)];
    let mut budget = BUDGET;
    while let Some((c, a, b)) = stack.pop() {
        budget = budget.saturating_sub(1);
        let quotient = |c: &[f64; 2]| c[0] / c[1];
        let above = c.iter().all(|c| quotient(c) > tolerance);
        let below = c.iter().all(|c| quotient(c) < -tolerance);
        if above || below || budget == 0 {
            continue;
        }
        let within = c.iter().all(|c| quotient(c).abs() <= tolerance);
        let monotone = c.windows(2).all(|w| quotient(&w[1]) > quotient(&w[0]))
            || c.windows(2).all(|w| quotient(&w[1]) < quotient(&w[0]));
        let (first, last) = match (c.first(), c.last()) {
            (Some(f), Some(l)) => (quotient(f), quotient(l)),
            _ => continue,
        };
        if monotone && first * last <= 0.0 && !within {
            // One crossing: bisection on the exact polynomials.
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                let value = crate::bernstein::value(&c, middle)[0];
                if (value < 0.0) == (first < 0.0) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            // The ends themselves when they are as near.
            let x = if first == 0.0 {
                0.0
            } else if last == 0.0 {
                1.0
            } else {
                0.5 * (low + high)
            };
            let t = a + (b - a) * x;
            found.push((t, t, t));
            continue;
        }
        if within || b - a < SHORTEST_RANGE {
            let best = if first.abs() <= last.abs() { a } else { b };
            found.push((a, b, best));
            continue;
        }
        let middle = 0.5 * (a + b);
        let (left, right) = halves(&c);
        stack.push((right, middle, b));
        stack.push((left, a, middle));
    }
    found
}
