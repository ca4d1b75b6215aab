use std::f64::consts::TAU;

use katydid_elementary::Elementary;

use super::RevolutionSurface;
use super::sphere::{check_plane, check_radius, full_angle};
use crate::{Arc, ArcCurve, Circle, Error, Interval, Line, NurbsSurface, Plane, Point3, Result, Vector3};

/// A torus. Its parameters are the angle u about the axis, 0…2π from the plane's x axis, and the angle v about the
/// tube's circle, 0…2π from the outermost point towards the plane's normal.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Torus {
    /// The plane of the tube's middle circle; its origin is the centre.
    pub plane: Plane,
    /// The radius of the middle circle, greater than that of the tube.
    pub major_radius: f64,
    /// The radius of the tube, greater than 0.
    pub minor_radius: f64,
}

impl Torus {
    /// The torus around a plane's origin.
    ///
    /// # Errors
    /// The minor radius is not greater than 0, the major not greater than the minor, or a number not finite.
    pub fn new(plane: Plane, major_radius: f64, minor_radius: f64) -> Result<Self> {
        check_radius("major radius", major_radius)?;
        check_radius("minor radius", minor_radius)?;
        check_plane(&plane)?;
        if !(major_radius > minor_radius) {
            return Err(Error::OutOfRange {
                what: "major radius",
                value: major_radius,
                must: "greater than the minor radius",
            });
        }
        Ok(Self { plane, major_radius, minor_radius })
    }

    /// The unit normal, out of the tube.
    pub fn normal_at(&self, major_angle: f64, minor_angle: f64) -> Vector3 {
        let ((su, cu), (sv, cv)) = (major_angle.sine_cosine(), minor_angle.sine_cosine());
        let p = &self.plane;
        p.x_axis * (cu * cv) + p.y_axis * (su * cv) + p.z_axis * sv
    }

    /// The point at two angles.
    pub fn point_at(&self, major_angle: f64, minor_angle: f64) -> Point3 {
        let (sin, cos) = major_angle.sine_cosine();
        self.plane.at(self.major_radius * cos, self.major_radius * sin, 0.0)
            + self.normal_at(major_angle, minor_angle) * self.minor_radius
    }

    /// The angles of the nearest point; 0 where a whole circle is equally near.
    pub fn closest_parameters(&self, p: Point3) -> (f64, f64) {
        let [x, y, z] = self.plane.coordinates(p);
        (full_angle(x, y), full_angle(x.hypotenuse(y) - self.major_radius, z))
    }

    /// The nearest point of the torus.
    pub fn closest_point(&self, p: Point3) -> Point3 {
        let (u, v) = self.closest_parameters(p);
        self.point_at(u, v)
    }

    /// 4π²Rr.
    pub fn area(&self) -> f64 {
        TAU * TAU * self.major_radius * self.minor_radius
    }

    /// 2π²Rr².
    pub fn volume(&self) -> f64 {
        0.5 * TAU * TAU * self.major_radius * self.minor_radius * self.minor_radius
    }

    /// The tube's circle turned about the axis.
    pub fn to_revolution(&self) -> RevolutionSurface {
        let p = &self.plane;
        let origin = p.at(self.major_radius, 0.0, 0.0);
        let side = Plane { origin, x_axis: p.x_axis, y_axis: p.z_axis, z_axis: -p.y_axis };
        let turn = Interval::new(0.0, TAU);
        let arc = Arc { circle: Circle { plane: side, radius: self.minor_radius }, angle: turn };
        let axis = Line::new(p.origin, p.at(0.0, 0.0, 1.0));
        RevolutionSurface::full(ArcCurve { arc, domain: turn }.into(), axis, p.z_axis)
    }

    /// The exact NURBS form over the same domains, 9 by 9 control points.
    ///
    /// # Errors
    /// A number overflows.
    pub fn to_nurbs(&self) -> Result<NurbsSurface> {
        self.to_revolution().to_nurbs()
    }
}
