//! Into how many parts a rectangle of parameters must be divided to keep the limits.

use crate::meshing::thresholds::RATIO;
use crate::thresholds;
use std::f64::consts::PI;

use super::bend::Bend;
use super::settings::Limits;

/// How far cells may be sheared along the surface, as a fraction of their shortest side: beyond, straight sides of
/// triangles pass over places that the parameters say are elsewhere.
const SHEAR: f64 = 0.15;

/// The most that normals may turn in a cell, whatever the shortest edge: a tube in one or two parts encloses nothing.
const MOST_TURN: f64 = 2.0 * PI / 3.0;

/// The numbers of parts in u and v, at least 1, that keep the limits on a rectangle with as few cells as possible.
pub(super) fn parts(bend: &Bend, [h, k]: [f64; 2], limits: &Limits) -> [f64; 2] {
    let sides = [h * bend.speed[0], k * bend.speed[1]];
    let mut n = distance_parts(bend, [h, k], sides, limits.distance);
    n[0] = n[0].max(h * bend.turn[0] / limits.angle);
    n[1] = n[1].max(k * bend.turn[1] / limits.angle);
    for _ in 0..20 {
        let cell = [h / n[0], k / n[1]];
        let sides = [sides[0] / n[0], sides[1] / n[1]];
        if !is_sheared(bend, cell, sides, limits, 1.0) {
            break;
        }
        n[direction_of(&bend.along, cell, sides)] *= 1.25;
    }
    if limits.aspect.is_finite() {
        for d in 0..2 {
            let (long, across) = (sides[d] / n[d], sides[1 - d] / n[1 - d]);
            if across > 0.0 && long > limits.aspect * across {
                n[d] = sides[d] / (limits.aspect * across);
            }
        }
    }
    [0, 1].map(|d| {
        let most = if limits.min_edge > 0.0 { (sides[d] / limits.min_edge).max(1.0) } else { f64::INFINITY };
        let round = if sides[d] > limits.short { [h, k][d] * bend.turn[d] / MOST_TURN } else { 0.0 };
        n[d].min(most).max(round).max(sides[d] / limits.max_edge).clamp(1.0, 1e6)
    })
}

/// The parts that the distance alone asks for.
fn distance_parts(bend: &Bend, [h, k]: [f64; 2], sides: [f64; 2], distance: f64) -> [f64; 2] {
    let [a, b, c] = bend.off;
    let (a, b, c) = (a * h * h, b * h * k, c * k * k);
    let room = 8.0 * distance;
    if a + 2.0 * b + c <= room {
        return [1.0; 2];
    }
    // The fewest cells: those where u and v take the same share; with a twist alone, square ones.
    let ratio = if sides[0] > 0.0 && sides[1] > 0.0 { sides[1] / sides[0] } else { 1.0 };
    let r = ((c + 0.1 * b * ratio) / (a + 0.1 * b / ratio)).sqrt().clamp(RATIO[0], RATIO[1]);
    let y = (room / (a * r * r + 2.0 * b * r + c)).sqrt();
    let x = r * y;
    // The other direction when one is not divided: c y² + 2 b y + a = room.
    let other = |a: f64, c: f64| {
        let left = room - a;
        if left <= 0.0 {
            None
        } else {
            // The positive root without cancellation.
            Some(left / (b + (b * b + c * left).sqrt()))
        }
    };
    let [x, y] = match (x > 1.0, y > 1.0) {
        (true, _) => other(a, c).map_or([x, y], |y| [1.0, y]),
        (_, true) => other(c, a).map_or([x, y], |x| [x, 1.0]),
        _ => [x, y],
    };
    [(1.0 / x).max(1.0), (1.0 / y).max(1.0)]
}

/// In which direction a cell must be halved to keep the limits; none when it keeps them.
pub(super) fn halving(bend: &Bend, cell: [f64; 2], limits: &Limits) -> Option<usize> {
    let sides = [cell[0] * bend.speed[0], cell[1] * bend.speed[1]];
    for d in 0..2 {
        if sides[d] > limits.max_edge * (1.0 + thresholds::OVER_LIMIT) {
            return Some(d);
        }
        if sides[d] > limits.short && cell[d] * bend.turn[d] > MOST_TURN * (1.0 + thresholds::OVER_LIMIT) {
            return Some(d);
        }
    }
    let room = |d: &usize| sides[*d] >= 2.0 * limits.min_edge;
    let either = |d: usize| [d, 1 - d].into_iter().find(room);
    if bend.distance(cell) > limits.distance * (1.0 + thresholds::OVER_LIMIT) {
        return either(direction_of(&bend.off, cell, sides));
    }
    if is_sheared(bend, cell, sides, limits, 1.6) {
        return either(direction_of(&bend.along, cell, sides));
    }
    (0..2).find(|d| cell[*d] * bend.turn[*d] > limits.angle * (1.0 + thresholds::OVER_LIMIT) && room(d))
}

/// Whether a cell is sheared too far, by more than may be overlooked.
fn is_sheared(bend: &Bend, cell: [f64; 2], sides: [f64; 2], limits: &Limits, slack: f64) -> bool {
    bend.shear(cell) > (slack * SHEAR * sides[0].min(sides[1])).max(0.25 * limits.distance)
}

/// The direction that brings a sum of second-order terms down faster.
fn direction_of(terms: &[f64; 3], [h, k]: [f64; 2], sides: [f64; 2]) -> usize {
    let (a, b, c) = (terms[0] * h * h, terms[1] * h * k, terms[2] * k * k);
    if b > 2.0 * (a + c) { usize::from(sides[1] > sides[0]) } else { usize::from(c > a) }
}
