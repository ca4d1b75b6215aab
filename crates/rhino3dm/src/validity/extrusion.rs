//! Extrusions.

use super::{Verdict, curves, numbers};
use crate::{CurveForm, Extrusion};

/// How steep against the path a slanted end may be: the least part of its normal along the path.
const LEAST_SLANT: f64 = 1.0 / 64.0;

/// Whether an extrusion is valid.
pub(super) fn verdict(extrusion: &Extrusion) -> Verdict {
    profiles(extrusion)?;
    let path = extrusion.path;
    numbers::point(path.from, "its path")?;
    numbers::point(path.to, "its path")?;
    let length = path.length();
    if !(numbers::is_set(length) && length > numbers::ZERO) {
        return Err("its path has no length".into());
    }
    let along = (path.to - path.from) / length;
    let part = extrusion.part;
    if !(0.0 <= part.start && part.start < part.end && part.end <= 1.0) {
        return Err("it takes no part of its path".into());
    }
    if !numbers::is_unit(extrusion.up) {
        return Err("its direction up is not of length 1".into());
    }
    if extrusion.up.dot(along).abs() > numbers::ROOT {
        return Err("its direction up is not square to its path".into());
    }
    for (mitred, normal) in extrusion.is_mitred.into_iter().zip(extrusion.mitre_normals) {
        if mitred && !(numbers::is_unit(normal) && normal.z > LEAST_SLANT) {
            return Err("the normal of a slanted end is not of length 1, or too flat".into());
        }
    }
    Ok(())
}

fn profiles(extrusion: &Extrusion) -> Verdict {
    if extrusion.profile_count < 1 {
        return Err("it has no profiles".into());
    }
    let profile = extrusion.profile.as_ref().ok_or("it has no profile")?;
    if extrusion.profile_count == 1 {
        return curves::verdict(profile).map_err(|why| format!("its profile: {why}"));
    }
    let CurveForm::Poly { segments, parameters } = profile else {
        return Err("its profiles are no chain".into());
    };
    if usize::try_from(extrusion.profile_count) != Ok(segments.len()) {
        return Err(format!("it should have {} profiles", extrusion.profile_count));
    }
    curves::chain(segments, parameters, true).map_err(|why| format!("its profiles: {why}"))?;
    match segments.iter().all(curves::is_closed) {
        true => Ok(()),
        false => Err("one of its profiles is open".into()),
    }
}
