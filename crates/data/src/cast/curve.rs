//! Between lines, circles, arcs, rectangles and curves.

use katydid_geometry::{
    Arc, ArcCurve, Circle, Curve, Interval, Line, LineCurve, Plane, PlaneSurface, Point3, PolylineCurve,
    Rectangle, Surface,
};

use super::Rules;
use crate::Value;

/// Any of the curve-like types as a curve.
pub(super) fn curve(value: &Value) -> Option<Curve> {
    match value {
        Value::Curve(curve) => Some((**curve).clone()),
        Value::Line(line) => Some(LineCurve::new(**line).into()),
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
pub(super) fn circle(value: &Value, rules: &Rules) -> Option<Circle> {
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
pub(super) fn arc(value: &Value, rules: &Rules) -> Option<Arc> {
    match value {
        Value::Circle(circle) => {
            Some(Arc { circle: **circle, angle: Interval::new(0.0, std::f64::consts::TAU) })
        }
        Value::Curve(c) => c.as_arc(rules.tolerance.absolute),
        _ => None,
    }
}

/// A closed polyline of four right-angled corners; a two-dimensional domain on world XY.
pub(super) fn rectangle(value: &Value, rules: &Rules) -> Option<Rectangle> {
    match value {
        Value::Curve(c) => from_polyline(&c.as_polyline()?, rules.tolerance.absolute),
        Value::Domain2(d) => Some(Rectangle { plane: Plane::XY, x: d.u, y: d.v }),
        _ => None,
    }
}

/// The flat surface inside a rectangle or a rectangular curve. Other outlines need a trimmed surface.
pub(super) fn surface(value: &Value, rules: &Rules) -> Option<Surface> {
    let r = match value {
        Value::Rectangle(r) => **r,
        Value::Curve(_) => rectangle(value, rules)?,
        _ => return None,
    };
    PlaneSurface::new(r.plane, r.x.ordered(), r.y.ordered()).ok().map(Surface::from)
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
