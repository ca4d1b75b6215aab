//! Loops cut away.

use super::{OffsetCorner, RawPart};
use crate::curve::join_curves;
use crate::intersect::{curve_curve, curve_self};
use crate::{BoundingBox, Circle, Curve, Interval, Plane, Result, Tolerance};

/// Offsets of more parts than this are not cut at all crossings: the pairs would be too many.
const MOST_PARTS: usize = 20_000;

/// Places on a part, but one, at which its distance is asked for.
const SAMPLES: u32 = 8;

/// The parts that keep their distance from the curve, joined.
pub(super) fn cleaned(
    curve: &Curve,
    raw: Vec<RawPart>,
    plane: &Plane,
    distance: f64,
    tolerance: &Tolerance,
) -> Result<Vec<Curve>> {
    let exact = raw.iter().all(|p| p.exact);
    let reaches: Vec<f64> = raw.iter().map(|p| p.reach).collect();
    let parts: Vec<Curve> = raw.into_iter().map(|p| p.curve).collect();
    let size = curve.bounding_box().diagonal().length() + distance.abs();
    let fine = (1e-10 * size).min(0.01 * tolerance.absolute);
    let mut cuts: Vec<Vec<f64>> = vec![Vec::new(); parts.len()];
    // Stretches on which two parts run over each other: in opposite directions they enclose nothing.
    let mut void: Vec<Vec<Interval>> = vec![Vec::new(); parts.len()];
    let boxes: Vec<BoundingBox> = parts.iter().map(Curve::bounding_box).collect();
    let meet = |a: &BoundingBox, b: &BoundingBox| {
        let (p, q) = ([a.min, a.max], [b.min, b.max]);
        let axis = |f: fn(&crate::Point3) -> f64| f(&p[0]) <= f(&q[1]) + fine && f(&q[0]) <= f(&p[1]) + fine;
        axis(|p| p.x) && axis(|p| p.y) && axis(|p| p.z)
    };
    if parts.len() <= MOST_PARTS {
        for i in 0..parts.len() {
            if !matches!(parts[i], Curve::Line(_) | Curve::Arc(_)) {
                for c in curve_self(&parts[i], fine)?.crossings {
                    cuts[i].extend([c.a, c.b]);
                }
            }
            for j in i + 1..parts.len() {
                if !meet(&boxes[i], &boxes[j]) {
                    continue;
                }
                let found = curve_curve(&parts[i], &parts[j], fine)?;
                for c in &found.crossings {
                    cuts[i].push(c.a);
                    cuts[j].push(c.b);
                }
                for o in &found.overlaps {
                    cuts[i].extend([o.a.start, o.a.end]);
                    cuts[j].extend([o.b.start, o.b.end]);
                    // In one direction, one of them is enough.
                    void[j].push(o.b.ordered());
                    if !o.same_direction {
                        void[i].push(o.a.ordered());
                    }
                }
            }
        }
    }
    let closed = curve.is_closed();
    if !closed || !curve_self(curve, fine)?.is_empty() {
        let mut others: Vec<Curve> = curve
            .raw_offset(plane, -distance, OffsetCorner::Round, tolerance)?
            .into_iter()
            .map(|p| p.curve)
            .collect();
        if !closed {
            for end in [curve.start(), curve.end()] {
                others.push(Circle::new(plane.with_origin(end), distance.abs())?.into());
            }
        }
        let other_boxes: Vec<BoundingBox> = others.iter().map(Curve::bounding_box).collect();
        for (i, part) in parts.iter().enumerate() {
            for (other, bounds) in others.iter().zip(&other_boxes) {
                if meet(&boxes[i], bounds) {
                    let found = curve_curve(part, other, fine)?;
                    cuts[i].extend(found.crossings.iter().map(|c| c.a));
                    cuts[i].extend(found.overlaps.iter().flat_map(|o| [o.a.start, o.a.end]));
                }
            }
        }
    }
    let slack = if exact {
        (1e-6 * distance.abs()).min(tolerance.absolute).max(1e-9 * size)
    } else {
        1.5 * tolerance.absolute
    };
    let mut kept: Vec<Curve> = Vec::new();
    for (i, part) in parts.iter().enumerate() {
        let domain = part.domain();
        let mut ends = std::mem::take(&mut cuts[i]);
        ends.extend([domain.start, domain.end]);
        ends.retain(|&t| domain.contains(t));
        ends.sort_by(f64::total_cmp);
        let near = 1e-9 * domain.length();
        let least = reaches[i] - slack;
        ends.dedup_by(|a, b| (*a - *b).abs() <= near);
        if let Some(last) = ends.last_mut() {
            *last = domain.end;
        }
        let far = |t: f64| -> Result<bool> { Ok(curve.closest_point(part.point_at(t))?.distance >= least) };
        for w in ends.windows(2) {
            let range = Interval::new(w[0], w[1]);
            if void[i].iter().any(|v| v.contains(range.middle())) {
                continue;
            }
            // Between cuts all is far enough or nothing; where samples differ all the same, the change is found.
            let mut from = range.start;
            let mut before: Option<(f64, bool)> = None;
            for k in 0..=SAMPLES {
                let t = range.at((f64::from(k) + 0.5) / f64::from(SAMPLES + 1));
                let now = far(t)?;
                if let Some((last, state)) = before
                    && state != now
                {
                    let (mut low, mut high) = (last, t);
                    for _ in 0..40 {
                        let middle = 0.5 * (low + high);
                        if far(middle)? == state { low = middle } else { high = middle }
                    }
                    if state && from < low {
                        kept.push(part.trimmed(Interval::new(from, low))?);
                    }
                    from = high;
                }
                before = Some((t, now));
            }
            if before.is_some_and(|b| b.1) && from < range.end {
                kept.push(part.trimmed(Interval::new(from, range.end))?);
            }
        }
    }
    let gap = if exact { (10.0 * fine).max(1e-9 * size) } else { 2.0 * tolerance.absolute };
    // What is no longer than the gap would close on itself.
    kept.retain(|c| c.start().distance_to(c.end()) > gap || c.length() > 3.0 * gap);
    let joined = join_curves(&kept, gap, true);
    Ok(joined.into_iter().filter(|c| c.is_closed() || c.length() > gap).collect())
}
