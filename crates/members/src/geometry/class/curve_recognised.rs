//! `Curve`: whether it is a line, an arc, planar and so on.

use katydid_geometry::{Curve, Plane};

use super::curve::within;
use crate::Value;
use crate::geometry::table::Endpoints;

pub(super) fn enter(table: &mut Endpoints) {
    table.member("Curve.IsLinear this", |c: Curve| Ok(c.is_linear(within(None))));
    table.member("Curve.IsLinear this tolerance", |c: Curve, t: f64| Ok(c.is_linear(within(Some(t)))));
    table.member("Curve.IsPlanar this", |c: Curve| Ok(c.is_planar(within(None))));
    table.member("Curve.IsPlanar this tolerance", |c: Curve, t: f64| Ok(c.is_planar(within(Some(t)))));
    table.member("Curve.IsArc this", |c: Curve| Ok(c.as_arc(within(None)).is_some()));
    table.member("Curve.IsArc this tolerance", |c: Curve, t: f64| Ok(c.as_arc(within(Some(t))).is_some()));
    table.member("Curve.IsCircle this", |c: Curve| Ok(c.as_circle(within(None)).is_some()));
    table.member("Curve.IsCircle this tolerance", |c: Curve, t: f64| {
        Ok(c.as_circle(within(Some(t))).is_some())
    });
    table.member("Curve.IsEllipse this", |c: Curve| Ok(c.as_ellipse(within(None)).is_some()));
    table.member("Curve.IsEllipse this tolerance", |c: Curve, t: f64| {
        Ok(c.as_ellipse(within(Some(t))).is_some())
    });
    table.member("Curve.IsPolyline this", |c: Curve| Ok(c.as_polyline().is_some()));
    table.member("Curve.IsInPlane this testPlane", |c: Curve, plane: Plane| {
        Ok(lies_in(&c, &plane, within(None)))
    });
    table.member("Curve.IsInPlane this testPlane tolerance", |c: Curve, plane: Plane, t: f64| {
        Ok(lies_in(&c, &plane, within(Some(t))))
    });
    table.member("Curve.TryGetPlane this", |c: Curve| Ok(found(c.plane(within(None)))));
    table.member("Curve.TryGetPlane this tolerance", |c: Curve, t: f64| Ok(found(c.plane(within(Some(t))))));
    table.member("Curve.TryGetArc this", |c: Curve| Ok(found(c.as_arc(within(None)))));
    table.member("Curve.TryGetArc this tolerance", |c: Curve, t: f64| Ok(found(c.as_arc(within(Some(t))))));
    table.member("Curve.TryGetCircle this", |c: Curve| Ok(found(c.as_circle(within(None)))));
    table.member("Curve.TryGetCircle this tolerance", |c: Curve, t: f64| {
        Ok(found(c.as_circle(within(Some(t)))))
    });
    table.member("Curve.TryGetEllipse this", |c: Curve| Ok(found(c.as_ellipse(within(None)))));
    table.member("Curve.TryGetEllipse this tolerance", |c: Curve, t: f64| {
        Ok(found(c.as_ellipse(within(Some(t)))))
    });
    table.member("Curve.TryGetPolyline this", |c: Curve| Ok(found(c.as_polyline().map(Value::Polyline))));
}

/// Whether it was found, and what.
fn found<T>(shape: Option<T>) -> (bool, Option<T>) {
    (shape.is_some(), shape)
}

/// Whether the whole curve lies in a plane: the extent of its box along the normal says so.
fn lies_in(curve: &Curve, plane: &Plane, tolerance: f64) -> bool {
    let extent = curve.extent_along(plane.z_axis);
    let height = plane.origin.to_vector().dot(plane.z_axis);
    (extent.start - height).abs() <= tolerance && (extent.end - height).abs() <= tolerance
}
