use std::f64::consts::{FRAC_PI_2, TAU};

use katydid_elementary::Elementary;

use super::RevolutionSurface;
use crate::{Arc, ArcCurve, Circle, Error, Interval, Line, NurbsSurface, Plane, Point3, Result, Vector3};

/// The angle of a direction in a plane, from 0 up to a turn.
pub(super) fn full_angle(x: f64, y: f64) -> f64 {
    let angle = y.arctangent_of(x);
    let angle = if angle < 0.0 { angle + TAU } else { angle };
    // A tiny negative angle rounds up to a whole turn.
    if angle >= TAU { 0.0 } else { angle }
}

pub(super) fn check_radius(what: &'static str, radius: f64) -> Result<()> {
    if radius > 0.0 && radius.is_finite() {
        return Ok(());
    }
    Err(Error::OutOfRange { what, value: radius, must: "finite and greater than 0" })
}

pub(super) fn check_plane(plane: &Plane) -> Result<()> {
    if plane.is_finite() { Ok(()) } else { Err(Error::NotFinite("plane of the primitive")) }
}

/// A sphere. Its parameters are longitude u, 0…2π from the plane's x axis, and latitude v, −π/2…π/2 towards the
/// plane's z axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// The plane of the equator; its origin is the centre.
    pub plane: Plane,
    /// The radius, greater than 0.
    pub radius: f64,
}

impl Sphere {
    /// The sphere around a plane's origin.
    ///
    /// # Errors
    /// The radius is not finite and greater than 0, or the plane not finite.
    pub fn new(plane: Plane, radius: f64) -> Result<Self> {
        check_radius("radius", radius)?;
        check_plane(&plane)?;
        Ok(Self { plane, radius })
    }

    /// The sphere around a point, with its axes along the world's.
    ///
    /// # Errors
    /// As [`Sphere::new`].
    pub fn around(center: Point3, radius: f64) -> Result<Self> {
        Self::new(Plane::XY.with_origin(center), radius)
    }

    /// The centre.
    pub fn center(&self) -> Point3 {
        self.plane.origin
    }

    /// The unit normal, outwards.
    pub fn normal_at(&self, longitude: f64, latitude: f64) -> Vector3 {
        let ((su, cu), (sv, cv)) = (longitude.sine_cosine(), latitude.sine_cosine());
        let p = &self.plane;
        p.x_axis * (cu * cv) + p.y_axis * (su * cv) + p.z_axis * sv
    }

    /// The point at a longitude and latitude.
    pub fn point_at(&self, longitude: f64, latitude: f64) -> Point3 {
        self.center() + self.normal_at(longitude, latitude) * self.radius
    }

    /// Longitude and latitude of the nearest point, which is the only one; at the centre, where all points are
    /// equally near, `None`.
    pub fn closest_parameters(&self, p: Point3) -> Option<(f64, f64)> {
        let [x, y, z] = self.plane.coordinates(p);
        let arm = x.hypotenuse(y);
        if !(arm.max(z.abs()) > 0.0) {
            return None;
        }
        Some((if arm > 0.0 { full_angle(x, y) } else { 0.0 }, z.arctangent_of(arm)))
    }

    /// The nearest point of the sphere; for the centre the point at longitude and latitude 0.
    pub fn closest_point(&self, p: Point3) -> Point3 {
        let direction = (p - self.center()).unitized().unwrap_or(self.plane.x_axis);
        self.center() + direction * self.radius
    }

    /// 4πr².
    pub fn area(&self) -> f64 {
        2.0 * TAU * self.radius * self.radius
    }

    /// 4/3·πr³.
    pub fn volume(&self) -> f64 {
        2.0 / 3.0 * TAU * self.radius.powi(3)
    }

    /// The half circle from the south pole to the north pole turned about the axis through them.
    pub fn to_revolution(&self) -> RevolutionSurface {
        let p = &self.plane;
        let side = Plane { origin: p.origin, x_axis: p.x_axis, y_axis: p.z_axis, z_axis: -p.y_axis };
        let latitude = Interval::new(-FRAC_PI_2, FRAC_PI_2);
        let arc = Arc { circle: Circle { plane: side, radius: self.radius }, angle: latitude };
        let axis = Line::new(p.at(0.0, 0.0, -self.radius), p.at(0.0, 0.0, self.radius));
        RevolutionSurface::full(ArcCurve { arc, domain: latitude }.into(), axis, p.z_axis)
    }

    /// The exact NURBS form over the same domains, 9 by 5 control points; parameters agree only at the joints and
    /// middles of the spans.
    ///
    /// # Errors
    /// A number overflows.
    pub fn to_nurbs(&self) -> Result<NurbsSurface> {
        self.to_revolution().to_nurbs()
    }
}
