//! Lengths, closest points and curvatures.

use katydid_geometry::{Curve, Direction, Interval, Quadrant, Surface};
use serde_json::Value;

use crate::read::{self, Read};
use crate::report::{Case, EVALUATION};

/// A closest point may be farther than the reference's by this.
pub(crate) const FARTHER: f64 = 1e-9;

pub(crate) fn length(v: &Value, case: &mut Case) -> Read<()> {
    let curve = Curve::from(read::curve(&v["in"])?);
    let want = read::number(&v["length"])?;
    case.number("length", curve.length(), want, want, 1e-12);
    // The reference's parameter is rough; what counts is that the part up to ours is half as long.
    if let Some(t) = curve.parameter_at_normalized_length(0.5) {
        let half = curve.length_between(Interval::new(curve.domain().start, t));
        case.number("half of the length", half, 0.5 * want, want, 1e-12);
        let rough = read::number(&v["t_at_half"])?;
        case.equal("t_at_half nearby", (t - rough).abs() < 0.02 * curve.domain().length(), true);
    } else {
        case.miss("t_at_half", "there is no such parameter".into());
    }
    Ok(())
}

pub(crate) fn closest_curve(v: &Value, case: &mut Case) -> Read<()> {
    let curve = Curve::from(read::curve(&v["in"])?);
    let (q, want) = (read::point(&v["q"])?, read::number(&v["dist"])?);
    if let Some(got) = case.made("closest point", curve.closest_point(q)) {
        case.number("farther than the reference", (got.distance - want).max(0.0), 0.0, 1.0, FARTHER);
        let here = curve.point_at(got.parameter).distance_to(q);
        case.number("distance at the parameter", here, got.distance, 1.0 + want, EVALUATION);
        case.equal("inside the domain", curve.domain().contains(got.parameter), true);
    }
    Ok(())
}

pub(crate) fn curvature(v: &Value, case: &mut Case) -> Read<()> {
    let surface = Surface::from(read::surface(&v["in"])?);
    for e in read::list(&v["eval"])? {
        let uv = read::interval(&e["uv"])?;
        let (u, w) = (uv.start, uv.end);
        let d = surface.derivatives(u, w, 2, Quadrant::NorthEast);
        let orders = [("Su", 1, 0), ("Sv", 0, 1), ("Suu", 2, 0), ("Suv", 1, 1), ("Svv", 0, 2)];
        let mut size = 1.0_f64;
        for (name, i, j) in orders {
            size = size.max(read::vector(&e[name])?.length());
            case.vector(name, d.get(i, j), read::vector(&e[name])?, size, EVALUATION);
        }
        let Some(c) = case.made("curvature", surface.curvature_at(u, w)) else { continue };
        // Curvatures are second derivatives over squares of first ones.
        let speed = d.get(1, 0).cross(d.get(0, 1)).length() / d.get(1, 0).length().max(d.get(0, 1).length());
        let bend = (size / (speed * speed)).max(1.0);
        case.vector("n", c.normal, read::vector(&e["n"])?, (size / speed).max(1.0), EVALUATION);
        let (k1, k2) = (read::number(&e["k1"])?, read::number(&e["k2"])?);
        let (mut got, mut want) = (c.principal, [k1, k2]);
        got.sort_by(f64::total_cmp);
        want.sort_by(f64::total_cmp);
        case.numbers("principal curvatures", &got, &want, bend, EVALUATION);
        case.number("K", c.gaussian, read::number(&e["K"])?, bend * bend, EVALUATION);
        case.number("H", c.mean, read::number(&e["H"])?, bend, EVALUATION);
    }
    Ok(())
}

pub(crate) fn closest_surface(v: &Value, case: &mut Case) -> Read<()> {
    let surface = Surface::from(read::surface(&v["in"])?);
    let (q, want) = (read::point(&v["q"])?, read::number(&v["dist"])?);
    if let Some(got) = case.made("closest point", surface.closest_point(q)) {
        case.number("farther than the reference", (got.distance - want).max(0.0), 0.0, 1.0, FARTHER);
        let here = surface.point_at(got.u, got.v).distance_to(q);
        case.number("distance at the parameters", here, got.distance, 1.0 + want, EVALUATION);
        let inside =
            surface.domain(Direction::U).contains(got.u) && surface.domain(Direction::V).contains(got.v);
        case.equal("inside the domain", inside, true);
    }
    Ok(())
}

pub(crate) fn area(v: &Value, case: &mut Case) -> Read<()> {
    let surface = Surface::from(read::surface(&v["in"])?);
    if let Some(got) = case.made("area", surface.area()) {
        let want = read::number(&v["area"])?;
        // The reference says by how much its own quadrature may be wrong.
        let doubt = v.get("quad_err").map_or(Ok(0.0), read::number)? / want;
        case.number("area", got.area, want, want, 1e-10 + doubt);
        let centroid = read::point(&v["centroid"])?;
        case.point("centroid", got.centroid, centroid, 1.0, 1e-8 + 10.0 * doubt);
    }
    Ok(())
}
