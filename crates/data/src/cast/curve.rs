//! To lines, circles, arcs, rectangles and curves.

use katydid_geometry::{
    Arc, ArcCurve, Brep, Circle, Curve, Interval, Line, LineCurve, Plane, Point3, PolylineCurve, Rectangle,
};

use super::Sure::{Likely, Ours, Shown, Used};
use super::way::{Way, way};
use super::{Rules, place};
use crate::{Kind, Value};

pub(super) const WAYS: &[Way] = &[
    way(Kind::Line, &[Kind::Curve], "the line between the ends of one that is straight", Likely, to_line),
    way(Kind::Line, &[Kind::Vector], "the line from the origin along it", Likely, to_line),
    way(Kind::Circle, &[Kind::Curve, Kind::Arc], "the circle that it is", Likely, to_circle),
    way(
        Kind::Circle,
        &[Kind::Integer, Kind::Number],
        "the circle of that radius on world XY",
        Likely,
        to_circle,
    ),
    way(Kind::Arc, &[Kind::Circle], "the whole circle as an arc", Likely, to_arc),
    way(Kind::Arc, &[Kind::Curve], "the arc that it is", Likely, to_arc),
    way(Kind::Rectangle, &[Kind::Curve], "the rectangle that it is", Likely, to_rectangle),
    way(
        Kind::Rectangle,
        &[Kind::Domain2],
        "the rectangle of those domains on world XY",
        Likely,
        to_rectangle,
    ),
    way(
        Kind::Rectangle,
        &[Kind::Surface, Kind::Brep],
        "the rectangle around it in the plane in which it lies; else the base of the box around it",
        Used,
        to_rectangle,
    ),
    way(Kind::Rectangle, &[Kind::Box], "its base", Used, to_rectangle),
    way(Kind::Rectangle, &[Kind::Mesh], "the base of the box around it", Ours, to_rectangle),
    way(
        Kind::Curve,
        &[Kind::Line, Kind::Circle, Kind::Arc, Kind::Rectangle],
        "the same shape, as a curve; that of a line runs from 0 to 1",
        Shown,
        |v, _| curve(v).map(Value::from),
    ),
    way(
        Kind::Curve,
        &[Kind::Surface, Kind::Brep],
        "its closed border: the outline of a single face, else the longest curve of naked edges",
        Shown,
        to_border,
    ),
    way(Kind::Curve, &[Kind::Box], "the outline of a box of no thickness", Likely, to_border),
];

fn to_line(value: &Value, rules: &Rules) -> Option<Value> {
    line(value, rules).map(Value::from)
}

fn to_circle(value: &Value, rules: &Rules) -> Option<Value> {
    circle(value, rules).map(Value::from)
}

fn to_arc(value: &Value, rules: &Rules) -> Option<Value> {
    arc(value, rules).map(Value::from)
}

fn to_rectangle(value: &Value, rules: &Rules) -> Option<Value> {
    rectangle(value, rules).map(Value::from)
}

/// Of one face the outer loop comes first; of several the longest border is taken for the outline.
fn to_border(value: &Value, rules: &Rules) -> Option<Value> {
    let brep = value.brep()?.ok()?;
    let borders = brep.borders(rules.tolerance.absolute).ok()?;
    let faces = brep.faces().iter().filter(|face| !face.deleted).count();
    let closed = borders.into_iter().filter(Curve::is_closed);
    let found = if faces == 1 && !brep.edges().iter().any(|edge| edge.trims.len() > 1) {
        closed.take(1).next()
    } else {
        closed.max_by(|a, b| a.length().total_cmp(&b.length()))
    };
    found.map(Value::from)
}

/// Any of the curve-like types as a curve.
pub(super) fn curve(value: &Value) -> Option<Curve> {
    match value {
        Value::Curve(curve) => Some((**curve).clone()),
        // A line is a curve over 0 to 1: real definitions evaluate, shatter and frame lines of any length there.
        Value::Line(line) => Some(LineCurve { line: **line, domain: Interval::UNIT }.into()),
        Value::Circle(circle) => {
            let angle = Interval::new(0.0, std::f64::consts::TAU);
            Some(ArcCurve::new(Arc { circle: **circle, angle }).into())
        }
        Value::Arc(arc) => Some(ArcCurve::new(**arc).into()),
        Value::Rectangle(r) => {
            let [a, b, c, d] = r.corners();
            PolylineCurve::new(vec![a, b, c, d, a]).ok().map(Curve::from)
        }
        _ => None,
    }
}

/// The segment of a linear curve; a vector from the origin.
pub(super) fn line(value: &Value, rules: &Rules) -> Option<Line> {
    match value {
        Value::Vector(v) => Some(Line::new(Point3::ORIGIN, v.to_point())),
        Value::Curve(c) if c.is_linear(rules.tolerance.absolute) => Some(Line::new(c.start(), c.end())),
        _ => None,
    }
}

/// A circular curve; a number as the radius on world XY.
fn circle(value: &Value, rules: &Rules) -> Option<Circle> {
    let radius = match value {
        Value::Curve(c) => return c.as_circle(rules.tolerance.absolute),
        Value::Arc(arc) => {
            return ((arc.angle.length().abs() - std::f64::consts::TAU).abs() < 1e-9).then_some(arc.circle);
        }
        Value::Number(x) => *x,
        Value::Integer(i) => f64::from(*i),
        _ => return None,
    };
    (radius.is_finite() && radius > 0.0).then_some(Circle { plane: Plane::XY, radius })
}

/// An arc-shaped curve, or a whole circle.
fn arc(value: &Value, rules: &Rules) -> Option<Arc> {
    match value {
        Value::Circle(circle) => {
            Some(Arc { circle: **circle, angle: Interval::new(0.0, std::f64::consts::TAU) })
        }
        Value::Curve(c) => c.as_arc(rules.tolerance.absolute),
        _ => None,
    }
}

/// A closed polyline of four right-angled corners; a two-dimensional domain on world XY; what lies around a surface.
pub(super) fn rectangle(value: &Value, rules: &Rules) -> Option<Rectangle> {
    match value {
        Value::Rectangle(r) => Some(**r),
        Value::Curve(c) => from_polyline(&c.as_polyline()?, rules.tolerance.absolute),
        Value::Domain2(d) => Some(Rectangle { plane: Plane::XY, x: d.u, y: d.v }),
        Value::Box(b) => Some(Rectangle { plane: b.plane.offset(b.z.start), x: b.x, y: b.y }),
        Value::Surface(_) | Value::Brep(_) | Value::Kept(_) => {
            let brep = value.brep()?.ok()?;
            around(&brep, rules)
        }
        Value::Mesh(_) => {
            let bounds = place::bounds(value)?;
            let plane = Plane::XY.offset(bounds.min.z);
            let (x, y) = ((bounds.min.x, bounds.max.x), (bounds.min.y, bounds.max.y));
            Some(Rectangle { plane, x: Interval::new(x.0, x.1), y: Interval::new(y.0, y.1) })
        }
        _ => None,
    }
}

/// The rectangle around a brep in the plane of its first face where all of it lies there, else on world XY below it.
fn around(brep: &Brep, rules: &Rules) -> Option<Rectangle> {
    let tolerance = rules.tolerance.absolute;
    let plane = brep.face_surface(0).and_then(|surface| surface.plane(tolerance));
    let flat = plane.and_then(|plane| {
        let bounds = brep.bounding_box_in(&plane).ok()?;
        (bounds.z.start.abs().max(bounds.z.end.abs()) <= tolerance).then_some(bounds)
    });
    let bounds = flat.or_else(|| brep.bounding_box_in(&Plane::XY).ok())?;
    Some(Rectangle { plane: bounds.plane.offset(bounds.z.start), x: bounds.x, y: bounds.y })
}

fn from_polyline(points: &[Point3], tolerance: f64) -> Option<Rectangle> {
    let [a, b, c, d, e] = points else { return None };
    let (x, y) = (*b - *a, *d - *a);
    let closed = a.distance_to(*e) <= tolerance && (*a + x + y).distance_to(*c) <= tolerance;
    let (w, h) = (x.length(), y.length());
    if !closed || w <= tolerance || h <= tolerance || x.dot(y).abs() > tolerance * w.max(h) {
        return None;
    }
    let plane = Plane::from_axes(*a, x, y).ok()?;
    Some(Rectangle { plane, x: Interval::new(0.0, w), y: Interval::new(0.0, h) })
}
