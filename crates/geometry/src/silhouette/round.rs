//! Silhouettes of spheres, cylinders and cones in closed form.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use super::Viewpoint;
use crate::surface::{Round, RoundForm};
use crate::{Arc, Circle, Curve, Interval, Line, Plane, Point3, Vector3};

/// Ratios nearer to 1 than this are left to the search: there two silhouettes become one.
const NEAR_ONE: f64 = 1e-9;
/// What counts as zero, in parts of a unit vector.
const ZERO: f64 = 1e-12;

/// The silhouettes of a part of a sphere, cylinder or cone, without its ends; `None` where the search tells more surely.
///
/// On x² + y² + a·z² = c the line of sight towards an eye e is tangent where x·eₓ + y·e_y + a·z·e_z = c, and towards a
/// direction d where x·dₓ + y·d_y + a·z·d_z = 0: on a plane, which cuts spheres in a circle and the others in rulings.
pub(super) fn silhouettes(round: &Round, viewpoint: Viewpoint, limit: f64) -> Option<Vec<Curve>> {
    let eye = match viewpoint {
        Viewpoint::Parallel(d) => round.components(-d),
        Viewpoint::Perspective(eye) => round.frame.coordinates(eye),
    };
    let parallel = matches!(viewpoint, Viewpoint::Parallel(_));
    let across = eye[0].hypot(eye[1]);
    match round.form {
        RoundForm::Sphere(radius) => sphere(round, radius, eye, parallel, limit),
        RoundForm::Cylinder(radius) => {
            let cosine = if parallel { 0.0 } else { radius / across };
            if across <= ZERO {
                return parallel.then(Vec::new);
            }
            if parallel && across < 1e-6 {
                return None;
            }
            rulings(round, eye, cosine)
        }
        RoundForm::Cone(slope) => {
            if across <= ZERO * eye[2].abs() {
                return Some(Vec::new());
            }
            rulings(round, eye, slope * eye[2] / across)
        }
    }
}

/// The rulings on both sides of the direction to the eye whose angle with it has this cosine.
fn rulings(round: &Round, eye: [f64; 3], cosine: f64) -> Option<Vec<Curve>> {
    if cosine.abs() >= 1.0 + NEAR_ONE {
        return Some(Vec::new());
    }
    if !(cosine.abs() <= 1.0 - NEAR_ONE) {
        return None;
    }
    let (middle, half) = (eye[1].atan2(eye[0]), cosine.acos());
    let mut out = Vec::with_capacity(2);
    for angle in [middle - half, middle + half] {
        // The whole ruling is there or nothing of it.
        let turn = (angle - round.angle.start).rem_euclid(TAU);
        if !round.is_full_turn() && turn > round.angle.length() {
            continue;
        }
        let at = |height: f64| {
            let radius = match round.form {
                RoundForm::Cone(slope) => slope * height.abs(),
                RoundForm::Cylinder(radius) | RoundForm::Sphere(radius) => radius,
            };
            let (sin, cos) = angle.sin_cos();
            round.frame.at(radius * cos, radius * sin, height)
        };
        out.push(Line::new(at(round.along.start), at(round.along.end)).into());
    }
    Some(out)
}

fn sphere(round: &Round, radius: f64, eye: [f64; 3], parallel: bool, limit: f64) -> Option<Vec<Curve>> {
    let pole_to_pole = (round.along.length().abs() - PI).abs() <= 1e-9;
    if !(round.is_full_turn() && pole_to_pole) {
        return None;
    }
    let frame = &round.frame;
    let [x, y, z] = eye;
    let far = Vector3::new(x, y, z).length();
    let towards = (frame.x_axis * x + frame.y_axis * y + frame.z_axis * z).unitized()?;
    if !parallel {
        let ratio = radius / far;
        if ratio >= 1.0 + NEAR_ONE {
            return Some(Vec::new());
        }
        if !(ratio <= 1.0 - NEAR_ONE) {
            return None;
        }
        let center = frame.origin + towards * (radius * ratio);
        let circle = circle(frame, center, towards, radius * (1.0 - ratio * ratio).sqrt())?;
        return Some(vec![circle.into()]);
    }
    // Past the poles a circle may run along the seam.
    let past_poles = radius * z.abs() / far;
    if past_poles > 10.0 * limit {
        return Some(vec![circle(frame, frame.origin, towards, radius)?.into()]);
    }
    if past_poles > ZERO * radius {
        return None;
    }
    let across = (frame.x_axis * -y + frame.y_axis * x).unitized()?;
    let meridian = |way: Vector3| -> Option<Curve> {
        let plane = Plane {
            origin: frame.origin,
            x_axis: way,
            y_axis: frame.z_axis,
            z_axis: way.cross(frame.z_axis),
        };
        let half = Interval::new(-FRAC_PI_2, FRAC_PI_2);
        Some(Arc { circle: Circle::new(plane, radius).ok()?, angle: half }.into())
    };
    Some(vec![meridian(across)?, meridian(-across)?])
}

/// A circle that starts on the side of the frame's x axis.
fn circle(frame: &Plane, center: Point3, normal: Vector3, radius: f64) -> Option<Circle> {
    let flat = frame.x_axis - normal * frame.x_axis.dot(normal);
    let x_axis = if flat.length() > 1e-6 { flat } else { normal.cross(frame.y_axis) }.unitized()?;
    let plane = Plane { origin: center, x_axis, y_axis: normal.cross(x_axis), z_axis: normal };
    Circle::new(plane, radius).ok()
}
