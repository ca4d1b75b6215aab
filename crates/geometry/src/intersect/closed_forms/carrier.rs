//! The surface without ends on which a surface lies.

use super::Axis;
use crate::{Point3, Surface};

/// A plane, sphere, cylinder, cone or torus without ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Carrier {
    /// A plane.
    Plane(crate::Plane),
    /// A sphere.
    Sphere {
        /// Its centre.
        center: Point3,
        /// Its radius.
        radius: f64,
    },
    /// A cylinder.
    Cylinder {
        /// Its axis.
        axis: Axis,
        /// Its radius.
        radius: f64,
    },
    /// A double cone.
    Cone {
        /// Its axis, from its apex.
        axis: Axis,
        /// The angle between the axis and the rulings, in radians, between 0 and a right angle.
        half_angle: f64,
    },
    /// A torus without self-intersections.
    Torus {
        /// Its axis, from its centre.
        axis: Axis,
        /// The radius of the middle circle of its tube.
        major_radius: f64,
        /// The radius of its tube, less than the other.
        minor_radius: f64,
    },
}

impl Carrier {
    /// The carrier on which a surface of any kind lies within `tolerance`: also one inside a NURBS surface, a sum or a
    /// revolution. `None` when there is none of these kinds.
    pub fn of(surface: &Surface, tolerance: f64) -> Option<Self> {
        let axis = |p: &crate::Plane| Axis { origin: p.origin, direction: p.z_axis };
        if let Some(plane) = surface.plane(tolerance) {
            return Some(Self::Plane(plane));
        }
        if let Some(s) = surface.as_sphere(tolerance) {
            return Some(Self::Sphere { center: s.plane.origin, radius: s.radius });
        }
        if let Some(c) = surface.as_cylinder(tolerance) {
            return Some(Self::Cylinder { axis: axis(&c.plane), radius: c.radius });
        }
        if let Some(c) = surface.as_cone(tolerance) {
            return Some(Self::Cone { axis: axis(&c.plane), half_angle: c.half_angle() });
        }
        let t = surface.as_torus(tolerance)?;
        Some(Self::Torus { axis: axis(&t.plane), major_radius: t.major_radius, minor_radius: t.minor_radius })
    }

    /// The distance between a point and the surface.
    pub fn distance_to(&self, p: Point3) -> f64 {
        match self {
            Self::Plane(plane) => plane.signed_distance(p).abs(),
            Self::Sphere { center, radius } => (p.distance_to(*center) - radius).abs(),
            Self::Cylinder { axis, radius } => (axis.split(p).1.length() - radius).abs(),
            Self::Cone { axis, half_angle } => {
                let (height, way) = axis.split(p);
                let (sin, cos) = half_angle.sin_cos();
                // On the side of the nearer nappe; beyond the ruling's start the apex is nearest.
                let (r, z) = (way.length(), height.abs());
                if r * sin + z * cos <= 0.0 { r.hypot(z) } else { (r * cos - z * sin).abs() }
            }
            Self::Torus { axis, major_radius, minor_radius } => {
                let (height, way) = axis.split(p);
                ((way.length() - major_radius).hypot(height) - minor_radius).abs()
            }
        }
    }
}
