//! Planes cut planes, cylinders, cones and tori that do not stand across them.

use std::f64::consts::FRAC_PI_2;

use katydid_elementary::Elementary;

use super::{Axis, CarrierCurve, CarrierMeeting, Conic};
use crate::{Circle, Ellipse, Plane, Tolerance, Vector3};

fn crossing(conic: Conic) -> CarrierCurve {
    CarrierCurve { conic, tangent: false }
}

/// Two planes that are not parallel.
pub(super) fn with_plane(p: &Plane, q: &Plane, _: &Tolerance) -> Option<CarrierMeeting> {
    let (m, n) = (p.z_axis, q.z_axis);
    let across = m.cross(n);
    // The foot of the first origin: down its own plane to the other one.
    let down = (n - m * m.dot(n)) / across.length_squared();
    let origin = p.origin - down * q.signed_distance(p.origin);
    let line = Axis { origin, direction: across.unitized()? };
    Some(CarrierMeeting::curves(vec![crossing(Conic::Line(line))]))
}

/// A plane that does not stand across the axis of a cylinder.
pub(super) fn of_cylinder(
    plane: &Plane,
    axis: &Axis,
    radius: f64,
    tolerance: &Tolerance,
) -> Option<CarrierMeeting> {
    let n = plane.z_axis;
    let rise = n.dot(axis.direction);
    if rise.abs() <= tolerance.angle {
        // Rulings, at the ends of a chord of the circle.
        let n = (n - axis.direction * rise).unitized()?;
        let off = n.dot(plane.origin - axis.origin);
        let side = n.cross(axis.direction);
        let ruling = |w: f64, tangent: bool| CarrierCurve {
            conic: Conic::Line(Axis { origin: axis.origin + n * off + side * w, ..*axis }),
            tangent,
        };
        return Some(CarrierMeeting::curves(if off.abs() > radius + tolerance.absolute {
            vec![]
        } else if off.abs() >= radius - tolerance.absolute {
            vec![ruling(0.0, true)]
        } else {
            let half = ((radius - off) * (radius + off)).sqrt();
            vec![ruling(-half, false), ruling(half, false)]
        }));
    }
    let center = axis.at(n.dot(plane.origin - axis.origin) / rise);
    let long = (axis.direction - n * rise).unitized()?;
    let frame = Plane::from_axes(center, long, n.cross(long)).ok()?;
    let ellipse = Ellipse::new(frame, radius / rise.abs(), radius).ok()?;
    Some(CarrierMeeting::curves(vec![crossing(Conic::Ellipse(ellipse))]))
}

/// A plane that does not stand across the axis of a cone.
///
/// In the plane let p run from the foot of the apex along the shadow of the axis, q across it, h be the plane's distance
/// from the apex, s and c the sine and cosine of the angle between axis and normal, S and C those of the half angle. The
/// cone's equation (h c + p s)² = C² (h² + p² + q²) is a conic in p and q.
pub(super) fn of_cone(
    plane: &Plane,
    axis: &Axis,
    half_angle: f64,
    tolerance: &Tolerance,
) -> Option<CarrierMeeting> {
    let off = plane.signed_distance(axis.origin);
    let (n, h) = if off > 0.0 { (-plane.z_axis, off) } else { (plane.z_axis, -off) };
    let c = n.dot(axis.direction);
    let shadow = axis.direction - n * c;
    let s = shadow.length();
    let e = shadow.unitized()?;
    let f = n.cross(e);
    let (sin, cos) = half_angle.sine_cosine();
    // How much steeper the plane is than the rulings, in radians.
    let steep = s.arctangent_of(c.abs()) - (FRAC_PI_2 - half_angle);
    let d = (s - cos) * (s + cos);
    let apex = axis.origin;
    if h <= tolerance.absolute {
        let line = |direction: Vector3, tangent: bool| {
            let direction = direction.unitized()?;
            Some(CarrierCurve { conic: Conic::Line(Axis { origin: apex, direction }), tangent })
        };
        return Some(if steep.abs() <= tolerance.angle {
            CarrierMeeting::curves(vec![line(e, true)?])
        } else if steep < 0.0 {
            CarrierMeeting::point(apex)
        } else {
            let (along, across) = (e * cos, f * d.sqrt());
            CarrierMeeting::curves(vec![line(along - across, false)?, line(along + across, false)?])
        });
    }
    let foot = apex + n * h;
    if steep.abs() <= tolerance.angle {
        let way = c.signum();
        let vertex = foot + e * (h * (cos * cos - c * c) / (2.0 * c * s));
        let plane = Plane::from_axes(vertex, f * way, e * way).ok()?;
        let focal = h * c.abs() * s / (2.0 * cos * cos);
        return Some(CarrierMeeting::curves(vec![crossing(Conic::Parabola { plane, focal })]));
    }
    let center = foot - e * (h * c * s / d);
    let (a, b) = (h * cos * sin / d.abs(), h * sin / d.abs().sqrt());
    let frame = Plane::from_axes(center, e, f).ok()?;
    Some(CarrierMeeting::curves(if steep < 0.0 {
        vec![crossing(Conic::Ellipse(Ellipse::new(frame, a, b).ok()?))]
    } else {
        let back = Plane::from_axes(center, -e, -f).ok()?;
        [frame, back].map(|plane| crossing(Conic::Hyperbola { plane, a, b })).to_vec()
    }))
}

/// A plane that does not stand across the axis of a torus: through the axis, touching it twice through its centre, or
/// not cutting it.
pub(super) fn of_torus(
    plane: &Plane,
    axis: &Axis,
    [major, minor]: [f64; 2],
    tolerance: &Tolerance,
) -> Option<CarrierMeeting> {
    let n = plane.z_axis;
    let rise = n.dot(axis.direction);
    let off = -plane.signed_distance(axis.origin);
    let level = n.cross(axis.direction).unitized()?;
    let slope = n.cross(axis.direction).length();
    let circle = |way: Vector3, center: f64, radius: f64| {
        let frame = Plane::from_axes(axis.origin + way * center, way, n.cross(way)).ok()?;
        Some(crossing(Conic::Circle(Circle::new(frame, radius).ok()?)))
    };
    if off.abs() <= tolerance.absolute {
        if rise.abs() <= tolerance.angle {
            return Some(CarrierMeeting::curves(vec![
                circle(level, -major, minor)?,
                circle(level, major, minor)?,
            ]));
        }
        if (slope.arctangent_of(rise.abs()) - (minor / major).arcsine()).abs() <= tolerance.angle {
            return Some(CarrierMeeting::curves(vec![
                circle(level, -minor, major)?,
                circle(level, minor, major)?,
            ]));
        }
    }
    // How far the torus reaches along the normal.
    let reach = major * slope + minor;
    if off.abs() > reach + tolerance.absolute {
        return Some(CarrierMeeting::none());
    }
    if off.abs() >= reach - tolerance.absolute {
        let out = (n - axis.direction * rise).unitized()?;
        let way = (out * major + n * minor) * off.signum();
        return Some(CarrierMeeting::point(axis.origin + way));
    }
    None
}
