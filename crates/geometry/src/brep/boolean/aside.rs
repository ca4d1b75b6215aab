//! Pieces on a face that divide nothing, looked at once more: they may only touch it.
//!
//! An edge that stands on a face, or a seam along which two surfaces are tangent, is drawn there and divides nothing. A
//! piece that should have divided the face, and does not since another one was not found, looks the same in the plane of
//! the face. The two sides of the piece tell them apart: what is seen from there must be what was told of the region that
//! they lie in.

use super::operands::{Face, Operands};
use super::pieces::{OnFace, Pieces};
use super::refusal::RefusalClass;
use super::thresholds::{ASIDE, CAPTURE};
use crate::{Containment, Curve, Error, Point3, Result};

/// Refuses a piece on a face that should have divided it. `told` gives, for parameters of the face and an operand, what
/// was found of the region there; none where no region is.
pub(super) fn refuse_dividing(
    all: &Operands,
    pieces: &Pieces,
    OnFace { face, piece }: OnFace,
    told: impl Fn([f64; 2], usize) -> Option<Containment>,
) -> Result<()> {
    let (Some(own), Some(idle)) = (all.faces.get(face), pieces.list.get(piece)) else { return Ok(()) };
    let closed = |solid: &usize| all.solids.get(*solid).is_some_and(|s| s.closed);
    for &solid in idle.solids.iter().filter(|s| **s != own.solid && closed(s)) {
        let mut seen = Vec::with_capacity(2);
        for (uv, p) in sides(own, &idle.curve, ASIDE * all.limit)? {
            if let Some(told) = told(uv, solid)
                && let Some(found) = containment(all, solid, p)?
            {
                seen.push((told, found));
            }
        }
        // Where both sides are on the operand, and no region is, it is tangent to the face.
        let tangent = seen.len() == 2 && seen.iter().all(|(_, found)| *found == Containment::On);
        let wrong = seen.iter().any(|&(told, found)| told != found && told != Containment::On);
        if wrong && !tangent {
            return Err(all.refuse(RefusalClass::UnclosedSplit, &[face], pieces.middle(piece)));
        }
    }
    Ok(())
}

/// Points on a face at a distance from the middle of a curve on it, on both sides; what is beyond its border is left out.
fn sides(face: &Face, curve: &Curve, distance: f64) -> Result<Vec<([f64; 2], Point3)>> {
    let middle = curve.domain().middle();
    let p = curve.point_at(middle);
    let uv = face.parameters(p)?;
    let (Some(along), Some(normal)) = (curve.tangent_at(middle), face.normal(uv)) else {
        return Ok(Vec::new());
    };
    let Some(aside) = normal.cross(along).unitized() else { return Ok(Vec::new()) };
    let mut out = Vec::with_capacity(2);
    for way in [aside * distance, -aside * distance] {
        let uv = face.parameters(p + way)?;
        if face.covers(uv) {
            out.push((uv, face.surface.point_at(uv[0], uv[1])));
        }
    }
    Ok(out)
}

/// Where a point lies to an operand; none where that is not decided.
fn containment(all: &Operands, solid: usize, p: Point3) -> Result<Option<Containment>> {
    let Some(own) = all.solids.get(solid) else { return Ok(None) };
    match own.search()?.contains(p, CAPTURE * all.limit) {
        Ok(found) => Ok(Some(found)),
        Err(Error::Stopped) => Err(Error::Stopped),
        Err(_) => Ok(None),
    }
}
