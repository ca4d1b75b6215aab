//! From a place of the common curve to its end.

use katydid_elementary::Elementary;

use super::proof::Box4;
use super::thresholds::{
    ABOVE_NOISE, ASIDE, BESIDE, COARSEST, LONGEST, RATE, REACH, SAME_PLACE, SHORTEST, SLOWEST,
};
use super::{Condition, Four, Pair, Place};
use crate::{Result, Vector3, cancellation};

/// How exactly, and how far, a curve is followed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    /// The cubics between places, in space and in both domains, keep within this of the curve.
    pub(crate) tolerance: f64,
    /// Shorter steps than this are not tried: the surfaces are tangent there.
    pub(crate) shortest: f64,
    /// The longest step.
    pub(crate) longest: f64,
    /// The most places of a curve.
    pub(crate) most: usize,
}

/// No curve has more places: what takes more is a loop of rounding.
const MOST: usize = 50_000;

impl Limits {
    /// Those for curves within a distance, on surfaces of a size with a noise.
    pub(crate) fn new(limit: f64, size: f64, noise: f64) -> Self {
        Self {
            tolerance: 0.5 * limit.min(COARSEST * size).max(ABOVE_NOISE * noise),
            shortest: (SHORTEST * size).max(ABOVE_NOISE * noise),
            longest: LONGEST * size,
            most: MOST,
        }
    }
}

/// How a curve ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum End {
    /// On a side of a domain.
    Border,
    /// Where it began.
    Closed,
    /// Where no step can be proved: at a tangent place or a pole.
    Stuck,
}

/// The places of a curve in order, and how it ends.
#[derive(Debug, Clone)]
pub(crate) struct Followed {
    pub(crate) places: Vec<Place>,
    /// What was proved of the steps between them.
    pub(crate) steps: Vec<Proved>,
    pub(crate) ends: [End; 2],
}

/// A box of parameters in which each plane across a direction holds at most one common point, and the part of it in
/// which that point is on the curve.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Proved {
    bounds: Box4,
    through: Vector3,
    across: Vector3,
    reach: f64,
}

impl Proved {
    /// Whether a common point must be one of the curve.
    fn holds(&self, x: Four, point: Vector3) -> bool {
        let ahead = self.across.dot(point - self.through);
        let slack = REACH * self.reach;
        (0..4).all(|k| self.bounds[k][0] <= x[k] && x[k] <= self.bounds[k][1])
            && ahead >= -slack
            && ahead <= self.reach + slack
    }
}

impl Followed {
    /// Whether a common point is one of the curve.
    pub(crate) fn holds(&self, x: Four, point: Vector3) -> bool {
        self.steps.iter().any(|s| s.holds(x, point))
    }

    /// As [`Self::holds`] of a common point that is no end of the curve.
    pub(crate) fn passes(&self, pair: &Pair<'_>, x: Four, point: Vector3) -> bool {
        let near = SAME_PLACE * pair.size();
        let ends = [self.places.first(), self.places.last()];
        let is_end = ends.into_iter().flatten().any(|end| (end.point - point).length() <= near);
        !(is_end && self.ends != [End::Closed; 2]) && self.holds(x, point)
    }

    /// Whether the curve is seen to run through a box of parameters.
    pub(crate) fn enters(&self, b: &Box4) -> bool {
        self.steps.iter().zip(self.places.windows(2)).any(|(step, w)| {
            (0..4).all(|k| step.bounds[k][0] <= b[k][1] && b[k][0] <= step.bounds[k][1]) && {
                let cubic = Cubic { from: &w[0], to: &w[1], length: (w[1].point - w[0].point).length() };
                (0..=8).any(|i| {
                    let x = cubic.parameters(f64::from(i) / 8.0);
                    (0..4).all(|k| b[k][0] <= x[k] && x[k] <= b[k][1])
                })
            }
        })
    }
}

/// The whole curve through a place: forwards, and if it does not close, backwards.
///
/// # Errors
/// The work was stopped.
pub(crate) fn followed(pair: &Pair<'_>, start: Place, limits: &Limits) -> Result<Followed> {
    let (mut forwards, mut steps) = (vec![start], Vec::new());
    let end = one_way(pair, &mut forwards, &mut steps, 1.0, limits)?;
    if end == End::Closed {
        return Ok(Followed { places: forwards, steps, ends: [End::Closed; 2] });
    }
    let (mut places, mut before) = (vec![start], Vec::new());
    let begin = one_way(pair, &mut places, &mut before, -1.0, limits)?;
    places.reverse();
    places.pop();
    places.append(&mut forwards);
    before.reverse();
    before.append(&mut steps);
    // From a place on a side it may close the one way only.
    let ends = if begin == End::Closed { [begin; 2] } else { [begin, end] };
    Ok(Followed { places, steps: before, ends })
}

/// Adds the places that follow the first, along its tangent or against it.
fn one_way(
    pair: &Pair<'_>,
    places: &mut Vec<Place>,
    steps: &mut Vec<Proved>,
    sign: f64,
    limits: &Limits,
) -> Result<End> {
    let Some(start) = places.first().copied() else { return Ok(End::Stuck) };
    if leads_out(pair, &start, sign) {
        return Ok(End::Border);
    }
    let mut length = 0.1 * limits.longest;
    // Where a curve comes in through a side and soon leaves by it again, a step may end where it came in.
    let mut came_back = false;
    while places.len() < limits.most {
        cancellation::check()?;
        let Some(&from) = places.last() else { break };
        let Some(step) = attempted(pair, &from, sign, length, limits) else {
            length *= 0.4;
            if length < limits.shortest {
                return Ok(if came_back { End::Border } else { End::Stuck });
            }
            continue;
        };
        came_back = step.to_start;
        if came_back {
            length *= 0.4;
            if length < limits.shortest {
                return Ok(End::Border);
            }
            continue;
        }
        steps.push(step.proved);
        // The step's box holds one point a plane, so that the start, if it is in it, lies on this very piece.
        if places.len() > 2 && step.proved.holds(start.x, start.point) {
            places.push(start);
            return Ok(End::Closed);
        }
        places.push(step.to);
        if step.at_border || leads_out(pair, &step.to, sign) {
            return Ok(End::Border);
        }
        length = (length * step.growth).min(limits.longest);
    }
    Ok(End::Stuck)
}

/// Whether the curve leaves a domain at a place on its side; run the other way it comes in there.
fn leads_out(pair: &Pair<'_>, place: &Place, sign: f64) -> bool {
    (0..4).any(|k| {
        let domain = pair.domain(k);
        let rate = sign * place.velocity[k] * pair.size() / domain.length();
        let slack = pair.slack(k);
        (place.x[k] <= domain.start + slack && rate < -RATE)
            || (place.x[k] >= domain.end - slack && rate > RATE)
    })
}

/// A step that was proved.
struct Step {
    to: Place,
    proved: Proved,
    at_border: bool,
    /// Whether it ends where the curve came in through a side.
    to_start: bool,
    /// The step after it may be longer by this factor.
    growth: f64,
}

/// A step of a length, if it is exact enough and proved.
fn attempted(pair: &Pair<'_>, from: &Place, sign: f64, length: f64, limits: &Limits) -> Option<Step> {
    let along = from.tangent * sign;
    let guess: Four = std::array::from_fn(|k| from.x[k] + sign * length * from.velocity[k]);
    let slice = |d: f64| Condition::Slice { through: from.point + along * d, across: along };
    let found = pair.polished(guess, slice(length));
    // Where the way out of a domain turns off before, the plane holds no point: the side is tried all the same.
    let outside = pair.beyond(found.unwrap_or(guess));
    let (x, at_border) = if outside.iter().all(Option::is_none) {
        (pair.clamped(found?), false)
    } else {
        (left(pair, from, along, length, found.unwrap_or(guess), outside)?, true)
    };
    let to = pair.place(x)?;
    let chord = to.point - from.point;
    let reach = along.dot(chord);
    if !(reach > 0.0) || to.tangent.dot(from.tangent) < 0.9 {
        return None;
    }
    let arc = chord.length();
    if arc <= limits.shortest && !at_border {
        return None;
    }
    let to_start = arc <= limits.shortest && leads_out(pair, from, -sign);
    // The middle of the cubics must lie on the curve.
    let cubic = Cubic { from, to: &to, length: sign * arc };
    let middle = cubic.parameters(0.5);
    let tangent = cubic.direction(0.5)?;
    let through = cubic.point(0.5);
    let true_x = pair.polished(middle, Condition::Slice { through, across: tangent })?;
    // It may leave a domain between the places, and come back.
    let reached = cubic.reached();
    let slack = |k: usize| BESIDE * pair.domain(k).length();
    let is_outside = |k: usize, low: f64, high: f64| {
        low < pair.domain(k).start - slack(k) || high > pair.domain(k).end + slack(k)
    };
    if (0..4).any(|k| is_outside(k, true_x[k].min(reached[k][0]), true_x[k].max(reached[k][1]))) {
        return None;
    }
    let jets = pair.jets(true_x);
    let off = ((jets[0][0] + jets[1][0]) * 0.5 - through).length();
    let mut miss = off;
    for t in [0.25, 0.5, 0.75] {
        let p = cubic.point(t);
        for jet in pair.jets(cubic.parameters(t)) {
            miss = miss.max((jet[0] - p).length());
        }
    }
    if !(miss <= limits.tolerance) {
        return None;
    }
    let bounds = beside(pair, pair.grown(cubic.bounds(true_x), 0.15), arc, &jets);
    if !pair.is_graph(bounds, along) {
        return None;
    }
    let growth = (0.3 * limits.tolerance / miss.max(f64::MIN_POSITIVE)).raised_to(0.25).clamp(0.5, 2.0);
    let proved = Proved { bounds, through: from.point, across: along, reach };
    Some(Step { to, proved, at_border, to_start, growth })
}

/// A box of a step of a length with room on all sides: a curve that leaves a thin box between the places that were looked at
/// could end there, and another one go on.
fn beside(pair: &Pair<'_>, bounds: Box4, arc: f64, jets: &[[Vector3; 3]; 2]) -> Box4 {
    std::array::from_fn(|k| {
        let domain = pair.domain(k);
        // Near a pole a parameter moves nothing, and no room is enough.
        let least = SLOWEST * pair.size() / domain.length();
        let room = ASIDE * arc / jets[k / 2][1 + k % 2].length().max(least);
        [(bounds[k][0] - room).max(domain.start), (bounds[k][1] + room).min(domain.end)]
    })
}

/// Where the curve first leaves a domain between a place and a point beyond.
fn left(
    pair: &Pair<'_>,
    from: &Place,
    along: Vector3,
    length: f64,
    guess: Four,
    outside: [Option<bool>; 4],
) -> Option<Four> {
    let mut best: Option<(f64, Four)> = None;
    for (parameter, side) in outside.iter().enumerate() {
        let Some(at_end) = *side else { continue };
        let domain = pair.domain(parameter);
        let value = if at_end { domain.end } else { domain.start };
        let share = ((value - from.x[parameter]) / (guess[parameter] - from.x[parameter])).clamp(0.0, 1.0);
        let near: Four = std::array::from_fn(|k| from.x[k] + share * (guess[k] - from.x[k]));
        let Some(x) = pair.polished(near, Condition::Fixed { parameter, value }) else { continue };
        if pair.beyond(x).iter().any(Option::is_some) {
            continue;
        }
        let x = pair.clamped(x);
        let reach = along.dot(pair.jets(x)[0][0] - from.point);
        if reach > 0.0 && reach <= 1.1 * length && best.is_none_or(|(r, _)| reach < r) {
            best = Some((reach, x));
        }
    }
    best.map(|(_, x)| x)
}

/// The cubics between two places, in space and in the parameters.
pub(crate) struct Cubic<'a> {
    pub(crate) from: &'a Place,
    pub(crate) to: &'a Place,
    /// The range of the length of the curve; below 0 against the tangents.
    pub(crate) length: f64,
}

impl Cubic<'_> {
    /// The weights of both values and both derivatives.
    fn weights(&self, t: f64) -> [f64; 4] {
        let s = 1.0 - t;
        [s * s * (1.0 + 2.0 * t), t * t * (3.0 - 2.0 * t), self.length * s * s * t, -self.length * t * t * s]
    }

    pub(crate) fn point(&self, t: f64) -> Vector3 {
        let [a, b, c, d] = self.weights(t);
        self.from.point * a + self.to.point * b + self.from.tangent * c + self.to.tangent * d
    }

    pub(crate) fn parameters(&self, t: f64) -> Four {
        let [a, b, c, d] = self.weights(t);
        std::array::from_fn(|k| {
            self.from.x[k] * a + self.to.x[k] * b + self.from.velocity[k] * c + self.to.velocity[k] * d
        })
    }

    /// The range of each parameter along the cubic.
    fn reached(&self) -> Box4 {
        std::array::from_fn(|k| {
            let ends = [self.from.x[k], self.to.x[k]];
            let slopes = [self.from.velocity[k], self.to.velocity[k]].map(|v| v * self.length);
            // The derivative is a + b t + c t².
            let way = ends[1] - ends[0];
            let (a, b, c) = (
                slopes[0],
                6.0 * way - 4.0 * slopes[0] - 2.0 * slopes[1],
                3.0 * (slopes[0] + slopes[1]) - 6.0 * way,
            );
            let mut out = [ends[0].min(ends[1]), ends[0].max(ends[1])];
            let root = (b * b - 4.0 * a * c).max(0.0).sqrt();
            let q = -0.5 * (b + root.copysign(b));
            for t in [q / c, a / q] {
                if t > 0.0 && t < 1.0 {
                    let x = self.parameters(t)[k];
                    out = [out[0].min(x), out[1].max(x)];
                }
            }
            out
        })
    }

    /// The unit direction, along the step.
    fn direction(&self, t: f64) -> Option<Vector3> {
        let slope = (self.to.point - self.from.point) * (6.0 * t * (1.0 - t))
            + (self.from.tangent * ((1.0 - t) * (1.0 - 3.0 * t)) + self.to.tangent * (t * (3.0 * t - 2.0)))
                * self.length;
        slope.unitized()
    }

    /// A box of parameters around the cubic, by its Bézier points, and another place.
    fn bounds(&self, also: Four) -> Box4 {
        std::array::from_fn(|k| {
            let third = self.length / 3.0;
            let all = [
                self.from.x[k],
                self.from.x[k] + third * self.from.velocity[k],
                self.to.x[k] - third * self.to.velocity[k],
                self.to.x[k],
                also[k],
            ];
            all.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |r, x| [r[0].min(*x), r[1].max(*x)])
        })
    }
}
