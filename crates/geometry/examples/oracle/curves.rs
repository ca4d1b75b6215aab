//! NURBS curves: everything that openNURBS says about one.

use katydid_geometry::{BoundingBox, Curve, NurbsCurve, Point3, Vector3};
use serde_json::Value;

use crate::read::{self, Read};
use crate::report::{CONSTRUCTION, Case, EVALUATION};

pub(crate) fn compare(v: &Value, case: &mut Case) -> Read<()> {
    let (input, out) = (&v["in"], out_fields(v)?);
    let made = read::curve(input);
    if let Some(valid) = out.get("IsValid") {
        case.equal("IsValid", made.is_ok(), read::truth(valid)?);
    }
    let Ok(c) = made else { return Ok(()) };
    let plane = read::integer(&input["dim"])? == 2;
    for (field, want) in out {
        if want.is_null() {
            continue;
        }
        match field.as_str() {
            "IsValid" => {}
            "Dimension" => case.equal(field, if plane { 2 } else { 3 }, read::integer(want)?),
            "eval" => {
                for e in read::list(want)? {
                    evaluation(&c, e, &sizes(out)?, case)?;
                }
            }
            "DerBelowKnot" => {
                let t = read::number(&want[0])?;
                derivatives(&c, field, t, &want[1], true, &sizes(out)?, case)?;
            }
            _ => property(&c, plane, field, want, case)?,
        }
    }
    Ok(())
}

fn out_fields(v: &Value) -> Read<&serde_json::Map<String, Value>> {
    v["out"].as_object().ok_or_else(|| "no answers in the case".to_owned())
}

/// The largest derivative of each order among those evaluated: the magnitude that errors are measured by.
fn sizes(out: &serde_json::Map<String, Value>) -> Read<Vec<f64>> {
    let mut sizes: Vec<f64> = Vec::new();
    for e in out.get("eval").and_then(Value::as_array).into_iter().flatten() {
        for (k, d) in read::vectors(&e["Der"])?.iter().enumerate() {
            match sizes.get_mut(k) {
                Some(size) => *size = size.max(d.length()),
                None => sizes.push(d.length()),
            }
        }
    }
    Ok(sizes)
}

fn derivatives(
    c: &NurbsCurve,
    field: &str,
    t: f64,
    want: &Value,
    below: bool,
    sizes: &[f64],
    case: &mut Case,
) -> Read<()> {
    let want = read::vectors(want)?;
    let (at, got) = c.derivatives(t, want.len().saturating_sub(1), below);
    let got = std::iter::once(at.to_vector()).chain(got);
    for (k, (got, want)) in got.zip(&want).enumerate() {
        let size = sizes.get(k).copied().unwrap_or(0.0);
        case.vector(&format!("{field}[{k}] at {t}"), got, *want, size, EVALUATION);
    }
    Ok(())
}

fn evaluation(nurbs: &NurbsCurve, e: &Value, sizes: &[f64], case: &mut Case) -> Read<()> {
    let t = read::number(&e["t"])?;
    let size = |k: usize| sizes.get(k).copied().unwrap_or(0.0);
    let curve = Curve::from(nurbs.clone());
    let der = read::vectors(&e["Der"])?;
    let speed = der.get(1).map_or(1.0, |d| d.length()).max(f64::MIN_POSITIVE);
    case.point(&format!("PointAt {t}"), nurbs.point_at(t), read::point(&e["PointAt"])?, size(0), EVALUATION);
    let batch = nurbs.points_at(&[t]).first().copied().unwrap_or(Point3::ORIGIN);
    case.point(&format!("PointAt {t} in a batch"), batch, read::point(&e["PointAt"])?, size(0), EVALUATION);
    derivatives(nurbs, "Der", t, &e["Der"], false, sizes, case)?;
    // Where the curve is slow for its size, a direction has as many digits fewer.
    let turn = (size(1) / speed).max(1.0);
    let tangent = curve.tangent_at(t).unwrap_or(Vector3::ZERO);
    case.vector(&format!("TangentAt {t}"), tangent, read::vector(&e["TangentAt"])?, turn, EVALUATION);
    let want = read::vector(&e["CurvatureAt"])?;
    let natural = size(2) / speed.powi(2) + size(1) / speed * want.length();
    case.vector(&format!("CurvatureAt {t}"), curve.curvature_at(t), want, natural, EVALUATION);
    let frame = &e["FrameAt"];
    let found = curve.frame_at(t);
    case.equal(&format!("FrameAt {t}"), found.is_some(), read::truth(&frame[0])?);
    if let Some(found) = found {
        let [origin, x, y, z] = [&frame[1], &frame[2], &frame[3], &frame[4]];
        case.point(&format!("FrameAt {t} origin"), found.origin, read::point(origin)?, size(0), EVALUATION);
        case.vector(&format!("FrameAt {t} x"), found.x_axis, read::vector(x)?, turn, EVALUATION);
        let (y, z) = (read::vector(y)?, read::vector(z)?);
        if want.length() <= 1e-12 * natural.max(1.0) && want != Vector3::ZERO {
            // The reference took rounding noise for a curvature: y has no digit that means anything.
            let skew = found.x_axis.dot(found.y_axis).abs() + (found.y_axis.length() - 1.0).abs();
            case.number(&format!("FrameAt {t} right angle"), skew, 0.0, 1.0, EVALUATION);
            return Ok(());
        }
        // The y axis has the digits of the curvature's direction.
        let bend = if want == Vector3::ZERO { turn } else { (natural / want.length()).max(turn) };
        case.vector(&format!("FrameAt {t} y"), found.y_axis, y, bend, EVALUATION);
        case.vector(&format!("FrameAt {t} z"), found.z_axis, z, bend, EVALUATION);
    }
    Ok(())
}

/// One field besides the evaluations.
fn property(c: &NurbsCurve, plane: bool, field: &str, want: &Value, case: &mut Case) -> Read<()> {
    let curve = || Curve::from(c.clone());
    let size = c.control_points().iter().map(|p| p.to_vector().length()).fold(1.0, f64::max);
    let knots = c.knots().iter().fold(1.0_f64, |m, k| m.max(k.abs()));
    match field {
        "Domain" => {
            let (got, want) = (c.domain(), read::interval(want)?);
            case.numbers(field, &[got.start, got.end], &[want.start, want.end], knots, 0.0);
        }
        "SpanCount" => case.equal(field, c.span_count(), read::integer(want)?),
        "IsClosed" => case.equal(field, curve().is_closed(), read::truth(want)?),
        "IsPeriodic" => case.equal(field, c.is_periodic(), read::truth(want)?),
        "IsPlanar" => case.equal(field, curve().is_planar(1e-9), read::truth(want)?),
        "IsLinear" => case.equal(field, curve().is_linear(1e-9), read::truth(want)?),
        "HasBezierSpans" => case.equal(field, c.has_bezier_spans(), read::truth(want)?),
        "Greville" => {
            case.numbers(field, &c.greville_abscissae(), &read::numbers(want)?, knots, CONSTRUCTION);
        }
        // The reference counts Greville points from the second abscissa.
        "GrevillePoint0" => match c.greville_abscissae().get(1) {
            Some(&t) => case.point(field, c.point_at(t), read::point(want)?, size, EVALUATION),
            None => case.miss(field, "there is no second abscissa".into()),
        },
        "BBox" => boxes(field, c.control_box(), want, size, case)?,
        "TightBBox" => loose_box(field, &curve(), want, size, case)?,
        "Mult" => {
            let want: Vec<usize> = read::list(want)?.iter().map(read::integer).collect::<Read<_>>()?;
            case.equal(field, c.knot_multiplicities(), want);
        }
        "SuperfluousKnot" => {
            case.numbers(field, &c.superfluous_knots(), &read::numbers(want)?, knots, CONSTRUCTION);
        }
        "Clamped" => {
            case.equal(
                field,
                c.clamped_ends().to_vec(),
                read::list(want)?.iter().map(read::truth).collect::<Read<_>>()?,
            );
        }
        "ControlPolygonLength" => {
            let want = read::number(want)?;
            case.number(field, c.control_polygon_length(), want, want.abs(), EVALUATION);
        }
        _ => return construction(c, plane, field, want, case),
    }
    Ok(())
}

pub(crate) fn boxes(
    field: &str,
    got: Option<BoundingBox>,
    want: &Value,
    size: f64,
    case: &mut Case,
) -> Read<()> {
    let want = read::bounding_box(want)?;
    match got {
        Some(got) => {
            case.point(&format!("{field} min"), got.min, want.min, size, EVALUATION);
            case.point(&format!("{field} max"), got.max, want.max, size, EVALUATION);
        }
        None => case.miss(field, "there is no box".into()),
    }
    Ok(())
}

/// A box of the reference that need not be tight: it holds ours, and ours holds the curve.
pub(crate) fn loose_box(field: &str, curve: &Curve, want: &Value, size: f64, case: &mut Case) -> Read<()> {
    let (got, slack) = (curve.bounding_box(), EVALUATION * size);
    let outer = read::bounding_box(want)?.inflated(slack);
    case.equal(
        &format!("{field} inside the reference's"),
        outer.contains(got.min) && outer.contains(got.max),
        true,
    );
    let domain = curve.domain();
    let samples = (0..=2000).map(|i| curve.point_at(domain.at(f64::from(i) / 2000.0)));
    let Some(reached) = BoundingBox::from_points(samples) else {
        case.miss(field, "a point of the curve is not finite".into());
        return Ok(());
    };
    let grown = got.inflated(slack);
    case.equal(
        &format!("{field} holds the curve"),
        grown.contains(reached.min) && grown.contains(reached.max),
        true,
    );
    Ok(())
}

/// A curve made of this one.
fn construction(c: &NurbsCurve, plane: bool, field: &str, want: &Value, case: &mut Case) -> Read<()> {
    let made = match field {
        "InsertKnot" => c.insert_knot(read::number(&want["t"])?, read::integer(&want["mult"])?),
        "IncreaseDegree1" => c.raised_to(c.degree() + 1),
        "Reverse" => Ok(c.reversed()),
        "Transform" => {
            let image = c.transformed(&read::xform(&want["x"])?);
            if plane { image.and_then(flattened) } else { image }
        }
        "Trim" => c.trimmed(read::interval(&want["t"])?),
        "MakePiecewiseBezier" => c.with_bezier_spans(),
        "ChangeEndWeights" => {
            let w = read::interval(&want["w"])?;
            c.with_end_weights(w.start, w.end)
        }
        "Reparameterize" => c.reparametrized(read::number(&want["c"])?),
        "Split" => {
            if let Some((a, b)) = case.made(field, c.split(read::number(&want["t"])?)) {
                same_curve(&format!("{field} before"), &a, &want["r"][0], Some(c), case)?;
                same_curve(&format!("{field} after"), &b, &want["r"][1], Some(c), case)?;
            }
            return Ok(());
        }
        _ => {
            // A number at the end of the name is the index of the span.
            let index = field.strip_prefix("ConvertSpanToBezier").and_then(|i| i.parse().ok());
            match index {
                Some(i) => {
                    if let Some(made) = case.made(field, c.bezier_span(i)) {
                        same_curve(field, &made, want, None, case)?;
                    }
                }
                None => case.miss(field, "a field that is not known".into()),
            }
            return Ok(());
        }
    };
    let refused = want.get("ok").is_some_and(|ok| ok.as_bool() == Some(false));
    if refused || want["r"].is_null() {
        return Ok(());
    }
    if let Some(made) = case.made(field, made) {
        let keeps_points = ["InsertKnot", "IncreaseDegree1", "Trim", "MakePiecewiseBezier"].contains(&field);
        same_curve(field, &made, &want["r"], keeps_points.then_some(c), case)?;
    }
    Ok(())
}

/// A plane curve under a map of space loses its third coordinate, as openNURBS has it.
fn flattened(c: NurbsCurve) -> katydid_geometry::Result<NurbsCurve> {
    let points = c.homogeneous_points();
    let (degree, knots) = (c.degree(), c.knots().to_vec());
    if c.is_rational() {
        NurbsCurve::rational(degree, points.iter().map(|p| [p[0], p[1], 0.0, p[3]]).collect(), knots)
    } else {
        NurbsCurve::new(degree, points.iter().map(|p| Point3::new(p[0], p[1], 0.0)).collect(), knots)
    }
}

/// Degree, knots and homogeneous control points.
///
/// Some constructions cost the reference digits: its raised control points can be wrong by 1e-6 where knots are
/// very unevenly spaced. Where the two differ a little, the curve `source` that both must repeat decides: ours has to be
/// within rounding of it and nearer than the reference's.
pub(crate) fn same_curve(
    field: &str,
    got: &NurbsCurve,
    want: &Value,
    source: Option<&NurbsCurve>,
    case: &mut Case,
) -> Read<()> {
    case.equal(&format!("{field} order"), got.order(), read::integer(&want["order"])?);
    case.equal(&format!("{field} rational"), got.is_rational(), read::integer(&want["rat"])? == 1);
    let knots = read::numbers(&want["knots"])?;
    let size = knots.iter().fold(1.0_f64, |m, k| m.max(k.abs()));
    case.numbers(&format!("{field} knots"), got.knots(), &knots, size, CONSTRUCTION);
    let (ours, theirs) = (got.homogeneous_points().concat(), read::controls(want)?.concat());
    let size = theirs.iter().fold(1.0_f64, |m, x| m.max(x.abs()));
    let apart = ours.iter().zip(&theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    if let (Some(source), Ok(reference)) = (source, read::curve(want))
        && apart > CONSTRUCTION * size
        && apart <= 1e-4 * size
        && ours.len() == theirs.len()
    {
        let defect = |c: &NurbsCurve| {
            let at = |i: u32| c.domain().at(f64::from(i) / 200.0);
            (0..=200).map(|i| c.point_at(at(i)).distance_to(source.point_at(at(i)))).fold(0.0, f64::max)
        };
        let (mine, its) = (defect(got), defect(&reference));
        if mine <= its {
            case.number(&format!("{field} repeats the curve"), mine, 0.0, size, EVALUATION);
            case.decided_by_source();
            return Ok(());
        }
    }
    case.numbers(&format!("{field} control points"), &ours, &theirs, size, CONSTRUCTION);
    Ok(())
}
