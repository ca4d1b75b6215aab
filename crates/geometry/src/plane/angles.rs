//! Vectors in planes.

use std::f64::consts::TAU;

use katydid_elementary::Elementary;

use crate::{Plane, Vector3};

impl Vector3 {
    /// The angle in radians from this vector to `other`, both projected into `plane`, counter-clockwise about its
    /// normal: at least 0, less than 2π. `None` when a projection has no direction.
    pub fn angle_in_plane(self, other: Self, plane: &Plane) -> Option<f64> {
        let flat = |v: Self| {
            let (x, y) = (v.dot(plane.x_axis), v.dot(plane.y_axis));
            Self::new(x, y, 0.0).unitized()
        };
        let (a, b) = (flat(self)?, flat(other)?);
        let angle = (a.x * b.y - a.y * b.x).arctangent_of(a.dot(b));
        let positive = if angle < 0.0 { angle + TAU } else { angle };
        // −1e-17 + 2π rounds to 2π itself, which is the angle 0.
        Some(if positive >= TAU { 0.0 } else { positive })
    }

    /// The part of this vector in a plane.
    #[must_use]
    pub fn projected_into(self, plane: &Plane) -> Self {
        self - plane.z_axis * self.dot(plane.z_axis)
    }
}
