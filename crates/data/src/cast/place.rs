//! To points, vectors, planes, boxes and meshes.

use katydid_geometry::{BoundingBox, Box3, Interval, Mesh, Plane, Point3, Vector3};

use super::{Rules, curve, parse};
use crate::{Content, Value};

/// The place of a value: a plane's origin, a circle's centre, the middle of a line, rectangle or box.
pub(super) fn point(value: &Value, rules: &Rules) -> Option<Point3> {
    match value {
        Value::Point(p) => Some(*p),
        Value::Vector(v) => Some(v.to_point()),
        Value::Text(text) => parse::point(text),
        Value::Integer(i) => Some(Point3::new(f64::from(*i), 0.0, 0.0)),
        Value::Number(x) => Some(Point3::new(*x, 0.0, 0.0)),
        Value::Complex(z) => Some(Point3::new(z.re, z.im, 0.0)),
        Value::Plane(plane) => Some(plane.origin),
        Value::Circle(circle) => Some(circle.plane.origin),
        Value::Arc(arc) => Some(arc.circle.plane.origin),
        Value::Line(line) => Some(line.at(0.5)),
        Value::Rectangle(r) => Some(r.plane.at(r.x.at(0.5), r.y.at(0.5), 0.0)),
        Value::Box(b) => Some(b.plane.at(b.x.at(0.5), b.y.at(0.5), b.z.at(0.5))),
        Value::Curve(c) => c.as_circle(rules.tolerance.absolute).map(|circle| circle.plane.origin),
        _ => None,
    }
}

/// A point's position vector, a plane's normal, a line from start to end.
pub(super) fn vector(value: &Value, rules: &Rules) -> Option<Vector3> {
    match value {
        Value::Point(p) => Some(p.to_vector()),
        Value::Plane(plane) => Some(plane.z_axis),
        Value::Line(line) => Some(line.direction()),
        Value::Curve(_) => curve::line(value, rules).map(|line| line.direction()),
        Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) | Value::Box(_) => None,
        _ => point(value, rules).map(Point3::to_vector),
    }
}

/// World XY moved to a point, the plane at the origin with a vector as its normal, or a shape's own plane.
pub(super) fn plane(value: &Value, rules: &Rules) -> Option<Plane> {
    match value {
        Value::Vector(v) => Plane::from_normal(Point3::ORIGIN, *v).ok(),
        Value::Circle(circle) => Some(circle.plane),
        Value::Arc(arc) => Some(arc.circle.plane),
        Value::Rectangle(r) => Some(r.plane),
        Value::Box(b) => Some(b.plane),
        Value::Line(line) => Plane::from_normal(line.from, line.direction()).ok(),
        Value::Curve(curve) => curve.plane(rules.tolerance.absolute),
        Value::Surface(surface) => surface.plane(rules.tolerance.absolute),
        Value::Transform(_) | Value::Mesh(_) | Value::Kept(_) => None,
        _ => point(value, rules).map(|origin| Plane { origin, ..Plane::XY }),
    }
}

/// The box along the world axes round any geometry.
pub(super) fn bounding_box(value: &Value) -> Option<Box3> {
    if let Value::Rectangle(r) = value {
        return Some(Box3 { plane: r.plane, x: r.x, y: r.y, z: Interval::new(0.0, 0.0) });
    }
    let bounds = bounds(value)?;
    let range = |a: f64, b: f64| Interval::new(a, b);
    Some(Box3 {
        plane: Plane::XY,
        x: range(bounds.min.x, bounds.max.x),
        y: range(bounds.min.y, bounds.max.y),
        z: range(bounds.min.z, bounds.max.z),
    })
}

/// The bounds of a value along the world axes.
pub(crate) fn bounds(value: &Value) -> Option<BoundingBox> {
    match value {
        Value::Point(p) => BoundingBox::from_points([*p]),
        Value::Mesh(mesh) => BoundingBox::from_points(mesh.vertices().iter().copied()),
        Value::Box(b) => BoundingBox::from_points(b.corners()),
        Value::TwistedBox(b) => BoundingBox::from_points(b.corners),
        Value::Surface(surface) => surface.bounding_box().ok(),
        Value::Brep(brep) => {
            let around = brep.bounding_box_in(&Plane::XY).ok()?;
            BoundingBox::from_points(around.corners())
        }
        Value::Content(content) => match &**content {
            Content::Object(object) => bounds(object.geometry.as_ref()?),
            Content::Instance(instance) => instance.bounds(),
            _ => None,
        },
        Value::Group(group) => {
            let boxes = group.members.iter().flatten().filter_map(bounds);
            boxes.reduce(|a, b| a.union(&b))
        }
        other => curve::curve(other).map(|c| c.bounding_box()),
    }
}

/// A box, also a twisted one, as a mesh of six quads.
pub(super) fn mesh(value: &Value) -> Option<Mesh> {
    match value {
        Value::Box(b) => Mesh::cuboid(b, 1, 1, 1).ok(),
        Value::TwistedBox(b) => b.to_mesh().ok(),
        _ => None,
    }
}
