//! Breps: their curves and surfaces each, and how they fit together.

use std::collections::BTreeMap;

use katydid_geometry::Curve;
use katydid_geometry::brep::Symptom;

use super::curves::dimension;
use super::surfaces::surface_dimension;
use super::{Verdict, curves, surfaces};
use crate::{BrepObject, CurveForm, SurfaceForm};

/// Whether a Brep is valid. Every curve and surface must be, used or not; what the kernel alone refuses of them is told
/// by none of the Brep's own faults.
pub(super) fn verdict(object: &BrepObject) -> Verdict {
    let parts = object.brep.parts();
    each(&parts.curves_2d, &object.odd_curves_2d, 2, "parameter curve")?;
    each(&parts.curves_3d, &object.odd_curves_3d, 3, "curve")?;
    for (place, surface) in parts.surfaces.iter().enumerate() {
        let made =
            surface.as_ref().filter(|_| !object.odd_surfaces.contains_key(&place)).map(SurfaceForm::of);
        let Some(form) = object.odd_surfaces.get(&place).or(made.as_ref()) else { continue };
        surfaces::verdict(form).map_err(|why| format!("surface {place}: {why}"))?;
        if surface_dimension(form) != 3 {
            return Err(format!("surface {place} is of dimension {}", surface_dimension(form)));
        }
    }
    let refused = !refused_places(&parts.curves_2d, &object.odd_curves_2d).is_empty()
        || !refused_places(&parts.curves_3d, &object.odd_curves_3d).is_empty()
        || object.odd_surfaces.keys().any(|place| parts.surfaces.get(*place).is_none_or(Option::is_none));
    let mut faults = object.brep.faults();
    if refused {
        faults.retain(|fault| fault.symptom != Symptom::Missing);
    }
    match faults.as_slice() {
        [] => Ok(()),
        [fault] => Err(fault.to_string()),
        [fault, others @ ..] => Err(format!("{fault}; and {} more", others.len())),
    }
}

fn each(list: &[Option<Curve>], odd: &BTreeMap<usize, CurveForm>, expected: i32, what: &str) -> Verdict {
    for (place, curve) in list.iter().enumerate() {
        let made = curve.as_ref().filter(|_| !odd.contains_key(&place)).map(|c| CurveForm::of(c, expected));
        let Some(form) = odd.get(&place).or(made.as_ref()) else { continue };
        curves::verdict(form).map_err(|why| format!("{what} {place}: {why}"))?;
        if dimension(form) != expected {
            return Err(format!("{what} {place} is of dimension {}", dimension(form)));
        }
    }
    Ok(())
}

/// Places whose curve the archive has and the kernel does not.
fn refused_places(list: &[Option<Curve>], odd: &BTreeMap<usize, CurveForm>) -> Vec<usize> {
    odd.keys().copied().filter(|place| list.get(*place).is_none_or(Option::is_none)).collect()
}
