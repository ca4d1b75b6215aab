//! Surfaces of any kind with each other, in their own parameters.

use super::sheet::Sheet;
use super::{SurfaceBranch, SurfaceMeeting, exact, images, surface_surface};
use crate::chart::thresholds::{ABOVE_NOISE, IMAGE, IMAGE_OF_TOLERANCE, ROUNDING_OF_SIZE};
use crate::{Result, Surface, Tolerance};

/// The curves in which two surfaces of any kind meet, and the places in which they touch, as [`surface_surface()`] finds them,
/// with the surfaces' own parameters: revolutions and arcs run through their angle, which their NURBS forms do not.
///
/// # Errors
/// As [`surface_surface()`].
pub fn surface_with_surface(a: &Surface, b: &Surface, tolerance: &Tolerance) -> Result<SurfaceMeeting> {
    let limit = tolerance.positive_distance()?;
    let (mut out, is_own) = common(a, b, tolerance)?;
    if is_own || [a, b].iter().all(|s| matches!(s, Surface::Nurbs(_) | Surface::Plane(_))) {
        return Ok(out);
    }
    let mut sheets = [Sheet::new(a)?, Sheet::new(b)?];
    let size = a.bounding_box()?.diagonal().length().min(b.bounding_box()?.diagonal().length());
    for branch in &mut out.branches {
        own_parameters(branch, &mut sheets, limit, size)?;
    }
    for contact in &mut out.contacts {
        for branch in contact.curve.iter_mut().chain(contact.border.iter_mut().flatten()) {
            own_parameters(branch, &mut sheets, limit, size)?;
        }
        for (s, sheet) in sheets.iter_mut().enumerate() {
            contact.at[s] = sheet.nearest(contact.point, None)?.0;
        }
        if let Some(branch) = &contact.curve {
            contact.ranges = exact::ranges([branch]);
        }
    }
    Ok(out)
}

/// What two surfaces have in common, and whether its parameters are those of the surfaces, or of their NURBS forms.
///
/// # Errors
/// As [`surface_surface()`].
pub(crate) fn common(a: &Surface, b: &Surface, tolerance: &Tolerance) -> Result<(SurfaceMeeting, bool)> {
    if let Some(met) = exact::meeting([a, b], tolerance.positive_distance()?)? {
        return Ok((met, true));
    }
    Ok((surface_surface(&a.to_nurbs()?, &b.to_nurbs()?, tolerance)?, false))
}

/// Gives a branch its images in the surfaces' own parameters.
fn own_parameters(
    branch: &mut SurfaceBranch,
    sheets: &mut [Sheet<'_>; 2],
    limit: f64,
    size: f64,
) -> Result<()> {
    let noise = ABOVE_NOISE * ROUNDING_OF_SIZE * size;
    // The curve is off the surfaces itself, and between the places where that was measured by a little more.
    let target = (IMAGE_OF_TOLERANCE * limit).max(IMAGE * size).min(limit) + 2.0 * branch.deviation + noise;
    for s in 0..2 {
        if matches!(sheets[s].surface, Surface::Nurbs(_)) {
            continue;
        }
        let Some((image, off)) = images::image(&branch.curve, &mut sheets[s], target)? else {
            return Err(crate::Error::Unsupported(
                "images of a common curve in the parameters of this surface",
            ));
        };
        branch.parameters[s] = image;
        branch.deviation = branch.deviation.max(off);
    }
    Ok(())
}
