//! Curve with a surface of any kind.

use super::SurfaceIntersections;
use super::curve_surface::{MOST_VISITS, curve_surface_within};
use crate::{ClosestOnSurface, Curve, Point3, Result, Surface};

/// All points and stretches that a curve and a surface of any kind have in common within `tolerance`: those of
/// [`curve_surface`](super::curve_surface()) with the surface's NURBS form, which is exact, and with the surface's own parameters.
///
/// # Errors
/// The tolerance is negative or not finite.
pub fn curve_with_surface(curve: &Curve, surface: &Surface, tolerance: f64) -> Result<SurfaceIntersections> {
    curve_with_surface_within(curve, surface, tolerance, MOST_VISITS)
}

/// As [`curve_with_surface`], looking at no more than so many pairs of parts.
pub(crate) fn curve_with_surface_within(
    curve: &Curve,
    surface: &Surface,
    tolerance: f64,
    most_visits: u64,
) -> Result<SurfaceIntersections> {
    let mut found = curve_surface_within(curve, &surface.to_nurbs()?, tolerance, most_visits)?;
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
