//! To points, vectors, planes and boxes.

use std::sync::Arc as Shared;

use katydid_3dm::{Limits, Object, RawObject};
use katydid_geometry::{BoundingBox, Box3, Interval, Plane, Point3, TwistedBox, Vector3};

use super::Sure::{Likely, Ours, Shown};
use super::way::{Way, way};
use super::{Rules, curve, parse};
use crate::{Content, Kind, Value};

pub(super) const WAYS: &[Way] = &[
    way(Kind::Point, &[Kind::Vector], "the point at its end, from the origin", Shown, to_point),
    way(Kind::Point, &[Kind::Text], "the point that it spells, such as `{1,2,3}`", Shown, to_point),
    way(Kind::Point, &[Kind::Integer, Kind::Number], "the point of that x", Likely, to_point),
    way(Kind::Point, &[Kind::Complex], "the point of its real and imaginary parts", Likely, to_point),
    way(Kind::Point, &[Kind::Plane], "its origin", Shown, to_point),
    way(Kind::Point, &[Kind::Circle, Kind::Arc], "its centre", Likely, to_point),
    way(Kind::Point, &[Kind::Line, Kind::Rectangle, Kind::Box], "its middle", Likely, to_point),
    way(Kind::Point, &[Kind::Curve], "the centre of one that is a circle", Likely, to_point),
    way(Kind::Vector, &[Kind::Point], "the vector from the origin to it", Shown, to_vector),
    way(Kind::Vector, &[Kind::Text], "the vector that it spells, such as `{1,2,3}`", Likely, to_vector),
    way(
        Kind::Vector,
        &[Kind::Integer, Kind::Number, Kind::Complex],
        "the vector to the point that it becomes",
        Likely,
        to_vector,
    ),
    way(Kind::Vector, &[Kind::Plane], "its normal", Likely, to_vector),
    way(
        Kind::Vector,
        &[Kind::Line, Kind::Curve],
        "from the start to the end of one that is straight",
        Likely,
        to_vector,
    ),
    way(Kind::Vector, &[Kind::Surface, Kind::Brep], "the normal of one that is flat", Ours, to_vector),
    way(
        Kind::Plane,
        &[Kind::Point, Kind::Text, Kind::Integer, Kind::Number, Kind::Complex],
        "world XY moved to the point that it is; a text such as `O(0,0,0) Z(0,0,1)` names a normal too",
        Shown,
        to_plane,
    ),
    way(Kind::Plane, &[Kind::Vector], "the plane at the origin across it", Likely, to_plane),
    way(
        Kind::Plane,
        &[Kind::Circle, Kind::Arc, Kind::Rectangle, Kind::Box],
        "its own plane",
        Shown,
        to_plane,
    ),
    way(Kind::Plane, &[Kind::Line], "the plane across it at its start", Likely, to_plane),
    way(
        Kind::Plane,
        &[Kind::Curve, Kind::Surface, Kind::Brep],
        "the plane in which it lies",
        Likely,
        to_plane,
    ),
    way(Kind::Box, &[Kind::Rectangle], "the box of no height on it", Likely, to_box),
    way(Kind::Box, &[Kind::Geometry], "the box around it along the world axes", Shown, to_box),
    way(Kind::TwistedBox, &[Kind::Box], "the same box, its corners free", Likely, to_twisted_box),
    way(
        Kind::TwistedBox,
        &[Kind::Rectangle, Kind::Curve, Kind::Surface, Kind::Brep, Kind::Mesh, Kind::SubD, Kind::Group],
        "the box around it, its corners free",
        Ours,
        to_twisted_box,
    ),
];

fn to_point(value: &Value, rules: &Rules) -> Option<Value> {
    point(value, rules).map(Value::Point)
}

fn to_vector(value: &Value, rules: &Rules) -> Option<Value> {
    vector(value, rules).map(Value::Vector)
}

fn to_plane(value: &Value, rules: &Rules) -> Option<Value> {
    plane(value, rules).map(Value::from)
}

fn to_box(value: &Value, _: &Rules) -> Option<Value> {
    bounding_box(value).map(Value::from)
}

fn to_twisted_box(value: &Value, _: &Rules) -> Option<Value> {
    match value {
        Value::Box(b) => Some(Value::from(TwistedBox::from(**b))),
        other => bounding_box(other).map(|b| Value::from(TwistedBox::from(b))),
    }
}

/// The place of a value: a plane's origin, a circle's centre, the middle of a line, rectangle or box.
fn point(value: &Value, rules: &Rules) -> Option<Point3> {
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
fn vector(value: &Value, rules: &Rules) -> Option<Vector3> {
    match value {
        Value::Point(p) => Some(p.to_vector()),
        Value::Plane(plane) => Some(plane.z_axis),
        Value::Line(line) => Some(line.direction()),
        Value::Curve(_) => curve::line(value, rules).map(|line| line.direction()),
        Value::Surface(_) | Value::Brep(_) | Value::Kept(_) => plane(value, rules).map(|plane| plane.z_axis),
        Value::Circle(_) | Value::Arc(_) | Value::Rectangle(_) | Value::Box(_) => None,
        _ => point(value, rules).map(Point3::to_vector),
    }
}

/// World XY moved to a point, the plane at the origin with a vector as its normal, or a shape's own plane.
fn plane(value: &Value, rules: &Rules) -> Option<Plane> {
    let of_surface = |surface: &katydid_geometry::Surface| surface.plane(rules.tolerance.absolute);
    match value {
        Value::Vector(v) => Plane::from_normal(Point3::ORIGIN, *v).ok(),
        Value::Circle(circle) => Some(circle.plane),
        Value::Arc(arc) => Some(arc.circle.plane),
        Value::Rectangle(r) => Some(r.plane),
        Value::Box(b) => Some(b.plane),
        Value::Line(line) => Plane::from_normal(line.from, line.direction()).ok(),
        Value::Curve(curve) => curve.plane(rules.tolerance.absolute),
        Value::Surface(surface) => of_surface(surface),
        Value::Brep(_) | Value::Kept(_) => {
            let brep = value.brep()?.ok()?;
            let [_] = brep.faces() else { return None };
            brep.face_surface(0).and_then(of_surface)
        }
        Value::Text(text) => {
            parse::plane(text).or_else(|| parse::point(text).map(|origin| Plane { origin, ..Plane::XY }))
        }
        _ => point(value, rules).map(|origin| Plane { origin, ..Plane::XY }),
    }
}

/// The box along the world axes round any geometry.
fn bounding_box(value: &Value) -> Option<Box3> {
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
        Value::Brep(brep) => of_brep(brep),
        Value::Kept(kept) => match value.brep() {
            Some(brep) => of_brep(&brep.ok()?),
            None => of_kept(kept),
        },
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

fn of_brep(brep: &Shared<katydid_geometry::Brep>) -> Option<BoundingBox> {
    BoundingBox::from_points(brep.bounding_box_in(&Plane::XY).ok()?.corners())
}

/// The bounds of a SubD or a point cloud that is kept as a program wrote it.
fn of_kept(kept: &RawObject) -> Option<BoundingBox> {
    match kept.parse_shape(&Limits::default()).ok()? {
        Object::SubD(subd) => {
            let subd = subd.to_subd().ok()?;
            BoundingBox::from_points(subd.limit_mesh(subd.fine_levels()).ok()?.vertices().iter().copied())
        }
        Object::PointCloud(cloud) => BoundingBox::from_points(cloud.points.iter().copied()),
        _ => None,
    }
}
