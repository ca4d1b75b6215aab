//! The curve classes.

use katydid_geometry::{Arc, Interval, Point3};

use super::{Verdict, numbers, nurbs};
use crate::CurveForm;

/// How far arcs may miss their neighbours, as a fraction of their length.
const ARC_GAP: f64 = 1e-10;

/// Whether a curve is valid.
pub(super) fn verdict(form: &CurveForm) -> Verdict {
    match form {
        CurveForm::Line { line, domain, .. } => {
            numbers::point(line.from, "its start")?;
            numbers::point(line.to, "its end")?;
            let length = line.length();
            if length.is_nan() || length <= 0.0 {
                return Err("it is a line without length".into());
            }
            numbers::increasing(*domain, "its domain")
        }
        CurveForm::Arc { arc, offset, domain, .. } => {
            numbers::increasing(*domain, "its domain")?;
            self::arc(arc, *offset)
        }
        CurveForm::Polyline { points, parameters, dimension } => polyline(points, parameters, *dimension),
        CurveForm::Nurbs(form) => nurbs::curve(form),
        CurveForm::Poly { segments, parameters } => chain(segments, parameters, false),
        CurveForm::OnSurface(curve) => {
            verdict(&curve.flat)?;
            if dimension(&curve.flat) != 2 {
                return Err("its parameter curve is not of dimension 2".into());
            }
            super::surfaces::verdict(&curve.surface)
        }
        CurveForm::Tagged { curve, .. } => verdict(curve),
    }
}

/// The number of coordinates of a curve's points.
pub(super) fn dimension(form: &CurveForm) -> i32 {
    match form {
        CurveForm::Line { dimension, .. }
        | CurveForm::Arc { dimension, .. }
        | CurveForm::Polyline { dimension, .. } => *dimension,
        CurveForm::Nurbs(form) => form.dimension,
        CurveForm::Poly { segments, .. } => segments.first().map_or(0, dimension),
        CurveForm::OnSurface(_) => 3,
        CurveForm::Tagged { curve, .. } => dimension(curve),
    }
}

fn arc(arc: &Arc, offset: Option<f64>) -> Verdict {
    let radius = arc.circle.radius;
    if !(numbers::is_set(radius) && radius > 0.0) {
        return Err(format!("its radius is {radius}"));
    }
    numbers::plane(&arc.circle.plane, offset)?;
    let (angle, turn) = (arc.angle.length(), std::f64::consts::TAU);
    if !(numbers::is_set(arc.angle.start) && angle > numbers::ZERO && angle <= turn + numbers::ZERO) {
        return Err(format!("its angle is {angle}"));
    }
    Ok(())
}

fn polyline(points: &[Point3], parameters: &[f64], dimension: i32) -> Verdict {
    if points.len() < 2 || points.len() != parameters.len() {
        return Err(format!("it has {} points and {} parameters", points.len(), parameters.len()));
    }
    points.iter().try_for_each(|p| numbers::point(*p, "a point"))?;
    if points.windows(2).any(|pair| matches!(pair, [a, b] if a == b)) {
        return Err("a point follows on the same point".into());
    }
    if points.len() < 4 && points.first() == points.last() {
        return Err("it is closed, but has no area".into());
    }
    if !parameters.windows(2).all(|pair| matches!(pair, [a, b] if a < b)) {
        return Err("its parameters do not increase".into());
    }
    match dimension {
        2 | 3 => Ok(()),
        other => Err(format!("its dimension is {other}")),
    }
}

/// Curves end to end; the profiles of an extrusion may be apart.
pub(super) fn chain(segments: &[CurveForm], parameters: &[f64], may_have_gaps: bool) -> Verdict {
    if segments.is_empty() || parameters.len() != segments.len() + 1 {
        return Err(format!("it has {} segments and {} parameters", segments.len(), parameters.len()));
    }
    let dimension = segments.first().map_or(0, self::dimension);
    for (i, (segment, ends)) in segments.iter().zip(parameters.windows(2)).enumerate() {
        let at = |why: String| Err(format!("segment {i}: {why}"));
        if let Err(why) = verdict(segment) {
            return at(why);
        }
        if self::dimension(segment) != dimension {
            return at("it is of another dimension".into());
        }
        if !matches!(ends, [a, b] if a < b) {
            return at("its domain does not increase".into());
        }
        if segments.len() > 1 && !may_have_gaps && is_closed(segment) {
            return at("it is closed".into());
        }
    }
    if may_have_gaps {
        return Ok(());
    }
    match segments.windows(2).position(|pair| matches!(pair, [a, b] if has_gap(a, b))) {
        Some(i) => Err(format!("segment {} does not begin where the one before it ends", i + 1)),
        None => Ok(()),
    }
}

/// Whether a curve ends where it begins; one that the kernel refuses is no closed curve.
pub(super) fn is_closed(form: &CurveForm) -> bool {
    form.to_curve().is_ok_and(|curve| curve.is_closed())
}

fn has_gap(before: &CurveForm, after: &CurveForm) -> bool {
    let end = |form: &CurveForm, at_end: bool| {
        let curve = form.to_curve().ok()?;
        let Interval { start, end } = curve.domain();
        Some(curve.point_at(if at_end { end } else { start }))
    };
    let (Some(p), Some(q)) = (end(before, true), end(after, false)) else { return false };
    if numbers::coincide(p, q) {
        return false;
    }
    // Arcs are given more room: their ends are computed.
    let room = |form: &CurveForm| match form {
        CurveForm::Arc { arc, .. } => Some(arc.circle.radius * arc.angle.length() * ARC_GAP),
        _ => None,
    };
    match (room(before), room(after)) {
        (None, None) => true,
        (a, b) => p.distance_to(q) > numbers::ZERO.max(a.unwrap_or(0.0)).max(b.unwrap_or(0.0)),
    }
}
