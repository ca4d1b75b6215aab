//! Curve with a surface of any kind.

use super::{SurfaceIntersections, curve_surface};
use crate::{ClosestOnSurface, Curve, Point3, Result, Surface};

/// All points and stretches that a curve and a surface of any kind have in common within `tolerance`: those of
/// [`curve_surface`] with the surface's NURBS form, which is exact, and with the surface's own parameters.
///
/// # Errors
/// The tolerance is negative or not finite.
pub fn curve_with_surface(curve: &Curve, surface: &Surface, tolerance: f64) -> Result<SurfaceIntersections> {
    let mut found = curve_surface(curve, &surface.to_nurbs()?, tolerance)?;
    if matches!(surface, Surface::Nurbs(_)) || (found.crossings.is_empty() && found.overlaps.is_empty()) {
        return Ok(found);
    }
    // Revolutions and arcs run through their angle, which their NURBS forms do not.
    let index = ClosestOnSurface::new(surface)?;
    let own = |p: Point3| index.nearest(p).map(|near| [near.u, near.v]);
    for crossing in &mut found.crossings {
        [crossing.u, crossing.v] = own(crossing.point)?;
    }
    for overlap in &mut found.overlaps {
        overlap.from = own(curve.point_at(overlap.t.start))?;
        overlap.to = own(curve.point_at(overlap.t.end))?;
    }
    Ok(found)
}
