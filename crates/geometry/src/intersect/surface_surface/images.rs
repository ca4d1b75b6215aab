//! The images of a curve that lies on two surfaces, in the domains of both.

use katydid_elementary::Elementary;

use super::sheet::Sheet;
use super::{BranchKind, SurfaceBranch};
use crate::chart::thresholds::{BESIDE_POLE, RATE};
use crate::{Curve, Interval, NurbsCurve, Point3, Result, Vector3, cancellation};

/// Steps are not shorter than this part of the domain: what then is not exact has a leap in it.
const SHORTEST: f64 = 1e-10;
/// More places than this do not make an image exact.
const MOST: usize = 20_000;
/// So many places between two of the image's are measured.
const TESTED: usize = 4;
/// An arc is looked at in parts of no more than an eighth of a turn.
const ARC: f64 = std::f64::consts::FRAC_PI_4;

/// A place of the image: the curve's parameter, the surface's, and their derivative by the first.
#[derive(Debug, Clone, Copy)]
struct Place {
    t: f64,
    uv: [f64; 2],
    slope: [f64; 2],
}

impl Place {
    /// The surface's parameters on the tangent.
    fn ahead(&self, t: f64) -> [f64; 2] {
        [0, 1].map(|k| self.uv[k] + self.slope[k] * (t - self.t))
    }
}

/// A curve on both surfaces as a branch, its images within `target` of it; `None` when they cannot be made that exact.
///
/// # Errors
/// The work was stopped, or a number is not finite.
pub(super) fn branch(
    curve: Curve,
    kind: BranchKind,
    closed: bool,
    sheets: &mut [Sheet<'_>; 2],
    target: f64,
) -> Result<Option<SurfaceBranch>> {
    let (mut parameters, mut deviation) = (Vec::with_capacity(2), 0.0_f64);
    for sheet in sheets.iter_mut() {
        let Some((image, off)) = image(&curve, sheet, target)? else { return Ok(None) };
        parameters.push(image);
        deviation = deviation.max(off);
    }
    let Ok(parameters) = <[NurbsCurve; 2]>::try_from(parameters) else { return Ok(None) };
    Ok(Some(SurfaceBranch { curve, parameters, deviation, closed, kind }))
}

/// The curve, or its reverse, so that it runs along the product of the normals; as it is where that is 0.
///
/// # Errors
/// The work was stopped, or a number is not finite.
pub(super) fn oriented(curve: Curve, sheets: &mut [Sheet<'_>; 2]) -> Result<Curve> {
    let middle = curve.domain().at(MIDDLE);
    let p = curve.point_at(middle);
    let mut normals = [None; 2];
    for (normal, sheet) in normals.iter_mut().zip(sheets.iter_mut()) {
        let (uv, _) = sheet.nearest(p, None)?;
        *normal = sheet.normal(uv);
    }
    if let [Some(m), Some(n)] = normals
        && m.cross(n).length() > RATE
        && velocity(&curve, middle).dot(m.cross(n)) < 0.0
    {
        return reversed(&curve);
    }
    Ok(curve)
}

/// Where a curve is looked at to tell something of all of it: not in its middle, which may be a special place by symmetry.
pub(super) const MIDDLE: f64 = 0.4781;

/// The curve walked the other way, over the range of its lengths from 0.
pub(super) fn reversed(curve: &Curve) -> Result<Curve> {
    curve.reversed().with_domain(Interval::new(0.0, curve.domain().length()))
}

pub(super) fn velocity(curve: &Curve, t: f64) -> Vector3 {
    let from_below = t >= curve.domain().end;
    curve.derivatives(t, 1, from_below).1.first().copied().unwrap_or(Vector3::ZERO)
}

/// The image of a curve in the domain of one surface (z is 0), with the same parameter, and the largest distance between its
/// place on the surface and the curve; `None` when it does not come within `target`.
///
/// # Errors
/// The work was stopped, or a number is not finite.
pub(super) fn image(curve: &Curve, sheet: &mut Sheet<'_>, target: f64) -> Result<Option<(NurbsCurve, f64)>> {
    let domain = curve.domain();
    let ts = breaks(curve);
    // From a place inside, where no pole is, towards both ends.
    let first = (ts.len() - 1) / 2;
    let middle = Interval::new(ts[first], ts[first + 1]).at(MIDDLE);
    let Some(start) = place(curve, sheet, middle, None, domain)? else { return Ok(None) };
    let back: Vec<f64> = ts[..=first].iter().rev().copied().collect();
    let Some((before, off)) = walked(curve, sheet, start, &back, target)? else { return Ok(None) };
    let Some((after, other)) = walked(curve, sheet, start, &ts[first + 1..], target)? else {
        return Ok(None);
    };
    let places: Vec<Place> = before.into_iter().rev().chain([start]).chain(after).collect();
    let points: Vec<Point3> = places.iter().map(|p| Point3::new(p.uv[0], p.uv[1], 0.0)).collect();
    let slopes: Vec<Vector3> = places.iter().map(|p| Vector3::new(p.slope[0], p.slope[1], 0.0)).collect();
    let ts: Vec<f64> = places.iter().map(|p| p.t).collect();
    Ok(Some((NurbsCurve::hermite_through(&points, &slopes, &ts)?, off.max(other))))
}

/// The places from one through all stops, so near to each other that the cubics between them are exact, and how far they are
/// off. A step is made shorter until it is: so near to a pole the parameter that turns is followed on the right turn.
fn walked(
    curve: &Curve,
    sheet: &mut Sheet<'_>,
    start: Place,
    stops: &[f64],
    target: f64,
) -> Result<Option<(Vec<Place>, f64)>> {
    let domain = curve.domain();
    let shortest = SHORTEST * domain.length();
    let (mut out, mut deviation, mut from) = (Vec::new(), 0.0_f64, start);
    for stop in stops.iter().copied().filter(|t| *t != start.t) {
        let mut step = stop - from.t;
        while from.t != stop {
            cancellation::check()?;
            let is_last = step.abs() >= (stop - from.t).abs();
            let t = if is_last { stop } else { from.t + step };
            let to = place(curve, sheet, t, Some(from.ahead(t)), domain)?;
            let off = to.map_or(f64::INFINITY, |to| measured(curve, sheet, &from, &to));
            if let Some(to) = to
                && off <= target
            {
                deviation = deviation.max(off);
                out.push(to);
                from = to;
                // The error of a cubic grows with the fourth power.
                step *= (0.5 * target / off.max(f64::MIN_POSITIVE)).raised_to(0.25).clamp(0.5, 2.0);
            } else {
                step = 0.5 * (t - from.t);
                if !(step.abs() >= shortest) || out.len() > MOST {
                    return Ok(None);
                }
            }
        }
    }
    Ok(Some((out, deviation)))
}

/// The largest distance of the cubic between two places from the curve, where it is measured.
fn measured(curve: &Curve, sheet: &Sheet<'_>, from: &Place, to: &Place) -> f64 {
    (0..TESTED)
        .map(|j| {
            let share = (j as f64 + 0.5) / TESTED as f64;
            let t = from.t + share * (to.t - from.t);
            sheet.point(cubic(from, to, share)).distance_to(curve.point_at(t))
        })
        .fold(0.0, |a, b| if b > a || b.is_nan() { b } else { a })
}

fn cubic(from: &Place, to: &Place, t: f64) -> [f64; 2] {
    let (s, h) = (1.0 - t, to.t - from.t);
    [0, 1].map(|k| {
        from.uv[k] * (s * s * (1.0 + 2.0 * t))
            + to.uv[k] * (t * t * (3.0 - 2.0 * t))
            + (from.slope[k] * (s * s * t) - to.slope[k] * (t * t * s)) * h
    })
}

/// The parameters between which the curve and its image are smooth and turn by no more than an eighth.
fn breaks(curve: &Curve) -> Vec<f64> {
    let domain = curve.domain();
    let even = |n: usize| -> Vec<f64> {
        (0..=n).map(|i| if i == n { domain.end } else { domain.at(i as f64 / n as f64) }).collect()
    };
    match curve {
        Curve::Line(_) => even(1),
        Curve::Arc(arc) => even((arc.arc.angle.length().abs() / ARC).ceil().max(1.0) as usize),
        Curve::Nurbs(nurbs) => {
            let mut ts = nurbs.knots().to_vec();
            ts.retain(|t| *t > domain.start && *t < domain.end);
            ts.extend([domain.start, domain.end]);
            ts.sort_by(f64::total_cmp);
            ts.dedup();
            ts
        }
        _ => even(8),
    }
}

/// The place at a parameter; near a pole at an end of the curve the limit of the places beside it.
fn place(
    curve: &Curve,
    sheet: &mut Sheet<'_>,
    t: f64,
    known: Option<[f64; 2]>,
    domain: Interval,
) -> Result<Option<Place>> {
    let p = curve.point_at(t);
    let (uv, _) = sheet.nearest(p, known)?;
    if let Some(slope) = sheet.slope(uv, p, velocity(curve, t)) {
        return Ok(Some(Place { t, uv, slope }));
    }
    let beside = t + (domain.middle() - t).signum() * BESIDE_POLE * domain.length();
    let p = curve.point_at(beside);
    let (near, _) = sheet.nearest(p, known)?;
    let Some(slope) = sheet.slope(near, p, velocity(curve, beside)) else { return Ok(None) };
    // The parameter across the pole's side is that of the side; the other goes on as it does beside.
    let at = Place { t: beside, uv: near, slope }.ahead(t);
    let domains = crate::Direction::BOTH.map(|d| sheet.surface.domain(d));
    let uv = [0, 1].map(|k| {
        if sheet.surface.is_closed(crate::Direction::BOTH[k]) { at[k] } else { domains[k].clamp(at[k]) }
    });
    Ok(Some(Place { t, uv, slope }))
}
