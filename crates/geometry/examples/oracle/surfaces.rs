//! NURBS surfaces: everything that openNURBS says about one.

use katydid_geometry::{Direction, NurbsSurface, Quadrant, Surface, Vector3};
use serde_json::Value;

use crate::curves::{boxes, same_curve};
use crate::read::{self, Read};
use crate::report::{CONSTRUCTION, Case, EVALUATION};

pub(crate) fn compare(v: &Value, case: &mut Case) -> Read<()> {
    let out = v["out"].as_object().ok_or("no answers in the case")?;
    let made = read::surface(&v["in"]);
    if let Some(valid) = out.get("IsValid") {
        case.equal("IsValid", made.is_ok(), read::truth(valid)?);
    }
    let Ok(s) = made else { return Ok(()) };
    for (field, want) in out {
        if !want.is_null() {
            one(&s, field, want, case)?;
        }
    }
    Ok(())
}

/// One answer for u and one for v.
fn both(want: &Value, mut compare: impl FnMut(Direction, &Value) -> Read<()>) -> Read<()> {
    compare(Direction::U, &want[0])?;
    compare(Direction::V, &want[1])
}

fn one(s: &NurbsSurface, field: &str, want: &Value, case: &mut Case) -> Read<()> {
    let size = s.control_points().iter().map(|p| p.to_vector().length()).fold(1.0, f64::max);
    match field {
        "IsValid" => Ok(()),
        "Domain" => both(want, |d, want| {
            let (got, want) = (s.domain(d), read::interval(want)?);
            case.numbers(field, &[got.start, got.end], &[want.start, want.end], 1.0, 0.0);
            Ok(())
        }),
        "SpanCount" => both(want, |d, want| {
            case.equal(field, s.span_parameters(d).len() - 1, read::integer(want)?);
            Ok(())
        }),
        "SpanVector" => both(want, |d, want| {
            case.numbers(field, &s.span_parameters(d), &read::numbers(want)?, 1.0, 0.0);
            Ok(())
        }),
        "IsClosed" => both(want, |d, want| {
            case.equal(field, s.is_closed(d), read::truth(want)?);
            Ok(())
        }),
        "IsPeriodic" => both(want, |d, want| {
            case.equal(field, s.is_periodic(d), read::truth(want)?);
            Ok(())
        }),
        "IsPlanar" => {
            case.equal(field, s.plane(1e-9).is_some(), read::truth(want)?);
            Ok(())
        }
        "BBox" => boxes(field, Some(s.hull_box()), want, size, case),
        "eval" => read::list(want)?.iter().try_for_each(|e| evaluation(s, e, size, case)),
        "IsoCurve" | "IsoCurve0" => {
            let direction = if read::integer(&want["dir"])? == 0 { Direction::U } else { Direction::V };
            match case.made(field, s.isocurve(direction, read::number(&want["c"])?)) {
                Some(made) => same_curve(field, &made, &want["r"], None, case),
                None => Ok(()),
            }
        }
        _ => construction(s, field, want, case),
    }
}

fn evaluation(s: &NurbsSurface, e: &Value, size: f64, case: &mut Case) -> Read<()> {
    let uv = read::interval(&e["uv"])?;
    let (u, v) = (uv.start, uv.end);
    let surface = Surface::from(s.clone());
    let want = read::point(&e["PointAt"])?;
    case.point("PointAt", s.point_at(u, v), want, size, EVALUATION);
    let d = surface.derivatives(u, v, 1, Quadrant::NorthEast);
    case.point("PointAt with derivatives", d.point(), want, size, EVALUATION);
    // A normal has as many digits fewer as the partials are small or parallel.
    let (du, dv) = (d.get(1, 0), d.get(0, 1));
    let turn =
        (du.length() * dv.length() / du.cross(dv).length()).max(size / du.length()).max(size / dv.length());
    let normal = surface.normal_at(u, v).unwrap_or(Vector3::ZERO);
    case.vector("NormalAt", normal, read::vector(&e["NormalAt"])?, turn, EVALUATION);
    if let Some(frame) = surface.frame_at(u, v) {
        let want = read::plane(&e["FrameAt"])?;
        case.point("FrameAt origin", frame.origin, want.origin, size, EVALUATION);
        case.vector("FrameAt x", frame.x_axis, want.x_axis, turn, EVALUATION);
        case.vector("FrameAt y", frame.y_axis, want.y_axis, turn, EVALUATION);
        case.vector("FrameAt z", frame.z_axis, want.z_axis, turn, EVALUATION);
    } else {
        case.miss("FrameAt", "there is none".into());
    }
    Ok(())
}

/// The direction that a name ends in.
fn direction(field: &str) -> Direction {
    if field.ends_with('V') { Direction::V } else { Direction::U }
}

fn construction(s: &NurbsSurface, field: &str, want: &Value, case: &mut Case) -> Read<()> {
    let d = direction(field);
    let made = match field {
        "InsertKnotU" | "InsertKnotV" => {
            let multiplicity = want.get("mult").map_or(Ok(1), read::integer)?;
            s.insert_knot(d, read::number(&want["t"])?, multiplicity)
        }
        "IncreaseDegreeU" | "IncreaseDegreeV" => s.raised_to(d, s.degree(d) + 1),
        "Transpose" => Ok(s.transposed()),
        "ReverseU" | "ReverseV" => Ok(s.reversed(d)),
        "Transform" => s.transformed(&read::xform(&want["x"])?),
        _ => {
            case.miss(field, "a field that is not known".into());
            return Ok(());
        }
    };
    if want.get("ok").is_some_and(|ok| ok.as_bool() == Some(false)) || want["r"].is_null() {
        return Ok(());
    }
    if let Some(made) = case.made(field, made) {
        same_surface(
            field,
            &made,
            &want["r"],
            Some(s).filter(|_| field.contains("crease") || field.contains("sert")),
            case,
        )?;
    }
    Ok(())
}

/// Degrees, knots and homogeneous control points; where they differ a little the surface that both must repeat
/// decides, as for curves.
pub(crate) fn same_surface(
    field: &str,
    got: &NurbsSurface,
    want: &Value,
    source: Option<&NurbsSurface>,
    case: &mut Case,
) -> Read<()> {
    case.equal(&format!("{field} rational"), got.is_rational(), read::integer(&want["rat"])? == 1);
    both(&want["order"], |d, want| {
        case.equal(&format!("{field} order"), got.order(d), read::integer(want)?);
        Ok(())
    })?;
    both(&want["n"], |d, want| {
        case.equal(&format!("{field} count"), got.count(d), read::integer(want)?);
        Ok(())
    })?;
    both(&want["knots"], |d, want| {
        let knots = read::numbers(want)?;
        let size = knots.iter().fold(1.0_f64, |m, k| m.max(k.abs()));
        case.numbers(&format!("{field} knots"), got.knots(d), &knots, size, CONSTRUCTION);
        Ok(())
    })?;
    let (ours, theirs) = (got.homogeneous_points().concat(), read::controls(want)?.concat());
    let size = theirs.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    let apart = ours.iter().zip(&theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    if let (Some(source), Ok(reference)) = (source, read::surface(want))
        && ours.len() == theirs.len()
        && apart > CONSTRUCTION * size
        && apart <= 1e-4 * size
    {
        let (mine, its) = (defect(got, source), defect(&reference, source));
        if mine <= its {
            case.number(&format!("{field} repeats the surface"), mine, 0.0, size, EVALUATION);
            case.decided_by_source();
            return Ok(());
        }
    }
    case.numbers(&format!("{field} control points"), &ours, &theirs, size, CONSTRUCTION);
    Ok(())
}

/// The largest distance between points of equal parameters.
fn defect(a: &NurbsSurface, b: &NurbsSurface) -> f64 {
    let at = |d: Direction, i: u32| b.domain(d).at(f64::from(i) / 40.0);
    let pairs = (0..=40).flat_map(|i| (0..=40).map(move |j| (i, j)));
    pairs
        .map(|(i, j)| (at(Direction::U, i), at(Direction::V, j)))
        .map(|(u, v)| a.point_at(u, v).distance_to(b.point_at(u, v)))
        .fold(0.0, f64::max)
}
