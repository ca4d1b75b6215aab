//! Display / Dimensions: lines with arrows at both ends, and what they measure.

use std::sync::Arc as Shared;

use katydid_definition::document::Object;
use katydid_elementary::Elementary;
use katydid_expression::{Dialect, Variant, format};
use katydid_geometry::{Arc, Circle, Line, Mesh, Plane, Point3, Vector3};
use uuid::{Uuid, uuid};

use super::Draw;
use crate::Painter;
use crate::rows::Row;
use crate::{Form, Look};

pub(super) const DRAWN: &[(Uuid, Draw)] = &[
    (uuid!("3de3d3a0-1a1b-488c-b3d9-3fba0fdf07a8"), aligned),
    (uuid!("fc6b519e-df6d-4ce1-a1f4-083f1c217c14"), angular),
    (uuid!("91f3bde5-26e6-432e-a5fe-a2938b2a94f9"), angles_of_mesh),
    (uuid!("1bd97813-4fec-4453-9645-4ac920844f9d"), arc),
    (uuid!("7e9489e0-122d-401a-aba8-f1dae0217c40"), circular),
    (uuid!("d78f026a-0109-4bcc-bf91-d08475711466"), line),
    (uuid!("5018bf8d-8566-4917-a6e3-5a623bda8079"), linear),
    (uuid!("c5208969-16f9-48af-8a86-e500c033fb76"), marker),
    (uuid!("7dd42002-75bb-4f41-857f-472a140b3b28"), serial),
];

/// Points along a measured arc.
const ROUND: u32 = 48;

/// The text of a dimension: `{0}` stands for the number. A form that cannot be read is shown as it is.
fn worded(row: &Row<'_>, k: usize, x: f64) -> String {
    let form = row.item::<Shared<str>>(k).unwrap_or_else(|| "{0:0.00}".into());
    format(&form, &[Variant::Number(x)], Dialect::default()).unwrap_or_else(|_| form.to_string())
}

fn size(row: &Row<'_>, k: usize) -> f64 {
    row.item::<f64>(k).filter(|x| x.is_finite() && *x > 0.0).unwrap_or(1.0)
}

fn thin(painter: &Painter<'_>) -> Look {
    Look { width: 0.9, ..painter.look }
}

/// A text at a point, along a direction, read from left to right on a plane with that normal.
fn write(painter: &mut Painter<'_>, at: Point3, along: Vector3, normal: Vector3, text: String, size: f64) {
    let backwards = along.x < -1e-9 || (along.x.abs() <= 1e-9 && along.y < 0.0);
    let along = if backwards { -along } else { along };
    let up = normal.cross(along);
    if let Ok(plane) =
        Plane::from_axes(at + up.unitized().unwrap_or(Vector3::ZERO) * (0.25 * size), along, up)
    {
        painter.scene.add(Form::Writing { plane, text, size, justification: 8 }, painter.look);
    }
}

/// A line with arrows at both ends and a text over its middle.
fn measured(painter: &mut Painter<'_>, a: Point3, b: Point3, normal: Vector3, text: String, size: f64) {
    let (look, middle) = (thin(painter), a.lerp(b, 0.5));
    painter.scene.add(Form::Arrow(middle, a - middle), look);
    painter.scene.add(Form::Arrow(middle, b - middle), look);
    write(painter, middle, b - a, normal, text, size);
}

/// An arc with arrows at both ends and a text over its middle, from angle `from` to `to` in a plane.
fn swept(
    painter: &mut Painter<'_>,
    plane: &Plane,
    radius: f64,
    [from, to]: [f64; 2],
    text: String,
    size: f64,
) {
    let at = |t: f64| {
        let (sin, cos) = t.sine_cosine();
        plane.at(radius * cos, radius * sin, 0.0)
    };
    let points: Vec<Point3> =
        (0..=ROUND).map(|k| at(from + (to - from) * f64::from(k) / f64::from(ROUND))).collect();
    let look = thin(painter);
    // Heads of their full size, but that both have room on the arc.
    let room = 0.4 * radius * (to - from).abs();
    for (angle, sense) in [(from, -1.0), (to, 1.0)] {
        let way = plane.z_axis.cross(at(angle) - plane.origin).unitized().unwrap_or(Vector3::ZERO);
        painter.scene.add(Form::Tip(at(angle), way * (sense * room * (to - from).signum())), look);
    }
    painter.scene.add(Form::Lines(points), look);
    let middle = 0.5 * (from + to);
    let out = at(middle) - plane.origin;
    let place = plane.origin + out * (1.0 + 0.7 * size / radius.max(1e-300));
    write(painter, place, plane.z_axis.cross(out), plane.z_axis, text, size);
}

/// A normal to a direction that looks upwards, or to the front.
fn across(direction: Vector3) -> Vector3 {
    let upright = direction.cross(Vector3::Z).length() < 1e-9 * direction.length();
    let side = if upright { Vector3::X } else { Vector3::Z.cross(direction) };
    direction.cross(side)
}

fn aligned(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(plane), Some(a), Some(b)) =
        (row.item::<Plane>(0), row.item::<Point3>(1), row.item::<Point3>(2))
    else {
        return;
    };
    let offset = row.item::<f64>(3).unwrap_or(1.0);
    let (p, q) = (plane.closest_point(a), plane.closest_point(b));
    let side = plane.z_axis.cross(q - p).unitized().unwrap_or(plane.y_axis) * offset;
    let look = thin(painter);
    for (from, to) in [(a, p + side), (b, q + side)] {
        painter.scene.add(Form::Lines(vec![from, to]), look);
    }
    let (text, size) = (worded(row, 4, p.distance_to(q)), size(row, 5));
    measured(painter, p + side, q + side, plane.z_axis, text, size);
}

fn line(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let Some(line) = row.item::<Line>(0) else { return };
    let normal = across(line.direction());
    measured(painter, line.from, line.to, normal, worded(row, 1, line.length()), size(row, 2));
}

fn linear(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(line), Some(a), Some(b)) = (row.item::<Line>(0), row.item::<Point3>(1), row.item::<Point3>(2))
    else {
        return;
    };
    between(painter, &line, a, b, worded(row, 3, along(&line, b) - along(&line, a)), size(row, 4));
}

fn serial(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let Some(line) = row.item::<Line>(0) else { return };
    let points: Vec<Point3> = row.list(1);
    let Some(&first) = points.first() else { return };
    for w in points.windows(2) {
        let [a, b] = *w else { continue };
        let far = (along(&line, b) - along(&line, first)).abs();
        between(painter, &line, a, b, worded(row, 2, far), size(row, 3));
    }
}

/// How far along a line a point lies, in units of the model.
fn along(line: &Line, p: Point3) -> f64 {
    line.unit_direction().map_or(0.0, |d| d.dot(p - line.from))
}

fn between(painter: &mut Painter<'_>, line: &Line, a: Point3, b: Point3, text: String, size: f64) {
    let Some(direction) = line.unit_direction() else { return };
    let [p, q] = [a, b].map(|x| line.from + direction * along(line, x));
    let look = thin(painter);
    for (from, to) in [(a, p), (b, q)] {
        painter.scene.add(Form::Lines(vec![from, to]), look);
    }
    measured(painter, p, q, across(direction), text, size);
}

fn marker(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(line), Some(text)) = (row.item::<Line>(0), row.item::<Shared<str>>(1)) else { return };
    let look = thin(painter);
    painter.scene.add(Form::Arrow(line.to, line.from - line.to), look);
    let normal = across(line.direction());
    let size = size(row, 2);
    write(painter, line.to, line.direction(), normal, text.to_string(), size);
}

fn angular(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(centre), Some(a), Some(b)) =
        (row.item::<Point3>(0), row.item::<Point3>(1), row.item::<Point3>(2))
    else {
        return;
    };
    let Ok(plane) = Plane::from_axes(centre, a - centre, b - centre) else { return };
    let Some(angle) = (a - centre).angle_to(b - centre) else { return };
    let reflex = row.item::<bool>(3) == Some(true);
    let ends = if reflex { [angle, std::f64::consts::TAU] } else { [0.0, angle] };
    let radius = 0.5 * centre.distance_to(a).min(centre.distance_to(b));
    let text = worded(row, 4, (ends[1] - ends[0]).to_degrees());
    swept(painter, &plane, radius, ends, text, size(row, 5));
    let look = thin(painter);
    for p in [a, b] {
        painter.scene.add(Form::Lines(vec![centre, p]), look);
    }
}

fn arc(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let Some(arc) = row.item::<Arc>(0) else { return };
    let radius = arc.circle.radius + row.item::<f64>(1).unwrap_or(1.0);
    let look = thin(painter);
    for p in [arc.start(), arc.end()] {
        let out = (p - arc.circle.center()).unitized().unwrap_or(Vector3::X);
        painter.scene.add(Form::Lines(vec![p, arc.circle.center() + out * radius]), look);
    }
    let text = worded(row, 2, arc.angle.length().to_degrees());
    swept(painter, &arc.circle.plane, radius.abs(), [arc.angle.start, arc.angle.end], text, size(row, 3));
}

fn circular(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let (Some(circle), Some(a), Some(b)) =
        (row.item::<Circle>(0), row.item::<Point3>(1), row.item::<Point3>(2))
    else {
        return;
    };
    let angle = |p: Point3| {
        let [x, y, _] = circle.plane.coordinates(p);
        y.arctangent_of(x)
    };
    let from = angle(a);
    let sweep = (angle(b) - from).rem_euclid(std::f64::consts::TAU);
    let look = thin(painter);
    for p in [a, b] {
        painter.scene.add(Form::Lines(vec![p, circle.at(angle(p))]), look);
    }
    let text = worded(row, 3, sweep.to_degrees());
    swept(painter, &circle.plane, circle.radius, [from, from + sweep], text, size(row, 4));
}

fn angles_of_mesh(painter: &mut Painter<'_>, _: &Object, row: &Row<'_>) {
    let Some(mesh) = row.item::<Shared<Mesh>>(0) else { return };
    let factor = row.item::<f64>(3).unwrap_or(0.2);
    let (least, most) =
        (row.item::<f64>(4).unwrap_or(0.0), row.item::<f64>(5).unwrap_or(std::f64::consts::TAU));
    for face in 0..mesh.faces().len() {
        let points = mesh.face_points(face).unwrap_or_default();
        let n = points.len();
        for (k, &p) in points.iter().enumerate() {
            let (Some(&a), Some(&b)) = (points.get((k + 1) % n), points.get((k + n - 1) % n)) else {
                continue;
            };
            let (Some(angle), Ok(plane)) = ((a - p).angle_to(b - p), Plane::from_axes(p, a - p, b - p))
            else {
                continue;
            };
            let radius = factor * p.distance_to(a).min(p.distance_to(b));
            if (least..=most).contains(&angle) && radius > 0.0 {
                let text = worded(row, 1, angle.to_degrees());
                swept(painter, &plane, radius, [0.0, angle], text, size(row, 2));
            }
        }
    }
}
