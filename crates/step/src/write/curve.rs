//! Curves in space and in parameter planes.

use super::{direction, flag, frame, point};
use crate::Result;
use crate::part21::{Id, Sheet, list, real};
use katydid_geometry::{ArcCurve, Curve, Line, NurbsCurve, Plane, Point3};

/// The entities of one dimension: space or a parameter plane.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Room {
    Space,
    Plane,
}

impl Room {
    pub(super) fn point(self, sheet: &mut Sheet, p: Point3) -> Id {
        match self {
            Self::Space => point(sheet, p),
            Self::Plane => sheet.put(format_args!("CARTESIAN_POINT('',({},{}))", real(p.x), real(p.y))),
        }
    }
}

/// The carrier of an edge: an unbounded line, a whole circle, or a b-spline. Parameters are length, angle and knots.
pub(super) fn carrier(sheet: &mut Sheet, curve: &Curve) -> Result<Id> {
    match curve {
        Curve::Line(c) => line(sheet, &c.line),
        Curve::Arc(c) => Ok(circle(sheet, c)),
        _ => spline(sheet, &curve.to_nurbs()?, Room::Space),
    }
}

/// A curve with its ends.
pub(super) fn bounded(sheet: &mut Sheet, curve: &Curve) -> Result<Id> {
    match curve {
        Curve::Line(c) => Ok(polyline(sheet, &[c.line.from, c.line.to])),
        Curve::Polyline(c) => Ok(polyline(sheet, c.points())),
        Curve::Arc(c) if c.is_circle() => Ok(circle(sheet, c)),
        Curve::Arc(c) => {
            let circle = circle(sheet, c);
            let [start, end] = [curve.start(), curve.end()].map(|p| point(sheet, p));
            let angle = c.arc.angle;
            Ok(sheet.put(format_args!(
                "TRIMMED_CURVE('',{circle},({start},PARAMETER_VALUE({})),({end},PARAMETER_VALUE({})),\
                 .T.,.PARAMETER.)",
                real(angle.start),
                real(angle.end)
            )))
        }
        Curve::Nurbs(c) => spline(sheet, c, Room::Space),
        Curve::Poly(c) => {
            let mut segments = Vec::new();
            for segment in c.segments() {
                let parent = match segment {
                    // A whole circle is not bounded.
                    Curve::Arc(arc) if arc.is_circle() => spline(sheet, &segment.to_nurbs()?, Room::Space)?,
                    _ => bounded(sheet, segment)?,
                };
                segments.push(sheet.put(format_args!("COMPOSITE_CURVE_SEGMENT(.CONTINUOUS.,.T.,{parent})")));
            }
            Ok(sheet.put(format_args!("COMPOSITE_CURVE('',{},.F.)", list(segments))))
        }
    }
}

fn polyline(sheet: &mut Sheet, points: &[Point3]) -> Id {
    let points: Vec<Id> = points.iter().map(|p| point(sheet, *p)).collect();
    sheet.put(format_args!("POLYLINE('',{})", list(points)))
}

pub(super) fn line(sheet: &mut Sheet, line: &Line) -> Result<Id> {
    let Some(along) = line.unit_direction() else {
        return Err(katydid_geometry::Error::Degenerate { what: "line", why: "it has no length" }.into());
    };
    let from = point(sheet, line.from);
    let along = direction(sheet, along);
    let vector = sheet.put(format_args!("VECTOR('',{along},1.)"));
    Ok(sheet.put(format_args!("LINE('',{from},{vector})")))
}

fn circle(sheet: &mut Sheet, curve: &ArcCurve) -> Id {
    let Plane { origin, x_axis, y_axis, .. } = curve.arc.circle.plane;
    // The file has no y axis: z is to make it anew.
    let plane = Plane { origin, x_axis, y_axis, z_axis: x_axis.cross(y_axis) };
    let frame = frame(sheet, &plane);
    sheet.put(format_args!("CIRCLE('',{frame},{})", real(curve.arc.circle.radius)))
}

/// Knots that differ, each with how often it stands there; the first and last count once more than openNURBS writes.
pub(super) fn knots(knots: &[f64]) -> (Vec<usize>, Vec<f64>) {
    let (mut counts, mut values): (Vec<usize>, Vec<f64>) = (Vec::new(), Vec::new());
    for &knot in knots {
        match (counts.last_mut(), values.last()) {
            (Some(count), Some(last)) if *last == knot => *count += 1,
            _ => {
                counts.push(1);
                values.push(knot);
            }
        }
    }
    if let Some(first) = counts.first_mut() {
        *first += 1;
    }
    if let Some(last) = counts.last_mut() {
        *last += 1;
    }
    (counts, values)
}

pub(super) fn spline(sheet: &mut Sheet, curve: &NurbsCurve, room: Room) -> Result<Id> {
    let curve = curve.clamped()?;
    let points: Vec<Id> = curve.control_points().into_iter().map(|p| room.point(sheet, p)).collect();
    let (points, degree) = (list(points), curve.degree());
    let (counts, values) = knots(curve.knots());
    let (counts, values) = (list(counts), list(values.into_iter().map(real)));
    let is_closed = Curve::Nurbs(curve.clone()).is_closed();
    let closed = flag(is_closed);
    if curve.is_rational() {
        let weights = list(curve.weights().into_iter().map(real));
        return Ok(sheet.put(format_args!(
            "(BOUNDED_CURVE()B_SPLINE_CURVE({degree},{points},.UNSPECIFIED.,{closed},.F.)\
             B_SPLINE_CURVE_WITH_KNOTS({counts},{values},.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()\
             RATIONAL_B_SPLINE_CURVE({weights})REPRESENTATION_ITEM(''))"
        )));
    }
    Ok(sheet.put(format_args!(
        "B_SPLINE_CURVE_WITH_KNOTS('',{degree},{points},.UNSPECIFIED.,{closed},.F.,{counts},{values},.UNSPECIFIED.)"
    )))
}
