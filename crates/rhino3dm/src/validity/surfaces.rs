//! The surface classes.

use super::curves::dimension;
use super::{Verdict, curves, numbers, nurbs};
use crate::{CurveForm, SurfaceForm};

/// Whether a surface is valid.
pub(super) fn verdict(form: &SurfaceForm) -> Verdict {
    match form {
        SurfaceForm::Plane { plane, offset, domains, extents } => {
            numbers::plane(plane, *offset)?;
            domains.iter().try_for_each(|domain| numbers::increasing(*domain, "a domain"))?;
            extents.iter().try_for_each(|extent| numbers::increasing(*extent, "an extent"))
        }
        SurfaceForm::Sum { shift, curves, .. } => {
            curves.iter().try_for_each(|curve| in_space(curve, "a curve of the sum"))?;
            match [shift.x, shift.y, shift.z].into_iter().all(numbers::is_set) {
                true => Ok(()),
                false => Err("its shift is no number".into()),
            }
        }
        SurfaceForm::Revolution { axis, angle, domain, profile, .. } => {
            let profile = profile.as_deref().ok_or("it has no profile")?;
            in_space(profile, "its profile")?;
            numbers::point(axis.from, "its axis")?;
            numbers::point(axis.to, "its axis")?;
            if axis.from == axis.to {
                return Err("its axis has no length".into());
            }
            numbers::increasing(*angle, "its angle")?;
            let length = angle.length();
            if length > std::f64::consts::TAU + numbers::ZERO || length <= numbers::ZERO {
                return Err(format!("its angle is {length}"));
            }
            numbers::increasing(*domain, "its domain")
        }
        SurfaceForm::Nurbs(form) => nurbs::surface(form),
        SurfaceForm::Tagged { surface, .. } => verdict(surface),
    }
}

/// The number of coordinates of a surface's points.
pub(super) fn surface_dimension(form: &SurfaceForm) -> i32 {
    match form {
        SurfaceForm::Nurbs(form) => form.dimension,
        SurfaceForm::Tagged { surface, .. } => surface_dimension(surface),
        _ => 3,
    }
}

fn in_space(curve: &CurveForm, what: &str) -> Verdict {
    curves::verdict(curve).map_err(|why| format!("{what}: {why}"))?;
    match dimension(curve) {
        3 => Ok(()),
        other => Err(format!("{what} is of dimension {other}")),
    }
}
