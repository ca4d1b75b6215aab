//! Pairs of surfaces: how many curves they have in common, how long, and how near to both.

use katydid_geometry::{Curve, Tolerance, intersect};
use serde_json::Value;

use crate::read::{self, Read};
use crate::report::Case;

/// Places of a curve are off both surfaces by no more than this part of the size.
const OFF: f64 = 1e-9;
/// Between its places a curve is off by no more than this part of the size.
const FIT: f64 = 1e-6;

/// What was found, counted.
struct Found {
    closed: usize,
    open: usize,
    length: f64,
}

/// Loops and open branches of a pair, their length in all.
pub(crate) fn branches(v: &Value, case: &mut Case) -> Read<()> {
    let Some(found) = found(v, case)? else { return Ok(()) };
    case.equal("closed branches", found.closed, read::integer(&v["closed"])?);
    case.equal("open branches", found.open, read::integer(&v["open"])?);
    let (length, part) = (read::number(&v["length"])?, read::number(&v["length_rel_tol"])?);
    case.number("length", found.length, length, length.max(1e-9), part);
    Ok(())
}

/// Branches of a pair as another kernel counts them, and their length in all.
pub(crate) fn points(v: &Value, case: &mut Case) -> Read<()> {
    let Some(found) = found(v, case)? else { return Ok(()) };
    case.equal("branches", found.closed + found.open, read::integer(&v["branches_occ"])?);
    let length = read::number(&v["total_length_occ"])?;
    case.number("length", found.length, length, length.max(1e-9), 1e-4);
    Ok(())
}

fn found(v: &Value, case: &mut Case) -> Read<Option<Found>> {
    let (a, b) = (read::surface(&v["a"])?, read::surface(&v["b"])?);
    let size = a.hull_box().diagonal().length().min(b.hull_box().diagonal().length());
    let tolerance = Tolerance { absolute: FIT * size, ..Tolerance::default() };
    let Some(met) = case.made("surfaces", intersect::surface_surface(&a, &b, &tolerance)) else {
        return Ok(None);
    };
    case.equal("the search came to its end", met.complete, true);
    case.equal("contacts", met.contacts.len(), 0);
    let mut out = Found { closed: 0, open: 0, length: 0.0 };
    for branch in &met.branches {
        if branch.closed {
            out.closed += 1;
        } else {
            out.open += 1;
        }
        out.length += branch.curve.length();
        case.number("off between places", branch.deviation, 0.0, size, FIT);
        let Curve::Nurbs(curve) = &branch.curve else { continue };
        for t in curve.knots() {
            let p = curve.point_at(*t);
            for (surface, image) in [&a, &b].into_iter().zip(&branch.parameters) {
                let uv = image.point_at(*t);
                case.number("off at places", surface.point_at(uv.x, uv.y).distance_to(p), 0.0, size, OFF);
            }
        }
    }
    Ok(Some(out))
}
