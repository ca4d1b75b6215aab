//! Cylinders side by side, or apart from each other.

use super::{Axis, Carrier, CarrierCurve, CarrierMeeting, Conic, parallel};
use crate::intersect::analytic::triangle;
use crate::{Tolerance, Vector3};

/// The meeting of two cylinders with parallel axes, or of two that do not cross.
pub(super) fn meeting(a: &Carrier, b: &Carrier, tolerance: &Tolerance) -> Option<CarrierMeeting> {
    let (Carrier::Cylinder { axis: p, radius: r }, Carrier::Cylinder { axis: q, radius: s }) = (a, b) else {
        return None;
    };
    if parallel(p.direction, q.direction, tolerance) {
        return side_by_side(p, p.split(q.origin).1, [*r, *s], tolerance.absolute);
    }
    let across = p.direction.cross(q.direction);
    let n = across.unitized()?;
    let between = q.origin - p.origin;
    let d = between.dot(n);
    if d.abs() > r + s + tolerance.absolute {
        return Some(CarrierMeeting::none());
    }
    if d.abs() < r + s - tolerance.absolute {
        return None;
    }
    let along = between.cross(q.direction).dot(across) / across.length_squared();
    Some(CarrierMeeting::point(p.at(along) + n * (d * r / (r + s))))
}

/// Two circles in the plane across the axes give rulings.
fn side_by_side(axis: &Axis, way: Vector3, [r, s]: [f64; 2], near: f64) -> Option<CarrierMeeting> {
    let d = way.length();
    if d > r + s + near || d < (r - s).abs() - near {
        return Some(CarrierMeeting::none());
    }
    let unit = way.unitized()?;
    let side = axis.direction.cross(unit);
    let ruling = |along: f64, half: f64, tangent: bool| CarrierCurve {
        conic: Conic::Line(Axis { origin: axis.origin + unit * along + side * half, ..*axis }),
        tangent,
    };
    Some(CarrierMeeting::curves(if d >= r + s - near {
        vec![ruling(r * d / (r + s), 0.0, true)]
    } else if d <= (r - s).abs() + near {
        vec![ruling(if r <= s { -r } else { d + s }, 0.0, true)]
    } else {
        let (along, half) = triangle(d, r, s);
        vec![ruling(along, -half, false), ruling(along, half, false)]
    }))
}
