//! Circles and arcs.

use std::f64::consts::TAU;

use katydid_geometry::{Arc, ArcCurve, Circle, Curve, Interval, Result};
use serde_json::Value;

use crate::curves::{loose_box, same_curve};
use crate::read::{self, Read};
use crate::report::{Case, EVALUATION};

pub(crate) fn compare(v: &Value, case: &mut Case) -> Read<()> {
    let input = &v["in"];
    let made = match read::text(&input["kind"])? {
        "Circle" => circle(input)?.and_then(|c| Arc::new(c, Interval::new(0.0, TAU))),
        "Arc" => {
            let angle = read::interval(&input["angle"])?;
            circle(input)?.and_then(|c| Arc::new(c, angle))
        }
        "Arc3pt" => {
            let p = &input["p"];
            Arc::through(read::point(&p[0])?, read::point(&p[1])?, read::point(&p[2])?)
        }
        other => return Err(format!("{other} is no kind of conic that is known")),
    };
    let valid = v["out"].get("IsValid").map_or(Ok(true), read::truth)?;
    case.equal("IsValid", made.is_ok(), valid);
    let Ok(arc) = made else { return Ok(()) };
    // The parameter of the files is the angle.
    let curve = Curve::from(ArcCurve { arc, domain: arc.angle });
    let size = arc.circle.center().to_vector().length() + arc.circle.radius;
    for (field, want) in v["out"].as_object().ok_or("no answers in the case")? {
        one(&arc, &curve, input, field, want, size, case)?;
    }
    Ok(())
}

fn circle(input: &Value) -> Read<Result<Circle>> {
    Ok(Circle::new(read::plane(&input["plane"])?, read::number(&input["r"])?))
}

fn one(
    arc: &Arc,
    curve: &Curve,
    input: &Value,
    field: &str,
    want: &Value,
    size: f64,
    case: &mut Case,
) -> Read<()> {
    let plane = &arc.circle.plane;
    // What three points say about their circle has fewer digits the nearer they are to a line.
    let digits = if input.get("p").is_some() { three_point_digits(arc, input)? } else { EVALUATION };
    match field {
        "IsValid" => {}
        "PointAt" => {
            let got = curve.point_at(read::number(&input["t"])?);
            case.point(field, got, read::point(want)?, size, digits);
        }
        "TangentAt" => {
            let got = curve.tangent_at(read::number(&input["t"])?).unwrap_or_default();
            case.vector(field, got, read::vector(want)?, 1.0, digits);
        }
        "Der" => {
            let want = read::vectors(want)?;
            let (_, got) = curve.derivatives(read::number(&input["t"])?, want.len(), false);
            for (k, (got, want)) in got.iter().zip(&want).enumerate() {
                case.vector(&format!("{field}[{k}]"), *got, *want, arc.circle.radius, digits);
            }
        }
        "Circumference" => {
            let want = read::number(want)?;
            case.number(field, arc.circle.circumference(), want, want, digits);
        }
        "Length" => {
            let want = read::number(want)?;
            case.number(field, arc.length(), want, want, digits);
            case.number("Length of the curve", curve.length(), want, want, digits);
        }
        "Start" => case.point(field, arc.start(), read::point(want)?, size, digits),
        "Mid" => case.point(field, arc.midpoint(), read::point(want)?, size, digits),
        "End" => case.point(field, arc.end(), read::point(want)?, size, digits),
        "ClosestPoint" => {
            let (q, want) = (read::point(&input["q"])?, read::point(want)?);
            if let Some(got) = case.made(field, curve.closest_point(q)) {
                let farther = got.distance - want.distance_to(q);
                case.number(field, farther.max(0.0), 0.0, 1.0, 1e-9);
            }
        }
        "ClosestParameter" => {
            let (q, want) = (read::point(&input["q"])?, read::number(want)?);
            if let Some(got) = case.made(field, curve.closest_point(q)) {
                // Seen from near the axis the angle has fewer digits.
                let [x, y, _] = plane.coordinates(q);
                let scale = TAU * (1.0 + (size + q.to_vector().length()) / x.hypot(y).max(1e-300));
                let apart = (got.parameter - want).rem_euclid(TAU);
                case.number(field, apart.min(TAU - apart), 0.0, scale, digits);
            }
        }
        "BBox" => loose_box(field, curve, want, size, case)?,
        "Nurbs" => {
            let over = if arc.is_circle() { arc.circle.to_nurbs() } else { arc.to_nurbs(arc.angle) };
            if let Some(got) = case.made(field, over) {
                same_curve(field, &got, want, None, case)?;
            }
        }
        "Center" => case.point(field, arc.circle.center(), read::point(want)?, size, digits),
        "Radius" => {
            let want = read::number(want)?;
            case.number(field, arc.circle.radius, want, want.max(1.0), digits);
        }
        "Angle" => case.number(field, arc.angle.length(), read::number(want)?, TAU, digits),
        "Plane" => {
            let want = read::plane(want)?;
            case.point(&format!("{field} origin"), plane.origin, want.origin, size, digits);
            case.vector(&format!("{field} x"), plane.x_axis, want.x_axis, 1.0, digits);
            case.vector(&format!("{field} y"), plane.y_axis, want.y_axis, 1.0, digits);
            case.vector(&format!("{field} z"), plane.z_axis, want.z_axis, 1.0, digits);
        }
        _ => case.miss(field, "a field that is not known".into()),
    }
    Ok(())
}

/// The radius over the smallest height of the triangle tells how errors grow; both kernels have them.
fn three_point_digits(arc: &Arc, input: &Value) -> Read<f64> {
    let p = &input["p"];
    let (a, b, c) = (read::point(&p[0])?, read::point(&p[1])?, read::point(&p[2])?);
    let longest = a.distance_to(b).max(b.distance_to(c)).max(c.distance_to(a));
    let height = (b - a).cross(c - a).length() / longest;
    let size = arc.circle.radius.max(longest).max(a.to_vector().length());
    Ok(EVALUATION * (size / height).powi(2).max(1.0))
}
