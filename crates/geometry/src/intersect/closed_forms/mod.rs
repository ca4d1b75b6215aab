//! Planes, spheres, cylinders, cones and tori without ends: what two of them have in common where that is made of lines,
//! conics and points, exactly.

mod coaxial;
mod cones;
mod cylinders;
mod plane_sections;
mod shape;
mod sphere_aside;

pub use crate::chart::{Axis, Carrier};
pub use shape::{CarrierCurve, Conic};

use crate::{Point3, Tolerance, Vector3};

/// What two surfaces without ends have in common.
#[derive(Debug, Clone, PartialEq)]
pub enum CarrierMeeting {
    /// They are the same surface.
    Same,
    /// All of these curves and isolated points, and nothing else; both empty when they do not meet.
    Parts {
        /// The curves.
        curves: Vec<CarrierCurve>,
        /// Points in which they touch, or in which one meets the apex of the other.
        points: Vec<Point3>,
    },
}

impl CarrierMeeting {
    fn none() -> Self {
        Self::Parts { curves: Vec::new(), points: Vec::new() }
    }

    fn point(p: Point3) -> Self {
        Self::Parts { curves: Vec::new(), points: vec![p] }
    }

    fn curves(curves: Vec<CarrierCurve>) -> Self {
        Self::Parts { curves, points: Vec::new() }
    }
}

/// What two planes, spheres, cylinders, cones or tori without ends have in common, where it is made of lines, circles,
/// ellipses, parabolas, hyperbolas and points. `None` for all other pairs. Cones go on beyond their apex.
///
/// Lengths that differ by no more than the tolerance's distance are equal, directions that differ by no more than its
/// angle are parallel: what touches within that is said to touch.
///
/// # Method
/// About a common axis the profiles meet in points, which turn into circles. A plane meets a quadric in conics. Two
/// quadrics around one sphere lie in a pencil that holds two planes (D. Hilbert and S. Cohn-Vossen, *Geometry and the
/// Imagination*, §3; J. Miller and R. Goldman, *Geometric algorithms for detecting and calculating all conic sections in
/// the intersection of any two natural quadric surfaces*, GMIP 57, 1995). A torus meets planes through its axis, and planes
/// that touch it twice, in circles (Y. Villarceau, 1848).
pub fn carrier_carrier(a: &Carrier, b: &Carrier, tolerance: &Tolerance) -> Option<CarrierMeeting> {
    use Carrier::{Cone, Cylinder, Plane, Sphere, Torus};
    if let Some(met) = coaxial::meeting(a, b, tolerance) {
        return met;
    }
    match (a, b) {
        (Plane(p), Plane(q)) => plane_sections::with_plane(p, q, tolerance),
        (Plane(p), Cylinder { axis, radius }) | (Cylinder { axis, radius }, Plane(p)) => {
            plane_sections::of_cylinder(p, axis, *radius, tolerance)
        }
        (Plane(p), Cone { axis, half_angle }) | (Cone { axis, half_angle }, Plane(p)) => {
            plane_sections::of_cone(p, axis, *half_angle, tolerance)
        }
        (Plane(p), Torus { axis, major_radius, minor_radius })
        | (Torus { axis, major_radius, minor_radius }, Plane(p)) => {
            plane_sections::of_torus(p, axis, [*major_radius, *minor_radius], tolerance)
        }
        (Sphere { center, radius }, other) | (other, Sphere { center, radius }) => {
            sphere_aside::meeting(*center, *radius, other, tolerance)
        }
        (Cylinder { .. } | Cone { .. }, Cylinder { .. } | Cone { .. }) => {
            cylinders::meeting(a, b, tolerance).or_else(|| cones::meeting(a, b, tolerance))
        }
        _ => None,
    }
}

/// Whether two unit directions are parallel, either way round.
fn parallel(a: Vector3, b: Vector3, tolerance: &Tolerance) -> bool {
    a.cross(b).length() <= tolerance.angle
}

#[cfg(test)]
mod tests;
