//! Cutting a surface along its kinks.

use super::thresholds::{SAME_PLACE, STRAIGHT};
use crate::{Direction, NurbsSurface, Result};

/// Along which knot lines a surface is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Breaks {
    /// Where its tangent planes may leap.
    Turns,
    /// Where its first derivatives leap: there it may be as smooth as anywhere, while bounds on derivatives over both
    /// sides tell less.
    Speeds,
}

/// The surface cut along the knot lines with breaks of a kind. Pieces in order, those along v together; those
/// that are not `wanted` are left out, and parts that are not wanted hold none that are.
///
/// # Errors
/// A number overflows, or the work was stopped.
pub(crate) fn smooth_pieces(
    nurbs: &NurbsSurface,
    breaks: Breaks,
    wanted: &dyn Fn(&NurbsSurface) -> bool,
) -> Result<Vec<NurbsSurface>> {
    let mut pieces = vec![nurbs.clone()];
    for direction in Direction::BOTH {
        let kinks = kinks(nurbs, direction, breaks);
        let mut next = Vec::with_capacity(pieces.len());
        for piece in pieces {
            cut(piece, direction, &kinks, wanted, &mut next)?;
        }
        pieces = next;
    }
    Ok(pieces)
}

/// Cuts a surface at parameters in order: in the middle one first, so that each control point is copied few times.
fn cut(
    surface: NurbsSurface,
    direction: Direction,
    at: &[f64],
    wanted: &dyn Fn(&NurbsSurface) -> bool,
    out: &mut Vec<NurbsSurface>,
) -> Result<()> {
    crate::cancellation::check_now()?;
    if !wanted(&surface) {
        return Ok(());
    }
    let (before, rest) = at.split_at(at.len() / 2);
    let Some((&t, after)) = rest.split_first() else {
        out.push(surface);
        return Ok(());
    };
    let (first, second) = surface.split(direction, t)?;
    cut(first, direction, before, wanted, out)?;
    cut(second, direction, after, wanted, out)
}

/// Whether a surface has more breaks in its speeds than kinks.
pub(crate) fn changes_speed(nurbs: &NurbsSurface) -> bool {
    let count = |d, breaks| kinks(nurbs, d, breaks).len();
    Direction::BOTH.iter().any(|d| count(*d, Breaks::Speeds) > count(*d, Breaks::Turns))
}

/// The parameters inside the domain at which the surface has a break of a kind.
fn kinks(nurbs: &NurbsSurface, direction: Direction, breaks: Breaks) -> Vec<f64> {
    let degree = nurbs.degree(direction);
    let knots = nurbs.knots(direction);
    let domain = nurbs.domain(direction);
    // Where a side collapses to a point its legs are rounding.
    let no_leg = SAME_PLACE * nurbs.hull_box().diagonal().length();
    let mut out = Vec::new();
    let mut i = 0;
    while i < knots.len() {
        let t = knots[i];
        let multiplicity = knots[i..].iter().take_while(|k| **k == t).count();
        // The control point on the knot line is that before the last `degree` of its knots.
        if multiplicity >= degree && t > domain.start && t < domain.end {
            let row = i + multiplicity - degree;
            let spans = [i.checked_sub(1), Some(i + multiplicity)].map(|k| k.and_then(|k| knots.get(k)));
            let leaps = match (breaks, spans) {
                (Breaks::Speeds, [Some(before), Some(after)]) => {
                    leaps(nurbs, direction, row, [t - before, after - t], no_leg)
                }
                _ => false,
            };
            if leaps || turns(nurbs, direction, row, no_leg) {
                out.push(t);
            }
        }
        i += multiplicity;
    }
    out
}

/// Whether the legs of the net on both sides of a row of control points turn; those no longer than `no_leg` have no direction.
fn turns(nurbs: &NurbsSurface, direction: Direction, row: usize, no_leg: f64) -> bool {
    let across = nurbs.count(direction.other());
    let at = |r: usize, k: usize| match direction {
        Direction::U => nurbs.control_point(r, k),
        Direction::V => nurbs.control_point(k, r),
    };
    let Some(before) = row.checked_sub(1) else { return false };
    (0..across).any(|k| {
        let (Some(a), Some(b), Some(c)) = (at(before, k), at(row, k), at(row + 1, k)) else { return false };
        let (p, q) = (b - a, c - b);
        let is_leg = p.length() > no_leg && q.length() > no_leg;
        is_leg && (p.dot(q) < 0.0 || p.cross(q).length() > STRAIGHT * p.length() * q.length())
    })
}

/// Whether the derivatives across a row of control points on a knot line differ between its sides, the spans beside which have
/// these lengths; those of legs no longer than `no_leg` are told by other rows.
fn leaps(nurbs: &NurbsSurface, direction: Direction, row: usize, spans: [f64; 2], no_leg: f64) -> bool {
    let across = nurbs.count(direction.other());
    let at = |r: usize, k: usize| {
        let [i, j] = if direction == Direction::U { [r, k] } else { [k, r] };
        Some((nurbs.control_point(i, j)?, nurbs.weight(i, j)?))
    };
    let Some(before) = row.checked_sub(1) else { return false };
    (0..across).any(|k| {
        let (Some((a, u)), Some((b, _)), Some((c, w))) = (at(before, k), at(row, k), at(row + 1, k)) else {
            return false;
        };
        let (p, q) = (b - a, c - b);
        if !(p.length() > no_leg && q.length() > no_leg) {
            return false;
        }
        // But for a common factor.
        let (p, q) = (p * (u / spans[0]), q * (w / spans[1]));
        (p - q).length() > STRAIGHT * p.length().max(q.length())
    })
}
