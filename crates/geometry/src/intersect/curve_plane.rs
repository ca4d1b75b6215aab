//! Curve with plane.

use crate::{Curve, Interval, Plane, Result};

/// All that a curve and a plane have in common.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PlaneIntersections {
    /// The parameters on the curve of crossings and touches, in order.
    pub crossings: Vec<f64>,
    /// The ranges of the curve that lie in the plane, in order.
    pub overlaps: Vec<Interval>,
}

/// All points and stretches of a curve within `tolerance` of a plane, by [`Curve::intersect_plane`]'s search.
///
/// # Errors
/// The plane or the tolerance is not finite.
pub fn curve_plane(curve: &Curve, plane: &Plane, tolerance: f64) -> Result<PlaneIntersections> {
    let mut out = PlaneIntersections::default();
    for contact in curve.plane_contacts(plane, tolerance)? {
        if contact.end > contact.start {
            out.overlaps.push(contact);
        } else {
            out.crossings.push(contact.start);
        }
    }
    Ok(out)
}
