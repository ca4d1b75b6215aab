//! Open operands: each is taken to fill what lies behind it where the others meet it.
//!
//! An open brep has no inside. Where another operand's faces are cut along it, their parts leave the cut on its one side
//! or on the other; what hangs together without crossing it lies on one side of it. So it divides what it meets, as Rhino
//! has it, and nothing else. Open operands upon each other count as looking the same way: a sheet without a sheet in its
//! plane is what the one has and the other has not.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use super::cells::Sheet;
use super::refusal::RefusalClass;
use super::shells::{Chosen, Sets, Shells, Use};
use crate::{Error, Result, cancellation};

/// The sheets with what is behind open operands told too.
pub(super) fn with_open(shells: &Shells<'_>, sheets: &[Sheet]) -> Result<Vec<Sheet>> {
    let mut out = sheets.to_vec();
    let is_open = |k: usize| shells.all.solids.get(k).is_some_and(|s| !s.closed);
    for sheet in &mut out {
        let own = shells.regions.get(sheet.region).and_then(|r| shells.all.faces.get(r.face));
        if !own.is_some_and(|f| is_open(f.solid)) {
            continue;
        }
        for operand in (0..shells.all.solids.len()).filter(|k| is_open(*k)) {
            if sheet.sides.is_on(operand) {
                sheet.sides.behind.set(operand, true);
                sheet.sides.before.set(operand, false);
            }
        }
    }
    let uses = shells.uses();
    let open = shells.all.solids.iter().enumerate().filter(|(_, s)| !s.closed);
    for (operand, _) in open {
        let own = behind(shells, &out, &uses, operand)?;
        for (place, inside) in own.into_iter().enumerate() {
            let Some(sides) = out.get_mut(place).map(|s| &mut s.sides) else { continue };
            if let Some(inside) = inside {
                sides.behind.set(operand, inside);
                sides.before.set(operand, inside);
            }
        }
    }
    Ok(out)
}

/// All sheets, not turned.
pub(super) fn every(sheets: &[Sheet]) -> Vec<Chosen> {
    sheets.iter().map(|s| Chosen { region: s.region, flipped: false }).collect()
}

/// For each sheet whether it lies behind an open operand; none where it is part of it, or does not meet it.
fn behind(
    shells: &Shells<'_>,
    sheets: &[Sheet],
    uses: &BTreeMap<usize, Vec<Use>>,
    operand: usize,
) -> Result<Vec<Option<bool>>> {
    let sides = |k: usize| {
        let own = sheets.get(k).map(|s| &s.sides)?;
        Some((own.behind.has(operand), own.before.has(operand)))
    };
    let is_on = |k: usize| sides(k).is_some_and(|(behind, before)| behind != before);
    let is_cut = |piece: usize| shells.pieces.list.get(piece).is_some_and(|p| p.solids.contains(&operand));
    let mut sets = Sets::new(sheets.len());
    for (piece, list) in uses {
        if is_cut(*piece) {
            continue;
        }
        for pair in list.windows(2) {
            sets.join(pair[0].chosen, pair[1].chosen);
        }
    }
    // For each set that meets the operand what is known of it.
    let mut known: BTreeMap<usize, Option<bool>> = BTreeMap::new();
    for (piece, list) in uses {
        cancellation::check()?;
        if !is_cut(*piece) || !list.iter().any(|u| is_on(u.chosen)) || list.iter().all(|u| is_on(u.chosen)) {
            continue;
        }
        let order = match shells.angles(*piece, list) {
            Ok(order) => Some(order),
            Err(Error::Refused(_)) => None,
            Err(other) => return Err(other),
        };
        for own in list.iter().filter(|u| !is_on(u.chosen)) {
            let found = order.as_ref().map_or(Seen::Undecided, |order| side_of(order, own, is_on, sides));
            let found = match found {
                Seen::Beyond => continue,
                Seen::Undecided => None,
                Seen::Side(inside) => Some(inside),
            };
            let set = known.entry(sets.root(own.chosen)).or_default();
            if let (Some(a), Some(b)) = (*set, found)
                && a != b
            {
                return Err(shells.refuse_at(*piece, list));
            }
            *set = set.or(found);
        }
    }
    let mut out = Vec::with_capacity(sheets.len());
    for place in 0..sheets.len() {
        out.push(match known.get(&sets.root(place)) {
            _ if is_on(place) => None,
            None => None,
            Some(Some(inside)) => Some(*inside),
            Some(None) => {
                let face: Vec<usize> = shells.region(place).map(|r| r.face).into_iter().collect();
                let at = shells.region(place).and_then(|r| r.samples.first()).map(|s| s.point);
                return Err(shells.all.refuse(RefusalClass::UndecidedPoint, &face, at));
            }
        });
    }
    Ok(out)
}

/// What is seen of a use from an operand at their common piece.
enum Seen {
    /// It goes on where the operand ends.
    Beyond,
    Undecided,
    /// It leaves the operand on the side behind it, or before it.
    Side(bool),
}

/// Uses that leave the border of an operand at less than this angle from straight on, in radians, go on beyond it.
const STRAIGHT_ON: f64 = 1e-2;

/// On which side of an operand a use is, by the uses of the operand before and after it in the order around their piece.
fn side_of(
    order: &[(f64, Use)],
    own: &Use,
    is_on: impl Fn(usize) -> bool,
    sides: impl Fn(usize) -> Option<(bool, bool)>,
) -> Seen {
    let count = order.len();
    let Some(at) = order.iter().position(|(_, u)| u.chosen == own.chosen && u.step == own.step) else {
        return Seen::Undecided;
    };
    let turn = |k: usize| (at + k) % count;
    let is_other = |k: &usize| order.get(*k).is_some_and(|(_, u)| is_on(u.chosen));
    let after = (1..count).map(turn).find(is_other);
    let before = (1..count).rev().map(turn).find(is_other);
    // A normal that looks to larger angles has what is before its face there.
    let beside = |k: Option<usize>, larger: bool| {
        let (_, u) = order.get(k?)?;
        let (behind, before) = sides(u.chosen)?;
        Some(if u.backwards != larger { before } else { behind })
    };
    if let (Some(k), true) = (after, after == before)
        && let (Some((other, _)), Some((angle, _))) = (order.get(k), order.get(at))
    {
        // The border of the operand: the plane that goes on beyond it divides.
        let turned = (angle - other).rem_euclid(TAU);
        if (turned - PI).abs() < STRAIGHT_ON {
            return Seen::Beyond;
        }
        return beside(after, turned < PI).map_or(Seen::Undecided, Seen::Side);
    }
    match (beside(before, true), beside(after, false)) {
        (Some(a), Some(b)) if a == b => Seen::Side(a),
        _ => Seen::Undecided,
    }
}
