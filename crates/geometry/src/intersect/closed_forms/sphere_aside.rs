//! A sphere beside the axis of a cylinder, cone or torus: apart, or touching.

use katydid_elementary::Elementary;

use super::{Carrier, CarrierCurve, CarrierMeeting, Conic};
use crate::{Circle, Plane, Point3, Tolerance};

/// The meeting of a sphere with a surface of revolution whose axis does not run through its centre.
pub(super) fn meeting(
    center: Point3,
    radius: f64,
    other: &Carrier,
    tolerance: &Tolerance,
) -> Option<CarrierMeeting> {
    let near = tolerance.absolute;
    let (axis, height, way) = match other {
        Carrier::Cylinder { axis, .. } | Carrier::Cone { axis, .. } | Carrier::Torus { axis, .. } => {
            let (height, way) = axis.split(center);
            (axis, height, way)
        }
        Carrier::Plane(_) | Carrier::Sphere { .. } => return None,
    };
    let (r, out) = (way.length(), way.unitized()?);
    let at = |[x, z]: [f64; 2]| axis.at(z) + out * x;
    let mut feet = Vec::new();
    match *other {
        Carrier::Cylinder { radius: own, .. } => feet.push([own, height]),
        Carrier::Cone { half_angle, .. } => {
            let (sin, cos) = half_angle.sine_cosine();
            for cos in [cos, -cos] {
                let along = (r * sin + height * cos).max(0.0);
                feet.push([along * sin, along * cos]);
            }
        }
        Carrier::Torus { major_radius, minor_radius, .. } => {
            let [x, z] = [r - major_radius, height];
            let d = x.hypotenuse(z);
            if d <= near {
                // The sphere's centre is on the middle circle of the tube.
                if radius > minor_radius + near {
                    return None;
                }
                if radius < minor_radius - near {
                    return Some(CarrierMeeting::none());
                }
                let frame = Plane::from_axes(at([major_radius, 0.0]), out, axis.direction).ok()?;
                let circle = Circle::new(frame, minor_radius).ok()?;
                let curve = CarrierCurve { conic: Conic::Circle(circle), tangent: true };
                return Some(CarrierMeeting::curves(vec![curve]));
            }
            feet.push([major_radius + x / d * minor_radius, z / d * minor_radius]);
            // The farthest point is on the other side of the axis.
            let far = (r + major_radius).hypotenuse(height);
            if far + minor_radius < radius - near {
                return Some(CarrierMeeting::none());
            }
            if far + minor_radius <= radius + near {
                let [x, z] = [-(r + major_radius), -height].map(|w| w / far * minor_radius);
                return Some(CarrierMeeting::point(at([-major_radius + x, z])));
            }
        }
        Carrier::Plane(_) | Carrier::Sphere { .. } => return None,
    }
    let distance = |[x, z]: [f64; 2]| (x - r).hypotenuse(z - height);
    let least = feet.iter().map(|f| distance(*f)).fold(f64::INFINITY, f64::min);
    if least > radius + near {
        return Some(CarrierMeeting::none());
    }
    if least < radius - near {
        return None;
    }
    let mut points: Vec<Point3> = Vec::new();
    for foot in feet {
        let p = at(foot);
        if distance(foot) <= radius + near && !points.iter().any(|q| q.distance_to(p) <= 2.0 * near) {
            points.push(p);
        }
    }
    Some(CarrierMeeting::Parts { curves: Vec::new(), points })
}
