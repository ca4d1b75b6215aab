//! Curves changed through their edit points and ends, made periodic, wound about others.

use katydid_geometry::{
    Curve, Direction, Interval, NurbsCurve, NurbsSurface, Point3, Surface, Vector3, curves_of_two_views,
};

use super::answer::{Outcome, or_null};
use super::argument::{Count, Turn, Within};
use super::choice::{Along, EndCondition};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    table.add("nurbscurve/setgrevillepoints-nurbscurve_point3darray", |c: Curve, points: Vec<Point3>| {
        let nurbs = c.to_nurbs()?;
        if points.len() != nurbs.edit_parameters().len() {
            return Ok((false, c));
        }
        Ok((true, Curve::from(nurbs.through_edit_points(&points)?)))
    });
    table.add(
        "nurbscurve/setendcondition-nurbscurve_bool_nurbscurveendconditiontype_point3d_vector3d",
        |c: Curve, at_end: bool, kind: EndCondition, p: Point3, tangent: Vector3| {
            set_end(&c, at_end, kind, p, tangent, None)
        },
    );
    table.add(
        "nurbscurve/setendcondition-nurbscurve_bool_nurbscurveendconditiontype_point3d_vector3d_vector3d",
        |c: Curve, at_end: bool, kind: EndCondition, p: Point3, tangent: Vector3, bend: Vector3| {
            set_end(&c, at_end, kind, p, tangent, Some(bend))
        },
    );
    table.add(
        "curve/createcurve2view-curve_curve_vector3d_vector3d_double_double",
        |a: Curve, b: Curve, from: Vector3, other: Vector3, t: Within, angle: Turn| {
            Ok(curves_of_two_views([&a, &b], [from, other], &angle.and(t))?)
        },
    );
    table.add("curve/createperiodiccurve-curve", |c: Curve| periodic_curve(&c, true));
    table.add("curve/createperiodiccurve-curve_bool", |c: Curve, smooth: bool| periodic_curve(&c, smooth));
    table.add("surface/createperiodicsurface-surface_int", |s: Surface, along: Along| {
        periodic_surface(&s, along.0, true)
    });
    table.add("surface/createperiodicsurface-surface_int_bool", |s: Surface, along: Along, smooth: bool| {
        periodic_surface(&s, along.0, smooth)
    });
    table.add(
        "nurbscurve/createspiral-curve_double_double_point3d_double_double_double_double_int",
        |rail: Curve,
         t0: f64,
         t1: f64,
         toward: Point3,
         pitch: f64,
         turns: f64,
         r0: f64,
         r1: f64,
         points: Count<5, 1_000>| {
            spiral(&rail, Interval::new(t0, t1), toward, [pitch, turns], [r0, r1], points.0)
        },
    );
}

/// The curve with a place, a direction and a curvature at one end, as far as they are wanted.
fn set_end(
    curve: &Curve,
    at_end: bool,
    EndCondition(order): EndCondition,
    place: Point3,
    tangent: Vector3,
    bend: Option<Vector3>,
) -> Outcome<(bool, Curve)> {
    let Some(order) = order else { return Ok((true, curve.clone())) };
    if order == 2 && bend.is_none() {
        return Err(Fault::bad_request("continuity is Curvature, and no curvature is given"));
    }
    let (direction, bend) = ((order > 0).then_some(tangent), bend.filter(|_| order == 2));
    match or_null(curve.to_nurbs()?.with_end(at_end, place, direction, bend).map_err(Fault::from))? {
        Some(set) => Ok((true, set.into())),
        None => Ok((false, curve.clone())),
    }
}

/// Curves that do not close are another matter: how Rhino closes them is not known.
fn periodic_curve(curve: &Curve, smooth: bool) -> Outcome<Option<Curve>> {
    if !curve.is_closed() {
        return Err(Fault::not_supported("periodic curves in the place of open ones"));
    }
    let nurbs: NurbsCurve = curve.to_nurbs()?;
    or_null(nurbs.to_periodic(smooth).map(Curve::from).map_err(Fault::from))
}

fn periodic_surface(surface: &Surface, along: Direction, smooth: bool) -> Outcome<Option<Surface>> {
    if !surface.is_closed(along) {
        return Err(Fault::not_supported("periodic surfaces in the place of open ones"));
    }
    let nurbs: NurbsSurface = surface.to_nurbs()?;
    or_null(nurbs.to_periodic(along, smooth).map(Surface::from).map_err(Fault::from))
}

/// A spiral about a part of a rail; without turns, as many as the pitch makes of its length.
fn spiral(
    rail: &Curve,
    range: Interval,
    toward: Point3,
    [pitch, turns]: [f64; 2],
    radii: [f64; 2],
    points: usize,
) -> Outcome<Option<Curve>> {
    let turns = if turns != 0.0 {
        turns
    } else if pitch == 0.0 {
        return Err(Fault::bad_request("turnCount and pitch are both 0"));
    } else {
        rail.length_between(range.ordered()) / pitch
    };
    let made = rail.spiral_about(range, toward, turns, radii, points);
    or_null(made.map(Curve::from).map_err(Fault::from))
}
