use katydid_elementary::Elementary;

use super::RevolutionSurface;
use super::sphere::{check_plane, check_radius, full_angle};
use crate::{Error, Interval, Line, LineCurve, NurbsSurface, Plane, Point3, Result, Vector3};

/// A right circular cone from its apex to its base circle. Its parameters are the angle u, 0…2π from the plane's x
/// axis, and the distance v from the apex along the plane's normal, between 0 and the height.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cone {
    /// The plane through the apex, its origin; its normal is the axis.
    pub plane: Plane,
    /// Where the base is along the normal; not 0, negative behind the plane.
    pub height: f64,
    /// The radius of the base, greater than 0.
    pub radius: f64,
}

impl Cone {
    /// The cone with its apex at a plane's origin.
    ///
    /// # Errors
    /// The radius is not finite and greater than 0, the height is 0, or a number is not finite.
    pub fn new(plane: Plane, height: f64, radius: f64) -> Result<Self> {
        check_radius("radius", radius)?;
        check_plane(&plane)?;
        if !(height != 0.0 && height.is_finite()) {
            return Err(Error::degenerate("cone", "it has no height"));
        }
        Ok(Self { plane, height, radius })
    }

    /// The apex.
    pub fn apex(&self) -> Point3 {
        self.plane.origin
    }

    /// The angle between axis and rulings, in radians.
    pub fn half_angle(&self) -> f64 {
        self.radius.arctangent_of(self.height.abs())
    }

    /// The unit normal, outwards; at the apex that of the ruling at the angle.
    pub fn normal_at(&self, angle: f64) -> Vector3 {
        let (sin, cos) = angle.sine_cosine();
        let (slant, p) = (self.radius.hypotenuse(self.height), &self.plane);
        let across = self.height.abs() / slant;
        let along = -self.radius * self.height.signum() / slant;
        p.x_axis * (cos * across) + p.y_axis * (sin * across) + p.z_axis * along
    }

    /// The point at an angle and a distance from the apex along the axis.
    pub fn point_at(&self, angle: f64, height: f64) -> Point3 {
        let r = height / self.height * self.radius;
        let (sin, cos) = angle.sine_cosine();
        self.plane.at(r * cos, r * sin, height)
    }

    /// The parameters of the nearest point; angle 0 for a point on the axis, where a whole circle is equally near.
    pub fn closest_parameters(&self, p: Point3) -> (f64, f64) {
        let [x, y, z] = self.plane.coordinates(p);
        // On the ruling's line (r, h)·s the foot of (arm, z).
        let (arm, r, h) = (x.hypotenuse(y), self.radius, self.height);
        let slant = r.hypotenuse(h);
        let s = ((arm * (r / slant) + z * (h / slant)) / slant).clamp(0.0, 1.0);
        (full_angle(x, y), s * h)
    }

    /// The nearest point of the surface (the base disc is not part of it).
    pub fn closest_point(&self, p: Point3) -> Point3 {
        let (angle, height) = self.closest_parameters(p);
        self.point_at(angle, height)
    }

    /// A ruling turned about the axis, in the order of increasing v: from the apex when the height is positive.
    pub fn to_revolution(&self) -> RevolutionSurface {
        let v = Interval::new(0.0, self.height).ordered();
        let on_ruling = |h: f64| {
            if h == 0.0 { self.apex() } else { self.plane.at(self.radius, 0.0, self.height) }
        };
        let line = Line::new(on_ruling(v.start), on_ruling(v.end));
        let axis = Line::new(self.plane.at(0.0, 0.0, v.start), self.plane.at(0.0, 0.0, v.end));
        RevolutionSurface::full(LineCurve { line, domain: v }.into(), axis, self.plane.z_axis)
    }

    /// The exact NURBS form over the same domains, 9 by 2 control points.
    ///
    /// # Errors
    /// A number overflows.
    pub fn to_nurbs(&self) -> Result<NurbsSurface> {
        self.to_revolution().to_nurbs()
    }
}
