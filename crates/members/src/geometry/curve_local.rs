//! Curves near a parameter, and which conic section a curve is.

use katydid_geometry::{Curve, Interval, Point3, Vector3};

use super::answer::Outcome;
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("curve/getlocalperppoint-curve_point3d_double_double", |c: Curve, p: Point3, seed: f64| {
        root(&c, seed, c.domain(), |t| perpendicular(&c, p, t))
    });
    table.add(
        "curve/getlocalperppoint-curve_point3d_double_interval_double",
        |c: Curve, p: Point3, seed: f64, part: Interval| root(&c, seed, part, |t| perpendicular(&c, p, t)),
    );
    table.add("curve/getlocaltangentpoint-curve_point3d_double_double", |c: Curve, p: Point3, seed: f64| {
        tangent(&c, p, seed, c.domain())
    });
    table.add(
        "curve/getlocaltangentpoint-curve_point3d_double_interval_double",
        |c: Curve, p: Point3, seed: f64, part: Interval| tangent(&c, p, seed, part),
    );
    table.add("curve/getconicsectiontype-curve", |c: Curve| Ok(conic(&c)));
}

/// Between knots a function is looked at in so many places.
const PLACES: usize = 32;
/// What is so small beside the sizes that it comes from is none.
const ROUNDING: f64 = 1e-12;

/// What is 0 where the way to a point is at right angles to the curve, and how large it may be at most.
fn perpendicular(curve: &Curve, p: Point3, t: f64) -> (f64, f64) {
    let (at, way, speed) = there(curve, p, t);
    (way.dot(speed), (way.length() + at.to_vector().length()) * speed.length())
}

/// The way from a point to the curve, and the curve's direction there.
fn there(curve: &Curve, p: Point3, t: f64) -> (Point3, Vector3, Vector3) {
    let (at, derivatives) = curve.derivatives(t, 1, false);
    (at, at - p, derivatives.first().copied().unwrap_or(Vector3::ZERO))
}

/// Where a tangent of a planar curve leads through a point of its plane; elsewhere none does, as a rule.
fn tangent(curve: &Curve, p: Point3, seed: f64, part: Interval) -> Outcome<(bool, Option<f64>)> {
    let size = curve.bounding_box().diagonal().length() + p.distance_to(curve.start());
    let flat = curve.plane(1e-9 * size).filter(|plane| plane.signed_distance(p).abs() <= 1e-6 * size);
    let Some(plane) = flat else { return Ok((false, None)) };
    root(curve, seed, part, |t| {
        let (at, way, speed) = there(curve, p, t);
        (way.cross(speed).dot(plane.z_axis), (way.length() + at.to_vector().length()) * speed.length())
    })
}

/// The parameter nearest to a seed where a function is 0, if there is one in a part of the curve: signs that change
/// between places are halved between.
fn root(
    curve: &Curve,
    seed: f64,
    part: Interval,
    function: impl Fn(f64) -> (f64, f64),
) -> Outcome<(bool, Option<f64>)> {
    let (own, part) = (curve.domain(), part.ordered());
    let (low, high) = (part.start.max(own.start), part.end.min(own.end));
    if low >= high {
        return Err(Fault::bad_request("subDomain has nothing in common with the curve's domain"));
    }
    let is_zero = |t: f64| {
        let (value, most) = function(t);
        value.abs() <= ROUNDING * most
    };
    let seed = seed.clamp(low, high);
    if is_zero(seed) {
        return Ok((true, Some(seed)));
    }
    let knots = curve.to_nurbs()?.span_parameters();
    let inner = knots.iter().copied().filter(|t| *t > low && *t < high);
    let stops: Vec<f64> = [low].into_iter().chain(inner).chain([high]).collect();
    let mut found: Option<f64> = None;
    let mut take = |t: f64| {
        if found.is_none_or(|best| (t - seed).abs() < (best - seed).abs()) {
            found = Some(t);
        }
    };
    for pair in stops.windows(2) {
        let [from, to] = *pair else { continue };
        let place = |k: usize| from + (to - from) * k as f64 / PLACES as f64;
        for k in 0..PLACES {
            let (a, b) = (place(k), place(k + 1));
            for end in [a, b] {
                if is_zero(end) {
                    take(end);
                }
            }
            if function(a).0 * function(b).0 < 0.0 {
                take(halved(a, b, |t| function(t).0));
            }
        }
    }
    Ok((found.is_some(), found))
}

/// Where a function that has different signs at two places is 0 between them.
fn halved(mut low: f64, mut high: f64, function: impl Fn(f64) -> f64) -> f64 {
    let first = function(low);
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if function(middle) * first > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}

/// `ConicSectionType`: 0 none, 1 a circle, 2 an ellipse, 3 a hyperbola, 4 a parabola. A rational quadratic is told by
/// the weights of its ends beside that of its middle (Piegl and Tiller, *The NURBS Book*, 7.2).
fn conic(curve: &Curve) -> i32 {
    let size = curve.bounding_box().diagonal().length();
    let tolerance = 1e-9 * size;
    if curve.is_linear(tolerance) {
        return 0;
    }
    if curve.as_arc(tolerance).is_some() {
        return 1;
    }
    if curve.as_elliptic_arc(tolerance).is_some() {
        return 2;
    }
    let Curve::Nurbs(nurbs) = curve else { return 0 };
    let weights = nurbs.weights();
    let [first, middle, last] = *weights.as_slice() else { return 0 };
    if nurbs.degree() != 2 || first * last <= 0.0 {
        return 0;
    }
    let ratio = middle * middle / (first * last);
    if (ratio - 1.0).abs() <= 1e-9 {
        4
    } else if ratio > 1.0 {
        3
    } else {
        2
    }
}
