//! NURBS curves: spirals, frames along rails, Greville points, curves made compatible.

use std::f64::consts::TAU;

use katydid_elementary::Elementary;
use katydid_geometry::{Arc, Circle, Curve, NurbsCurve, Plane, Point3, Vector3, compatible_curves};

use super::answer::Outcome;
use super::argument::{Count, Some1, Turn, Within};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add(
        "nurbscurve/createspiral-point3d_vector3d_point3d_double_double_double_double",
        |start: Point3, axis: Vector3, radius_point: Point3, pitch: f64, turns: f64, r0: f64, r1: f64| {
            spiral(start, axis, radius_point, pitch, turns, [r0, r1]).map(Curve::from)
        },
    );
    table.add(
        "nurbscurve/createfromcircle-circle_int_int",
        |c: Circle, degree: Count<1, 11>, n: Count<3, 10_000>| {
            Ok(Curve::from(Curve::from(c).rebuilt(degree.0, n.0, false)?.curve))
        },
    );
    table.add("nurbscurve/createfromarc-arc_int_int", |a: Arc, degree: Count<1, 11>, n: Count<3, 10_000>| {
        Ok(Curve::from(Curve::from(a).rebuilt(degree.0, n.0, false)?.curve))
    });
    table.add("nurbscurve/createrailframes-nurbscurve_doublearray", |c: Curve, parameters: Some1<f64>| {
        if parameters.0.windows(2).any(|pair| pair.first() >= pair.last()) {
            return Err(Fault::bad_request("parameters do not increase"));
        }
        Ok(c.perpendicular_frames(&parameters.0))
    });
    table.add("nurbscurve/grevillepoints-nurbscurve_bool", |c: Curve, all: bool| {
        let nurbs = c.to_nurbs()?;
        let parameters = if all { nurbs.greville_abscissae() } else { nurbs.edit_parameters() };
        Ok(parameters.into_iter().map(|t| nurbs.point_at(t)).collect::<Vec<Point3>>())
    });
    table.add(
        "nurbscurve/createparabolafromvertex-point3d_point3d_point3d",
        |v: Point3, a: Point3, b: Point3| parabola(v, a, b),
    );
    table.add(
        "nurbscurve/makecompatible-curvearray_point3d_point3d_int_int_double_double",
        |c: Some1<Curve>, _: Option<Point3>, _: Option<Point3>, simplify: i32, _: i32, _: Within, _: Turn| {
            if simplify != 0 {
                return Err(Fault::not_supported("curves that are rebuilt or refitted first"));
            }
            let nurbs = c.0.iter().map(Curve::to_nurbs).collect::<Result<Vec<_>, _>>()?;
            Ok(compatible_curves(&nurbs)?.into_iter().map(Curve::from).collect::<Vec<_>>())
        },
    );
}

/// Pieces of a spiral's turn. A cubic of Hermite's over an angle h misses the circle by about h⁴/384 of the radius: here
/// 4·10⁻⁸.
const PIECES: f64 = 100.0;
/// The most turns.
const MOST: f64 = 1000.0;

/// A spiral about an axis from a point at an angle, whose radius goes evenly from one to the other: a helix with equal
/// radii, flat with a pitch of 0. A pitch is the height of a turn; fewer than no turns run the other way about.
fn spiral(
    start: Point3,
    axis: Vector3,
    radius_point: Point3,
    pitch: f64,
    turns: f64,
    [r0, r1]: [f64; 2],
) -> Outcome<NurbsCurve> {
    if turns == 0.0 || turns.abs() > MOST {
        return Err(Fault::bad_request(format!("turnCount is {turns}, not up to {MOST}, and not 0")));
    }
    if r0 == 0.0 && r1 == 0.0 {
        return Err(Fault::bad_request("radius0 and radius1 are both 0"));
    }
    let upright = axis.unitized().ok_or_else(|| Fault::bad_request("axisDir has no length"))?;
    let across = radius_point - start;
    let frame = match (across - upright * across.dot(upright)).unitized() {
        Some(x) => Plane { origin: start, x_axis: x, y_axis: upright.cross(x), z_axis: upright },
        None => return Err(Fault::bad_request("radiusPoint lies on the axis")),
    };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 100,000")]
    let pieces = (turns.abs() * PIECES).ceil().max(4.0) as u32;
    let (mut points, mut derivatives, mut parameters) = (Vec::new(), Vec::new(), Vec::new());
    let (growth, rise, sweep) = (r1 - r0, pitch * turns.abs(), TAU * turns);
    for k in 0..=pieces {
        let s = f64::from(k) / f64::from(pieces);
        let (radius, (sin, cos)) = (r0 + growth * s, (sweep * s).sine_cosine());
        points.push(frame.at(radius * cos, radius * sin, rise * s));
        let x = growth * cos - radius * sweep * sin;
        let y = growth * sin + radius * sweep * cos;
        derivatives.push(frame.x_axis * x + frame.y_axis * y + frame.z_axis * rise);
        parameters.push(s);
    }
    Ok(NurbsCurve::hermite_through(&points, &derivatives, &parameters)?)
}

/// The parabola with a vertex and two ends, which must lie on one: at the vertex it runs at right angles to its axis.
fn parabola(vertex: Point3, start: Point3, end: Point3) -> Outcome<Option<Curve>> {
    let (a, b) = (start - vertex, end - vertex);
    // Along the axis y = k·x²: of both ends height and square of the distance from the axis are in one proportion.
    let normal = a.cross(b).unitized();
    let Some(normal) = normal else { return Ok(None) };
    let Some(axis) = axis_of(a, b, normal) else { return Ok(None) };
    let across = axis.cross(normal);
    let (xa, xb) = (a.dot(across), b.dot(across));
    // A parabola over its chord: the middle control point lies where the tangents at the ends meet, which is halfway
    // between them across the axis, at the height −… that the vertex fixes.
    let k = a.dot(axis) / (xa * xa);
    let middle = vertex + across * (0.5 * (xa + xb)) + axis * (k * xa * xb);
    Ok(Some(NurbsCurve::bezier(&[start, middle, end])?.into()))
}

/// The direction in which both ends have heights in proportion to the squares of their distances from the axis, on the
/// same side of the vertex: found by halving between the two directions to the ends.
fn axis_of(a: Vector3, b: Vector3, normal: Vector3) -> Option<Vector3> {
    let x = a.unitized()?;
    let y = normal.cross(x);
    let span = b.dot(y).arctangent_of(b.dot(x));
    let direction = |angle: f64| x * angle.cosine() + y * angle.sine();
    let miss = |angle: f64| {
        let axis = direction(angle);
        let across = axis.cross(normal);
        let (xa, xb) = (a.dot(across), b.dot(across));
        a.dot(axis) * xb * xb - b.dot(axis) * xa * xa
    };
    let (mut low, mut high) = (0.0, span);
    let (first, last) = (miss(low), miss(high));
    if first * last >= 0.0 {
        return None;
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if miss(middle) * first > 0.0 { low = middle } else { high = middle }
    }
    Some(direction(0.5 * (low + high)))
}
