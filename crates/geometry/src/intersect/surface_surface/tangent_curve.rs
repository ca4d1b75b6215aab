//! Curves along which two surfaces touch, followed in the direction in which they stay together.

use super::touch::{bends, touching};
use crate::chart::thresholds::{RATE, SAME_PLACE};
use crate::trace::{Condition, Cubic, Four, Limits, Pair, Place, on};
use crate::{Result, cancellation};

/// More places than this are not followed.
const MOST: usize = 20_000;
/// A step in which the curve turns by more than the angle with this cosine is too long.
const TURN: f64 = 0.95;

/// A curve of tangent places.
pub(super) struct TangentCurve {
    pub(super) places: Vec<Place>,
    pub(super) closed: bool,
}

/// How one way along the curve ends.
#[derive(PartialEq)]
enum End {
    Border,
    Closed,
    Lost,
}

/// The whole curve of tangent places through one; `None` when it cannot be followed from a side of the domains to a side, or
/// around.
///
/// # Errors
/// The work was stopped.
pub(super) fn tangent_curve(pair: &Pair<'_>, x: Four, limits: &Limits) -> Result<Option<TangentCurve>> {
    let Some(start) = place(pair, x, None) else { return Ok(None) };
    let mut places = vec![start];
    match one_way(pair, &mut places, 1.0, limits)? {
        End::Lost => return Ok(None),
        End::Closed => return Ok(Some(TangentCurve { places, closed: true })),
        End::Border => {}
    }
    let mut before = vec![start];
    if one_way(pair, &mut before, -1.0, limits)? != End::Border {
        return Ok(None);
    }
    before.reverse();
    before.pop();
    before.append(&mut places);
    Ok((before.len() > 1).then_some(TangentCurve { places: before, closed: false }))
}

/// The tangent place at parameters, its tangent on the side of a known one.
fn place(pair: &Pair<'_>, x: Four, before: Option<&Place>) -> Option<Place> {
    let jets = pair.jets(x);
    let tangent = bends(pair, x)?.null_direction(pair.size())?;
    let tangent = if before.is_some_and(|b| b.tangent.dot(tangent) < 0.0) { -tangent } else { tangent };
    let lifted = |s: usize| crate::chart::Chart::lifted(&jets[s], tangent);
    let [a, b] = [lifted(0)?, lifted(1)?];
    let point = (jets[0][0] + jets[1][0]) * 0.5;
    Some(Place { x, point, tangent, velocity: [a[0], a[1], b[0], b[1]], angle: 0.0 })
}

fn one_way(pair: &Pair<'_>, places: &mut Vec<Place>, sign: f64, limits: &Limits) -> Result<End> {
    let Some(&start) = places.first() else { return Ok(End::Lost) };
    let mut length = 0.1 * limits.longest;
    while places.len() < MOST {
        cancellation::check()?;
        let Some(&from) = places.last() else { break };
        if leads_out(pair, &from, sign) {
            return Ok(End::Border);
        }
        if places.len() > 2
            && let Some(end) = closing(pair, &from, &start, sign, length, limits)
        {
            places.push(end);
            return Ok(End::Closed);
        }
        match step(pair, &from, sign, length, limits) {
            Some(to) => {
                places.push(to);
                length = (1.5 * length).min(limits.longest);
            }
            None => {
                length *= 0.4;
                if length < limits.shortest {
                    return Ok(End::Lost);
                }
            }
        }
    }
    Ok(End::Lost)
}

/// Which parameters lie beyond a domain that does not close, and its end there.
fn beyond(pair: &Pair<'_>, x: Four) -> Option<(usize, f64)> {
    let outside = pair.beyond(x);
    (0..4).find_map(|k| {
        let at_end = outside[k].filter(|_| pair.charts[k / 2].period(k % 2).is_none())?;
        let domain = pair.domain(k);
        Some((k, if at_end { domain.end } else { domain.start }))
    })
}

/// Whether the curve leaves a domain at a place on its side.
fn leads_out(pair: &Pair<'_>, place: &Place, sign: f64) -> bool {
    (0..4).filter(|k| pair.charts[k / 2].period(k % 2).is_none()).any(|k| {
        let domain = pair.domain(k);
        let rate = sign * place.velocity[k] * pair.size() / domain.length();
        let slack = pair.slack(k);
        (place.x[k] <= domain.start + slack && rate < -RATE)
            || (place.x[k] >= domain.end - slack && rate > RATE)
    })
}

/// The next place, on the side of a domain if the way leads out.
fn step(pair: &Pair<'_>, from: &Place, sign: f64, length: f64, limits: &Limits) -> Option<Place> {
    let along = from.tangent * sign;
    let guess =
        |part: f64| -> Four { std::array::from_fn(|k| from.x[k] + sign * part * length * from.velocity[k]) };
    let slice = Condition::Slice { through: from.point + along * length, across: along };
    let mut x = touching(pair, guess(1.0), Some(slice))?;
    // Out of two domains at once: the side that is met last lies inside both.
    for _ in 0..2 {
        let Some((parameter, value)) = beyond(pair, x) else { break };
        let share = (value - from.x[parameter]) / (x[parameter] - from.x[parameter]);
        let near = std::array::from_fn(|k| from.x[k] + share.clamp(0.0, 1.0) * (x[k] - from.x[k]));
        x = touching(pair, near, Some(Condition::Fixed { parameter, value }))?;
    }
    if beyond(pair, x).is_some() {
        return None;
    }
    let to = place(pair, x, Some(from))?;
    is_good(pair, from, &to, sign, limits).then_some(to)
}

/// Whether the cubics between two places keep to the curve, as far as their middle tells, and to both surfaces.
fn is_good(pair: &Pair<'_>, from: &Place, to: &Place, sign: f64, limits: &Limits) -> bool {
    let chord = (to.point - from.point).length();
    if !(chord > 0.0)
        || to.tangent.dot(from.tangent) < TURN
        || (to.point - from.point).dot(from.tangent) * sign <= 0.0
    {
        return false;
    }
    let cubic = Cubic { from, to, length: sign * chord };
    for t in [0.25, 0.5, 0.75] {
        let (p, x) = (cubic.point(t), cubic.parameters(t));
        let off = [0, 1].map(|s| (pair.charts[s].jet(on(x, s))[0] - p).length());
        if !(off[0].max(off[1]) <= limits.tolerance) {
            return false;
        }
    }
    let (p, x) = (cubic.point(0.5), cubic.parameters(0.5));
    let across = (to.point - from.point) / chord;
    let middle = touching(pair, x, Some(Condition::Slice { through: p, across }));
    middle.is_some_and(|y| {
        let jets = pair.jets(y);
        ((jets[0][0] + jets[1][0]) * 0.5 - p).length() <= limits.tolerance
    })
}

/// The start, met again within the next step; its parameters go on from where the curve is.
fn closing(
    pair: &Pair<'_>,
    from: &Place,
    start: &Place,
    sign: f64,
    length: f64,
    limits: &Limits,
) -> Option<Place> {
    let along = from.tangent * sign;
    let ahead = (start.point - from.point).dot(along);
    if !(ahead > SAME_PLACE * pair.size() && ahead <= length) {
        return None;
    }
    let guess: Four = std::array::from_fn(|k| from.x[k] + sign * ahead * from.velocity[k]);
    let x = touching(pair, guess, Some(Condition::Slice { through: start.point, across: along }))?;
    let to = place(pair, x, Some(from))?;
    let same = (to.point - start.point).length() <= SAME_PLACE * pair.size();
    (same && is_good(pair, from, &to, sign, limits)).then_some(Place {
        point: start.point,
        tangent: start.tangent,
        ..to
    })
}
