use crate::{Interval, Plane, Point3};

/// A full circle in a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Circle {
    /// The plane; its origin is the centre and angle 0 lies on its x axis.
    pub plane: Plane,
    /// The radius, greater than 0.
    pub radius: f64,
}

impl Circle {
    /// The point at an angle in radians, counter-clockwise from the plane's x axis.
    pub fn at(&self, angle: f64) -> Point3 {
        let (sin, cos) = angle.sin_cos();
        self.plane.at(self.radius * cos, self.radius * sin, 0.0)
    }
}

/// A part of a circle between two angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arc {
    /// The circle the arc lies on.
    pub circle: Circle,
    /// Start and end angle in radians; increasing, at most 2π long.
    pub angle: Interval,
}
