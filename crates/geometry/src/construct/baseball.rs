//! The sphere as the cover of a baseball.

use crate::construct::thresholds::BALL_TOLERANCE;
use std::f64::consts::PI;

use crate::{
    Arc, Brep, Curve, Interval, Line, Plane, Point3, PolyCurve, Result, RevolutionSurface, Sphere, Tolerance,
    Vector3,
};

/// How far the surfaces reach round and up, beyond their border on all sides.
const ROUND: f64 = 150.0 / 180.0 * PI;
const UP: f64 = PI / 3.0;

/// The sphere as two alike faces on rational surfaces without poles, each the part of a band about the sphere that
/// covers three sides of a cube in a row; the border runs along great circles over the edges of the cube.
///
/// # Errors
/// The radius is out of range.
pub fn baseball_sphere(shape: &Sphere) -> Result<Brep> {
    let tolerance = Tolerance { absolute: BALL_TOLERANCE * shape.radius, ..Tolerance::default() };
    let p = shape.plane;
    let other = Plane { origin: p.origin, x_axis: -p.x_axis, y_axis: p.z_axis, z_axis: p.y_axis };
    let mut faces = Vec::new();
    for frame in [p, other] {
        faces.extend(half(&frame, shape.radius, &tolerance)?);
    }
    Brep::joined_into_one(&faces, &tolerance)
}

/// The half about the x axis of a plane, from the side at −y over that at +x to that at +y.
fn half(frame: &Plane, radius: f64, tolerance: &Tolerance) -> Result<Vec<Brep>> {
    let meridian =
        Plane { origin: frame.origin, x_axis: frame.x_axis, y_axis: frame.z_axis, z_axis: -frame.y_axis };
    let circle = crate::Circle::new(meridian, radius)?;
    let profile = Curve::from(Arc::new(circle, Interval::new(-UP, UP))?);
    let axis = Line::new(frame.origin, frame.origin + frame.z_axis);
    let band = RevolutionSurface::new(profile, axis, Interval::new(-ROUND, ROUND))?.to_nurbs()?;
    // The corners of the cube along the border.
    let corner = |x: f64, y: f64, z: f64| {
        let way = frame.x_axis * x + frame.y_axis * y + frame.z_axis * z;
        frame.origin + way * (radius / 3.0_f64.sqrt())
    };
    let ring = [
        corner(-1.0, -1.0, -1.0),
        corner(1.0, -1.0, -1.0),
        corner(1.0, 1.0, -1.0),
        corner(-1.0, 1.0, -1.0),
        corner(-1.0, 1.0, 1.0),
        corner(1.0, 1.0, 1.0),
        corner(1.0, -1.0, 1.0),
        corner(-1.0, -1.0, 1.0),
    ];
    let arc = |a: Point3, b: Point3| -> Result<Curve> {
        let middle = (a - frame.origin) + (b - frame.origin);
        let middle: Vector3 = middle * (radius / middle.length());
        Ok(Arc::through(a, frame.origin + middle, b)?.into())
    };
    let next = ring.iter().cycle().skip(1);
    let border = ring.iter().zip(next).map(|(a, b)| arc(*a, *b)).collect::<Result<Vec<_>>>()?;
    let border: Curve = PolyCurve::new(border)?.into();
    let made = Brep::trimmed_surface(&band.into(), &[border], tolerance)?;
    Ok(made)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn covers_the_sphere_with_two_alike_faces() {
        let plane =
            Plane::from_axes(Point3::new(1.0, 2.0, 3.0), Vector3::new(1.0, 1.0, 0.0), Vector3::Z).unwrap();
        let ball = baseball_sphere(&Sphere::new(plane, 2.5).unwrap()).unwrap();
        assert_eq!(ball.faces().len(), 2);
        assert!(ball.is_solid() && ball.faults().is_empty());
        let volume = ball.volume_properties(1e-9, || true).unwrap();
        assert!((volume.amount - 4.0 / 3.0 * PI * 2.5_f64.powi(3)).abs() < 1e-2, "{}", volume.amount);
        assert!(volume.centroid.distance_to(plane.origin) < 1e-4);
        for face in 0..2 {
            let area = ball.face_area(face, 1e-9).unwrap().amount;
            assert!((area - 2.0 * PI * 6.25).abs() < 1e-2, "{area}");
        }
    }
}
