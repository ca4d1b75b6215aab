//! Silhouettes of spheres, cylinders and cones in closed form.

use crate::silhouette::thresholds::LEVEL_SINE;
use crate::thresholds;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

use katydid_elementary::Elementary;

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
    let across = eye[0].hypotenuse(eye[1]);
    match round.form {
        RoundForm::Sphere(radius) => sphere(round, radius, eye, parallel, limit),
        RoundForm::Cylinder(radius) => {
            let cosine = if parallel { 0.0 } else { radius / across };
            if across <= ZERO {
                return parallel.then(Vec::new);
            }
            if parallel && across < LEVEL_SINE {
                return None;
            }
            rulings(round, eye, cosine)
        }
        RoundForm::Cone(slope) => {
            if across <= ZERO * eye[2].abs() {
                return Some(Vec::new());
            }
            // Below its apex z and the radius have different signs.
            rulings(round, eye, slope.copysign(round.along.middle()) * eye[2] / across)
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
    let (middle, half) = (eye[1].arctangent_of(eye[0]), cosine.arccosine());
    let mut out = Vec::with_capacity(2);
    let mut turns = [middle - half, middle + half].map(|angle| (angle - round.angle.start).rem_euclid(TAU));
    turns.sort_by(f64::total_cmp);
    for turn in turns {
        // The whole ruling is there or nothing of it.
        if !round.is_full_turn() && turn > round.angle.length() {
            continue;
        }
        let angle = round.angle.start + turn;
        let at = |height: f64| {
            let radius = match round.form {
                RoundForm::Cone(slope) => slope * height.abs(),
                RoundForm::Cylinder(radius) | RoundForm::Sphere(radius) => radius,
            };
            let (sin, cos) = angle.sine_cosine();
            round.frame.at(radius * cos, radius * sin, height)
        };
        out.push(Line::new(at(round.along.start), at(round.along.end)).into());
    }
    Some(out)
}

fn sphere(round: &Round, radius: f64, eye: [f64; 3], parallel: bool, limit: f64) -> Option<Vec<Curve>> {
    let pole_to_pole = (round.along.length().abs() - PI).abs() <= thresholds::PARALLEL;
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
    let x_axis = if flat.length() > LEVEL_SINE { flat } else { normal.cross(frame.y_axis) }.unitized()?;
    let plane = Plane { origin: center, x_axis, y_axis: normal.cross(x_axis), z_axis: normal };
    Circle::new(plane, radius).ok()
}

#[cfg(test)]
mod tests {
    use super::silhouettes;
    use crate::silhouette::Viewpoint;
    use crate::surface::Round;
    use crate::{Cone, Cylinder, Direction, Interval, Plane, Point3, Quadrant, Sphere, Surface, Vector3};

    fn surfaces() -> Vec<Surface> {
        let origin = Point3::new(1.0, 2.0, 3.0);
        let frame =
            Plane::from_axes(origin, Vector3::new(1.0, 1.0, 0.0), Vector3::new(0.2, 0.3, 1.0)).unwrap();
        let mut out: Vec<Surface> = vec![
            Sphere::new(frame, 2.0).unwrap().into(),
            Cylinder::new(frame, 2.0, Interval::new(-1.0, 4.0)).unwrap().into(),
        ];
        for height in [-3.0, 3.0] {
            let cone = Cone::new(frame, height, 2.0).unwrap().to_revolution();
            // The apex at either end of the profile, and the axis either way.
            out.push(cone.clone().into());
            out.push(cone.reversed(Direction::U).into());
            out.push(cone.reversed(Direction::V).into());
        }
        out
    }

    #[test]
    fn lines_of_sight_are_tangent_along_them() {
        let eyes = [
            Viewpoint::Parallel(Vector3::new(0.3, -0.5, 0.81)),
            Viewpoint::Parallel(Vector3::new(1.0, -0.2, -0.1)),
            Viewpoint::Perspective(Point3::new(9.0, -8.0, 7.0)),
            Viewpoint::Perspective(Point3::new(-20.0, 3.0, -4.0)),
        ];
        let mut tangent = 0;
        for surface in surfaces() {
            let round = Round::of(&surface).unwrap();
            for viewpoint in eyes {
                for curve in silhouettes(&round, viewpoint, 1e-3).unwrap() {
                    for k in 1..12 {
                        let p = curve.point_at(curve.domain().at(f64::from(k) / 12.0));
                        let [u, v] = round.parameters(p).unwrap();
                        assert!(surface.point_at(u, v).distance_to(p) < 1e-9);
                        let jet = surface.derivatives(u, v, 1, Quadrant::NorthEast);
                        let normal = jet.get(1, 0).cross(jet.get(0, 1)).unitized().unwrap();
                        let towards = viewpoint.towards(p).unitized().unwrap();
                        assert!(normal.dot(towards).abs() < 1e-9, "{surface:?} {viewpoint:?} {p:?}");
                        tangent += 1;
                    }
                }
            }
        }
        assert!(tangent > 400, "{tangent}");
    }
}
