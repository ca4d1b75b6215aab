//! Which items of a set a factor blends, and how much of each.

use katydid_component::Message;

/// How a set is followed by a factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Way {
    /// Whether the factor goes from 0 to 1 over the set; else it counts the items.
    pub(super) normalized: bool,
    /// Whether the set goes on from its last item to its first.
    pub(super) closed: bool,
    /// Whether it is followed by curves, not by straight lines.
    pub(super) smooth: bool,
}

/// The numbers of items with their shares, which add up to 1. Beyond the ends the straight line goes on.
///
/// # Errors
/// There is no item, or the factor is not finite.
pub(super) fn weights(count: usize, factor: f64, way: Way) -> Result<Vec<(usize, f64)>, Message> {
    if count == 0 {
        return Err(Message::warning("There is nothing to blend"));
    }
    if !factor.is_finite() {
        return Err(Message::error("The factor is not finite"));
    }
    let parts = if way.closed { count } else { count - 1 };
    if parts == 0 {
        return Ok(vec![(0, 1.0)]);
    }
    let place = if way.normalized { factor * parts as f64 } else { factor };
    let place = if way.closed && place != parts as f64 { place.rem_euclid(parts as f64) } else { place };
    let first = place.floor().clamp(0.0, parts as f64 - 1.0);
    let t = place - first;
    let first = first as usize;
    let item = |i: usize, step: usize| {
        // One before, itself, one and two behind.
        let i = i + step;
        if way.closed { (i + count - 1) % count } else { i.saturating_sub(1).min(count - 1) }
    };
    if !way.smooth || !(0.0..=1.0).contains(&t) {
        return Ok(vec![(item(first, 1), 1.0 - t), (item(first, 2), t)]);
    }
    let (t2, t3) = (t * t, t * t * t);
    let mut shares = vec![
        (item(first, 0), -0.5 * t3 + t2 - 0.5 * t),
        (item(first, 1), 1.5 * t3 - 2.5 * t2 + 1.0),
        (item(first, 2), -1.5 * t3 + 2.0 * t2 + 0.5 * t),
        (item(first, 3), 0.5 * t3 - 0.5 * t2),
    ];
    shares.retain(|(_, share)| *share != 0.0);
    Ok(shares)
}

/// The numbers of items with their shares between item `i` of a set and the next. A factor beyond 0 to 1 goes on along the straight
/// line of the pair.
///
/// # Errors
/// As [`weights`].
pub(super) fn between(
    count: usize,
    [i, next]: [usize; 2],
    factor: f64,
    way: Way,
) -> Result<Vec<(usize, f64)>, Message> {
    if (0.0..=1.0).contains(&factor) || !factor.is_finite() {
        return weights(count, i as f64 + factor, Way { normalized: false, ..way });
    }
    Ok(vec![(i, 1.0 - factor), (next, factor)])
}

/// The pairs of neighbours in a set, the last with the first where it is closed.
pub(super) fn pairs(count: usize, closed: bool) -> Vec<[usize; 2]> {
    let parts = if closed && count > 1 { count } else { count.saturating_sub(1) };
    (0..parts).map(|i| [i, (i + 1) % count.max(1)]).collect()
}
