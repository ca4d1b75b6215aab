//! Ruled surfaces between two curves that can be laid flat without stretching.
//!
//! A ruled surface is developable where its tangent plane is the same along the whole of each ruling: where the ruling
//! and the tangents of both rails at its ends lie in one plane. Which point of one rail goes with which of the other is
//! looked for as a way through the rectangle of both parameters, first over a grid as the cheapest of all ways (after
//! Wang and Tang, *Optimal boundary triangulations of an interpolating ruled surface*, 2005), then exactly. Where no
//! such rulings are, one rail waits while the other goes on: a cone, which is developable too.

mod pieces;
mod rail;
mod strip;
mod way;

use rail::Rail;

use super::check;
use crate::{Brep, Curve, Error, Result, Tolerance};

/// The most rulings that a grid has along a rail.
const MOST_STATIONS: usize = 600;

/// What a developable loft heeds beside its rails.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct DevelopableOptions {
    /// How many rulings are tried along each rail; 0 leaves it to the shape of the rails. At most 600.
    pub density: usize,
    /// Rulings that must be there, as parameters on the first and the second rail, in order along both.
    pub fixed: Vec<[f64; 2]>,
}

/// A ruled surface, and how far it is from developable.
#[derive(Debug, Clone, PartialEq)]
pub struct DevelopableLoft {
    /// The surface, a face for each strip and each cone: u along the rails, straight lines in v from the first rail to
    /// the second.
    pub brep: Brep,
    /// The largest angle between the normals at both ends of a ruling, in radians: 0 for what can be laid flat exactly.
    pub twist: f64,
}

/// The surface between two rails that comes nearest to one that can be unrolled: strips whose tangent planes do not turn
/// along their rulings, and cones between them. Rails that allow no such strip give the least twisted one; how much it
/// is twisted is told. The surface is within `tolerance.absolute` of both rails; cones, and strips whose rails go at the
/// same pace, are exact.
///
/// The directions of the rails are taken as they come. A closed second rail begins where a ruling from the start of the
/// first does not twist, if there is such a place.
///
/// # Errors
/// Rails that are the same, a surface without area, or fixed rulings that are outside the rails or cross.
pub fn developable_loft(
    first: &Curve,
    second: &Curve,
    options: &DevelopableOptions,
    tolerance: &Tolerance,
) -> Result<DevelopableLoft> {
    let limit = check(&[first, second], tolerance)?;
    let count = match options.density {
        0 => 160 + 4 * (first.hull_points().len() + second.hull_points().len()),
        density => density.max(40),
    };
    let count = count.min(MOST_STATIONS);
    let begun = match (first.is_closed() && second.is_closed(), options.fixed.as_slice()) {
        (true, []) => rail::begun_at_flat_ruling(first, second, tolerance)?,
        _ => second.clone(),
    };
    let wanted = [0, 1].map(|side| options.fixed.iter().map(|ruling| ruling[side]).collect::<Vec<_>>());
    let rails =
        [Rail::of(first, count, &wanted[0], tolerance)?, Rail::of(&begun, count, &wanted[1], tolerance)?];
    let corners = corners(&rails, &options.fixed)?;
    let mut breps = Vec::new();
    let mut twist = 0.0_f64;
    for pair in corners.windows(2) {
        let way = way::cheapest(&rails, pair[0], pair[1]);
        for piece in pieces::of(&rails, &way) {
            twist = twist.max(piece.twist(&rails));
            breps.extend(strip::surface(&rails, &piece, limit, tolerance)?);
        }
    }
    if breps.is_empty() {
        return Err(Error::degenerate("developable loft", "there is no area between its rails"));
    }
    let joined = Brep::join(&breps, tolerance)?.breps;
    let brep = match <[Brep; 1]>::try_from(joined) {
        Ok([brep]) => brep,
        // Pieces that meet in a point only.
        Err(several) => Brep::merged(&several),
    };
    Ok(DevelopableLoft { brep, twist })
}

/// The stations of both rails between which ways are looked for: the ends and the fixed rulings.
fn corners(rails: &[Rail; 2], fixed: &[[f64; 2]]) -> Result<Vec<[usize; 2]>> {
    let mut out = vec![[0, 0]];
    for ruling in fixed {
        let mut corner = [0; 2];
        for side in 0..2 {
            corner[side] = rails[side].station_at(ruling[side]).ok_or(Error::Invalid {
                what: "fixed rulings",
                why: format!("{} is not on the rail", ruling[side]),
            })?;
        }
        let last = out.last().copied().unwrap_or_default();
        if corner[0] < last[0] || corner[1] < last[1] {
            return Err(Error::Invalid { what: "fixed rulings", why: "they cross one another".into() });
        }
        if corner != last {
            out.push(corner);
        }
    }
    let end = [rails[0].last(), rails[1].last()];
    if out.last() != Some(&end) {
        out.push(end);
    }
    Ok(out)
}
