//! Loops in the parameter plane whose parts lie on sides of the domain.
//!
//! What lies beyond a side of a surface is pulled onto that side, where it may run there and back. It encloses nothing
//! there: only where it begins and ends counts.

use crate::{Curve, Direction, Interval, Line, Point3, PolylineCurve, Result, Surface};

/// Parameters nearer than this part of the domain are one.
const SAME: f64 = 1e-9;

/// A stretch of a loop.
struct Run {
    /// The direction across the side that it lies on, and the parameter of the side.
    side: Option<(Direction, f64)>,
    parts: Vec<Curve>,
    ends: [Point3; 2],
    /// The place on it that is farthest from its start.
    far: Point3,
}

/// A closed curve with straight lines for what lies on the sides of the domain.
pub(super) fn with_straight_sides(surface: &Surface, flat: &Curve) -> Result<Curve> {
    let mut runs: Vec<Run> = Vec::new();
    gather(surface, flat, &mut runs)?;
    if runs.iter().all(|run| run.side.is_none()) {
        return Ok(flat.clone());
    }
    let alone = runs.len() == 1;
    let mut parts: Vec<Curve> = Vec::new();
    for run in runs {
        let [from, to] = run.ends;
        if run.side.is_none() {
            parts.extend(run.parts);
        } else if from != to {
            parts.push(Line::new(from, to).into());
        } else if alone && from != run.far {
            parts.push(PolylineCurve::new(vec![from, run.far, from])?.into());
        }
    }
    Ok(if parts.is_empty() { flat.clone() } else { crate::curve::chained(parts, 0.0) })
}

fn gather(surface: &Surface, flat: &Curve, runs: &mut Vec<Run>) -> Result<()> {
    match flat {
        Curve::Poly(chain) => chain.segments().iter().try_for_each(|part| gather(surface, part, runs)),
        Curve::Nurbs(curve) => {
            let places = curve.span_parameters();
            let sides: Vec<_> = places.windows(2).map(|w| side_of(surface, flat, w[0], w[1])).collect();
            let mut first = 0;
            for last in 1..=sides.len() {
                if last < sides.len() && sides[last] == sides[first] {
                    continue;
                }
                let part = if last - first == sides.len() {
                    flat.clone()
                } else {
                    flat.trimmed(Interval::new(places[first], places[last]))?
                };
                let inner = &places[first..=last];
                add(runs, sides[first], part, inner.iter().map(|t| flat.point_at(*t)));
                first = last;
            }
            Ok(())
        }
        _ => {
            let domain = flat.domain();
            let side = side_of(surface, flat, domain.start, domain.end);
            add(runs, side, flat.clone(), [flat.end()].into_iter());
            Ok(())
        }
    }
}

fn add(
    runs: &mut Vec<Run>,
    side: Option<(Direction, f64)>,
    part: Curve,
    places: impl Iterator<Item = Point3>,
) {
    let ends = [part.start(), part.end()];
    if runs.last().is_none_or(|run| run.side != side) {
        runs.push(Run { side, parts: Vec::new(), ends, far: ends[0] });
    }
    let Some(run) = runs.last_mut() else { return };
    let start = run.ends[0];
    for p in places {
        if p.distance_to(start) > run.far.distance_to(start) {
            run.far = p;
        }
    }
    run.ends[1] = ends[1];
    run.parts.push(part);
}

/// The side of the domain on which a span lies. What a cubic does at five places it does everywhere.
fn side_of(surface: &Surface, flat: &Curve, from: f64, to: f64) -> Option<(Direction, f64)> {
    let places = [0.0, 0.25, 0.5, 0.75, 1.0].map(|x| flat.point_at(from + x * (to - from)));
    Direction::BOTH.into_iter().find_map(|across| {
        let domain = surface.domain(across);
        let least = SAME * domain.length();
        let of = |p: &Point3| if across == Direction::U { p.x } else { p.y };
        [domain.start, domain.end]
            .into_iter()
            .find(|side| places.iter().all(|p| (of(p) - side).abs() <= least))
            .map(|side| (across, side))
    })
}
