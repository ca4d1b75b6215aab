//! Curves cut by the border of a region.

use katydid_elementary::Elementary;

use super::Region;
use super::combine::checked;
use super::sources::in_plane;
use super::winding::{Outline, flat};
use crate::intersect::curve_curve;
use crate::region::thresholds::MEETS_FINE;
use crate::{ClosestOnCurve, Curve, Interval, Result};

/// What a region leaves of a curve.
#[derive(Debug, Clone, PartialEq)]
pub struct TrimmedCurve {
    /// The pieces inside or on the border, in the order of the curve; of a closed curve the one over the seam is last.
    pub inside: Vec<Curve>,
    /// The pieces outside.
    pub outside: Vec<Curve>,
}

/// Places on a stretch of which the one farthest from the border tells where it lies.
const PLACES: [f64; 9] = [0.5, 0.25, 0.75, 0.1, 0.9, 0.37, 0.63, 0.02, 0.98];

impl Region {
    /// The pieces of an open or closed curve inside and outside the region, as seen at right angles to its plane. The
    /// curve itself need not lie there, and its pieces stay where they are. A stretch within the tolerance of the
    /// border counts as inside; the curve is cut only where it goes from one side to the other.
    ///
    /// # Errors
    /// The tolerance is not finite and above 0, or a number overflows.
    pub fn trim(&self, curve: &Curve, tolerance: f64) -> Result<TrimmedCurve> {
        checked(&self.plane, tolerance)?;
        let shadow = in_plane(curve, &self.plane)?;
        let borders = self.curves();
        let domain = shadow.domain();
        let mut stops = vec![domain.start, domain.end];
        for border in &borders {
            // Crossings as exactly as numbers allow; only for stretches along the border the tolerance matters.
            let size = border.start().to_vector().length().max(shadow.start().to_vector().length());
            let fine = (MEETS_FINE * size).min(tolerance);
            let found = curve_curve(&shadow, border, fine)?;
            stops.extend(found.crossings.iter().map(|c| c.a));
            let found = curve_curve(&shadow, border, tolerance)?;
            stops.extend(found.overlaps.iter().flat_map(|o| [o.a.start, o.a.end]));
        }
        stops.sort_by(f64::total_cmp);
        stops.dedup();
        let outlines: Vec<Outline> = borders.iter().map(|c| Outline::new(c, &self.plane)).collect();
        let near: Vec<ClosestOnCurve<'_>> = borders.iter().map(ClosestOnCurve::new).collect();
        let mut runs: Vec<(Interval, bool)> = Vec::new();
        for w in stops.windows(2) {
            let range = Interval::new(w[0], w[1]);
            let mut best = (-1.0, true);
            for x in PLACES {
                let p = shadow.point_at(range.at(x));
                let mut distance = f64::INFINITY;
                for c in &near {
                    distance = distance.min(c.nearest(p)?.distance);
                }
                if distance > best.0 {
                    let at = flat(&self.plane, p);
                    let turns: i32 = outlines.iter().map(|o| o.winding(at)).sum();
                    best = (distance, distance <= tolerance || turns != 0);
                }
            }
            let mut state = best.1;
            // What does not leave the border where others go on from both its ends is no piece.
            let start = shadow.point_at(range.start);
            let short = PLACES.iter().all(|&x| shadow.point_at(range.at(x)).distance_to(start) <= tolerance);
            if short && let Some(before) = runs.last() {
                state = before.1;
            }
            match runs.last_mut() {
                Some(before) if before.1 == state => before.0.end = range.end,
                _ => runs.push((range, state)),
            }
        }
        if shadow.is_closed()
            && runs.len() > 1
            && let (Some(&first), Some(&last)) = (runs.first(), runs.last())
            && first.1 == last.1
        {
            runs.remove(0);
            if let Some(last) = runs.last_mut() {
                last.0.end = first.0.end;
            }
        }
        let mut out = TrimmedCurve { inside: Vec::new(), outside: Vec::new() };
        for (range, inside) in runs {
            let piece = if range == domain {
                curve.clone()
            } else {
                let at = |t: f64| original_parameter(curve, &shadow, t);
                curve.sub_curve(Interval::new(at(range.start), at(range.end)))?
            };
            if inside { &mut out.inside } else { &mut out.outside }.push(piece);
        }
        Ok(out)
    }
}

/// The parameter on a curve that belongs to one on its projection. They differ where a tilted arc became an ellipse.
fn original_parameter(curve: &Curve, shadow: &Curve, t: f64) -> f64 {
    match (curve, shadow) {
        (Curve::Arc(c), Curve::Nurbs(_)) if c.domain.start < t && t < c.domain.end => {
            let Ok(exact) = c.to_nurbs() else { return t };
            let [x, y, _] = c.arc.circle.plane.coordinates(exact.point_at(t));
            let turn = std::f64::consts::TAU;
            let middle = c.arc.angle.middle();
            let angle = y.arctangent_of(x);
            let angle = angle + ((middle - angle) / turn).round() * turn;
            c.domain.at(c.arc.angle.normalized(c.arc.angle.clamp(angle)))
        }
        (Curve::Poly(c), Curve::Poly(s)) => {
            let i = s.segment_at(t);
            match (c.segments().get(i), s.segments().get(i)) {
                (Some(a), Some(b)) => {
                    let own = original_parameter(a, b, s.to_segment_parameter(i, t));
                    c.segment_domain(i).clamp(c.from_segment_parameter(i, own))
                }
                _ => t,
            }
        }
        _ => t,
    }
}
