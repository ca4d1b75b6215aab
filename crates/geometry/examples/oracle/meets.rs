//! Intersections of curves by subdivision.

use katydid_geometry::{Curve, Direction, Point3, intersect};
use serde_json::Value;

use crate::read::{self, Read};
use crate::report::Case;

/// Curves nearer than this meet.
const TOLERANCE: f64 = 1e-9;
/// Of the reference's points, which were polished, ours may be away by this part of the size of the curves.
const APART: f64 = 1e-9;

/// What both kernels found, ours by the point and the parameters.
struct Found {
    point: Point3,
    parameters: Vec<f64>,
}

pub(crate) fn curve_curve(v: &Value, case: &mut Case) -> Read<()> {
    let (a, b) = (Curve::from(read::curve(&v["a"])?), Curve::from(read::curve(&v["b"])?));
    let Some(got) = case.made("curves", intersect::curve_curve(&a, &b, TOLERANCE)) else { return Ok(()) };
    case.equal("the search came to its end", got.complete, true);
    case.equal("overlaps", got.overlaps.len(), 0);
    let ours = got.crossings.iter().map(|c| Found { point: c.point, parameters: vec![c.a, c.b] });
    for c in &got.crossings {
        let gap = a.point_at(c.a).distance_to(b.point_at(c.b));
        case.number("gap between the curves", gap, 0.0, 1.0, 1e-12);
    }
    let domains = [a.domain().length(), b.domain().length()];
    matched(ours.collect(), v, "t", &domains, case)
}

/// Crossings of a curve and a surface: all of them and no more.
pub(crate) fn curve_surface(v: &Value, case: &mut Case) -> Read<()> {
    let (curve, surface) = (Curve::from(read::curve(&v["curve"])?), read::surface(&v["srf"])?);
    let Some(got) = case.made("curve and surface", intersect::curve_surface(&curve, &surface, TOLERANCE))
    else {
        return Ok(());
    };
    case.equal("the search came to its end", got.complete, true);
    case.equal("overlaps", got.overlaps.len(), 0);
    for c in &got.crossings {
        let gap = curve.point_at(c.t).distance_to(surface.point_at(c.u, c.v));
        case.number("gap between curve and surface", gap, 0.0, 1.0, 1e-12);
    }
    let ours = got.crossings.iter().map(|c| Found { point: c.point, parameters: vec![c.t, c.u, c.v] });
    let domains =
        [curve.domain(), surface.domain(Direction::U), surface.domain(Direction::V)].map(|d| d.length());
    matched(ours.collect(), v, "tuv", &domains, case)
}

/// Every point of the reference must be among ours, and ours no more.
fn matched(mut ours: Vec<Found>, v: &Value, name: &str, domains: &[f64], case: &mut Case) -> Read<()> {
    case.equal("count", ours.len(), read::integer(&v["n"])?);
    for (parameters, p) in read::list(&v[name])?.iter().zip(read::list(&v["p"])?) {
        let (parameters, p) = (read::numbers(parameters)?, read::point(p)?);
        let size = p.to_vector().length().max(1.0);
        let nearest = (0..ours.len())
            .min_by(|&i, &j| ours[i].point.distance_to(p).total_cmp(&ours[j].point.distance_to(p)));
        let Some(found) = nearest.map(|i| ours.swap_remove(i)) else {
            case.miss("missing", format!("{p:?} at {parameters:?}"));
            continue;
        };
        case.number("point", found.point.distance_to(p), 0.0, size, APART);
        for ((got, want), domain) in found.parameters.iter().zip(&parameters).zip(domains) {
            // Where curves meet at a small angle the parameters have fewer digits than the point.
            case.number("parameter", *got, *want, domain.max(want.abs()), 1e-7);
        }
    }
    for found in ours {
        case.miss("spurious", format!("{:?} at {:?}", found.point, found.parameters));
    }
    Ok(())
}
