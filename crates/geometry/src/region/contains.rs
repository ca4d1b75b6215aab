//! Points in closed curves.

use super::Outline;
use crate::{Containment, Curve, Error, Plane, Point3, Result, Xform};

impl Curve {
    /// Where a point lies relative to a closed curve, both projected into a plane; points within `tolerance` of the
    /// projected curve are on it. Inside means a winding number other than 0.
    ///
    /// The crossings with a ray are counted; each piece is halved until its control points prove whether it crosses,
    /// so that nothing is decided by rounding unless the point is nearer than the tolerance.
    ///
    /// # Errors
    /// The curve is open or the point not finite.
    pub fn contains_in_plane(&self, p: Point3, plane: &Plane, tolerance: f64) -> Result<Containment> {
        if !self.is_closed() {
            return Err(Error::degenerate("curve", "it is open and has no inside"));
        }
        if !p.is_finite() {
            return Err(Error::NotFinite("point to test"));
        }
        let flat = self.transformed(&Xform::planar_projection(plane))?;
        let q = plane.closest_point(p);
        if flat.closest_point(q)?.distance <= tolerance.max(0.0) {
            return Ok(Containment::On);
        }
        let turns = Outline::new(&flat, &plane.with_origin(q)).winding([0.0; 2]);
        Ok(if turns == 0 { Containment::Outside } else { Containment::Inside })
    }
}
