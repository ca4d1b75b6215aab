use katydid_elementary::Elementary;

use super::RevolutionSurface;
use super::sphere::{check_plane, check_radius, full_angle};
use crate::{Error, Interval, Line, LineCurve, NurbsSurface, Plane, Point3, Result, Vector3};

/// A right circular cylinder between two heights over a plane. Its parameters are the angle u, 0…2π from the plane's
/// x axis, and the height v.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    /// The plane of height 0; its normal is the axis.
    pub plane: Plane,
    /// The radius, greater than 0.
    pub radius: f64,
    /// The lower and the upper height; increasing.
    pub height: Interval,
}

impl Cylinder {
    /// The cylinder over a circle of a plane; heights in either order.
    ///
    /// # Errors
    /// The radius is not finite and greater than 0, the heights are equal, or a number is not finite.
    pub fn new(plane: Plane, radius: f64, height: Interval) -> Result<Self> {
        check_radius("radius", radius)?;
        check_plane(&plane)?;
        let height = height.ordered();
        if !(height.is_increasing() && height.length().is_finite()) {
            return Err(Error::degenerate("cylinder", "it has no height"));
        }
        Ok(Self { plane, radius, height })
    }

    /// The unit normal, outwards.
    pub fn normal_at(&self, angle: f64) -> Vector3 {
        let (sin, cos) = angle.sine_cosine();
        self.plane.x_axis * cos + self.plane.y_axis * sin
    }

    /// The point at an angle and height.
    pub fn point_at(&self, angle: f64, height: f64) -> Point3 {
        let (sin, cos) = angle.sine_cosine();
        self.plane.at(self.radius * cos, self.radius * sin, height)
    }

    /// The angle and height of the nearest point; angle 0 for a point on the axis, where all are equally near.
    pub fn closest_parameters(&self, p: Point3) -> (f64, f64) {
        let [x, y, z] = self.plane.coordinates(p);
        (full_angle(x, y), self.height.clamp(z))
    }

    /// The nearest point of the surface (the caps are not part of it).
    pub fn closest_point(&self, p: Point3) -> Point3 {
        let (angle, height) = self.closest_parameters(p);
        self.point_at(angle, height)
    }

    /// A ruling turned about the axis.
    pub fn to_revolution(&self) -> RevolutionSurface {
        let Interval { start, end } = self.height;
        let line = Line::new(self.plane.at(self.radius, 0.0, start), self.plane.at(self.radius, 0.0, end));
        let axis = Line::new(self.plane.at(0.0, 0.0, start), self.plane.at(0.0, 0.0, end));
        let profile = LineCurve { line, domain: self.height }.into();
        RevolutionSurface::full(profile, axis, self.plane.z_axis)
    }

    /// The exact NURBS form over the same domains, 9 by 2 control points.
    ///
    /// # Errors
    /// A number overflows.
    pub fn to_nurbs(&self) -> Result<NurbsSurface> {
        self.to_revolution().to_nurbs()
    }
}
