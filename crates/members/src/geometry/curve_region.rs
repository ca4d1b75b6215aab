//! Closed planar curves as the borders of regions.

use katydid_geometry::intersect::curve_curve;
use katydid_geometry::region::{CurveRelation, Region, relation};
use katydid_geometry::{Curve, Plane, Tolerance, Xform};

use super::answer::{Outcome, or_null};
use super::argument::{Some1, Within};
use super::table::Endpoints;
use crate::Fault;

pub(super) fn enter(table: &mut Endpoints) {
    let default = Within(Tolerance::default().absolute);
    table.add("curve/createbooleanunion-curvearray", move |c: Some1<Curve>| or_null(union(&c.0, default)));
    table.add("curve/createbooleanunion-curvearray_double", |c: Some1<Curve>, t: Within| {
        or_null(union(&c.0, t))
    });
    table.add("curve/createbooleanintersection-curve_curve", move |a: Curve, b: Curve| {
        or_null(common(&a, &b, default))
    });
    table.add("curve/createbooleanintersection-curve_curve_double", |a: Curve, b: Curve, t: Within| {
        or_null(common(&a, &b, t))
    });
    table.add("curve/createbooleandifference-curve_curve", move |a: Curve, b: Curve| {
        or_null(rest(&a, &[b], default))
    });
    table.add("curve/createbooleandifference-curve_curve_double", |a: Curve, b: Curve, t: Within| {
        or_null(rest(&a, &[b], t))
    });
    table.add("curve/createbooleandifference-curve_curvearray", move |a: Curve, b: Vec<Curve>| {
        or_null(rest(&a, &b, default))
    });
    table.add(
        "curve/createbooleandifference-curve_curvearray_double",
        |a: Curve, b: Vec<Curve>, t: Within| or_null(rest(&a, &b, t)),
    );
    table.add(
        "curve/planarclosedcurverelationship-curve_curve_plane_double",
        |a: Curve, b: Curve, plane: Plane, t: Within| {
            Ok(match relation(&a, &b, &plane, t.0)? {
                CurveRelation::Apart => 0,
                CurveRelation::Crossing | CurveRelation::Same => 1,
                CurveRelation::FirstInside => 2,
                CurveRelation::SecondInside => 3,
            })
        },
    );
    table.add(
        "curve/planarcurvecollision-curve_curve_plane_double",
        |a: Curve, b: Curve, plane: Plane, t: Within| {
            let flat = Xform::planar_projection(&plane);
            Ok(!curve_curve(&a.transformed(&flat)?, &b.transformed(&flat)?, t.0)?.is_empty())
        },
    );
}

/// The plane in which closed curves lie.
pub(super) fn plane_of(curves: &[Curve], Within(tolerance): Within) -> Outcome<Plane> {
    let mut plane = None;
    for (i, curve) in curves.iter().enumerate() {
        if !curve.is_closed() {
            return Err(Fault::bad_request(format!("curve {i} does not close")));
        }
        let own =
            curve.plane(tolerance).ok_or_else(|| Fault::bad_request(format!("curve {i} is not planar")))?;
        plane = plane.or(Some(own));
    }
    let plane: Plane = plane.ok_or_else(|| Fault::bad_request("there are no curves"))?;
    let flat =
        |curve: &Curve| curve.hull_points().iter().all(|p| plane.signed_distance(*p).abs() <= tolerance);
    match curves.iter().position(|curve| !flat(curve)) {
        Some(i) => Err(Fault::bad_request(format!("curve {i} does not lie in the plane of the first"))),
        None => Ok(plane),
    }
}

fn union(curves: &[Curve], tolerance: Within) -> Outcome<Vec<Curve>> {
    Ok(Region::union_of(curves, &plane_of(curves, tolerance)?, tolerance.0)?.curves())
}

fn common(a: &Curve, b: &Curve, tolerance: Within) -> Outcome<Vec<Curve>> {
    let (a, b) = (std::slice::from_ref(a), std::slice::from_ref(b));
    let plane = plane_of(&[a, b].concat(), tolerance)?;
    Ok(Region::intersection_of(a, b, &plane, tolerance.0)?.curves())
}

fn rest(a: &Curve, b: &[Curve], tolerance: Within) -> Outcome<Vec<Curve>> {
    let a = std::slice::from_ref(a);
    let plane = plane_of(&[a, b].concat(), tolerance)?;
    Ok(Region::difference_of(a, b, &plane, tolerance.0)?.curves())
}
