//! Curves with their ends in other places.

use super::{Curve, LineCurve, PolyCurve, PolylineCurve};
use crate::{Line, NurbsCurve, Point3, Result};

/// The curve with its ends moved: the control points there move, nothing else.
pub(crate) fn with_ends(curve: &Curve, [start, end]: [Point3; 2]) -> Result<Curve> {
    Ok(match curve {
        Curve::Line(c) => LineCurve { line: Line::new(start, end), domain: c.domain }.into(),
        Curve::Polyline(c) => {
            let mut points = c.points().to_vec();
            set_ends(&mut points, start, end);
            PolylineCurve::with_parameters(points, c.parameters().to_vec())?.into()
        }
        Curve::Arc(_) => with_ends(&curve.to_nurbs()?.into(), [start, end])?,
        Curve::Nurbs(c) => {
            let c = c.clamped()?;
            let mut points = c.control_points();
            set_ends(&mut points, start, end);
            let knots = c.knots().to_vec();
            if c.is_rational() {
                NurbsCurve::with_weights(c.degree(), &points, &c.weights(), knots)?.into()
            } else {
                NurbsCurve::new(c.degree(), points, knots)?.into()
            }
        }
        Curve::Poly(c) => {
            let mut segments = c.segments().to_vec();
            if let Some(first) = segments.first_mut() {
                *first = with_ends(first, [start, first.end()])?;
            }
            if let Some(last) = segments.last_mut() {
                *last = with_ends(last, [last.start(), end])?;
            }
            PolyCurve::with_parameters(segments, c.parameters().to_vec())?.into()
        }
    })
}

fn set_ends(points: &mut [Point3], start: Point3, end: Point3) {
    if let Some(first) = points.first_mut() {
        *first = start;
    }
    if let Some(last) = points.last_mut() {
        *last = end;
    }
}
