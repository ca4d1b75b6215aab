//! A curve as the reader of contacts sees it: a point for each parameter, and what is near.

use std::cell::Cell;

use super::thresholds::{LAST_STEP, SAME_PARAMETER};
use crate::curve::Piece;
use crate::{Interval, Point3, Vector3};

/// A curve's pieces by the whole curve's parameter.
#[derive(Clone, Copy)]
pub(super) struct Side<'a> {
    pub(super) pieces: &'a [Piece<'a>],
    pub(super) domain: Interval,
    pub(super) closed: bool,
    /// The parameters at which the curve turns back on itself, increasing.
    pub(super) turns: &'a [f64],
    /// How many places on the curves may still be looked at.
    pub(super) budget: &'a Cell<u64>,
}

impl<'a> Side<'a> {
    pub(super) fn new(
        pieces: &'a [Piece<'a>],
        turns: &'a [f64],
        domain: Interval,
        tolerance: f64,
        budget: &'a Cell<u64>,
    ) -> Self {
        Self { pieces, domain, closed: is_closed(pieces, tolerance), turns, budget }
    }

    /// Takes the cost of some places from the purse.
    pub(super) fn pay(&self, places: usize) {
        self.budget.set(self.budget.get().saturating_sub(places as u64));
    }

    /// Which of the stretches between turns holds a parameter.
    pub(super) fn stretch(&self, t: f64) -> usize {
        self.turns.partition_point(|x| *x <= t)
    }

    /// The stretch between turns (or ends of the curve) that holds the middle of a range.
    pub(super) fn stretch_around(&self, range: [f64; 2]) -> [f64; 2] {
        let k = self.stretch(0.5 * (range[0] + range[1]));
        let low = k.checked_sub(1).and_then(|k| self.turns.get(k)).copied().unwrap_or(self.domain.start);
        let high = self.turns.get(k).copied().unwrap_or(self.domain.end);
        [low, high]
    }

    /// A range with `reach` more at both ends, but not beyond an end of the curve or a turn.
    pub(super) fn widened(&self, range: [f64; 2], reach: f64) -> [f64; 2] {
        let [low, high] = self.stretch_around(range);
        [(range[0] - reach).max(low).min(range[0]), (range[1] + reach).min(high).max(range[1])]
    }

    /// The turns, at the ends of the stretch that holds a range, that are no further than `distance` from its ends.
    pub(super) fn turns_at(&self, range: [f64; 2], distance: f64) -> Vec<f64> {
        if self.turns.is_empty() {
            return Vec::new();
        }
        let ends = self.stretch_around(range).into_iter().zip(range);
        let inner = ends.filter(|(turn, _)| *turn != self.domain.start && *turn != self.domain.end);
        inner
            .filter(|&(turn, end)| self.point(turn).distance_to(self.point(end)) <= distance)
            .map(|(turn, _)| turn)
            .collect()
    }

    /// The turn within `reach` of a parameter.
    pub(super) fn turn_near(&self, t: f64, reach: f64) -> Option<f64> {
        let first = self.turns.partition_point(|x| *x < t - reach);
        self.turns.get(first).copied().filter(|x| *x <= t + reach)
    }

    fn piece(&self, t: f64) -> Option<&'a Piece<'a>> {
        let i = self.pieces.partition_point(|p| p.whole.end <= t).min(self.pieces.len().wrapping_sub(1));
        self.pieces.get(i)
    }

    pub(super) fn point(&self, t: f64) -> Point3 {
        self.pay(1);
        self.piece(t).map_or(Point3::ORIGIN, |p| p.point(p.own_parameter(t)))
    }

    /// Point, first and second derivative by the whole curve's parameter.
    pub(super) fn jet(&self, t: f64) -> [Vector3; 3] {
        self.pay(1);
        let Some(p) = self.piece(t) else { return [Vector3::ZERO; 3] };
        let [c, d1, d2] = p.jet(p.own_parameter(t));
        let speed = p.own.length() / p.whole.length();
        [c, d1 * speed, d2 * (speed * speed)]
    }

    /// The place between two parameters that is nearest to `q`, as far as a search from `t` shows it.
    pub(super) fn near(&self, q: Point3, range: [f64; 2], t: f64) -> f64 {
        let range = Interval::new(range[0], range[1]);
        let mut t = range.clamp(t);
        let mut best = (f64::INFINITY, t);
        for _ in 0..20 {
            let [p, d, _] = self.jet(t);
            let r = q.to_vector() - p;
            if r.length() > best.0 {
                // Too far, as where the curve stands still: half the way.
                if (t - best.1).abs() <= SAME_PARAMETER * self.domain.length() {
                    break;
                }
                t = 0.5 * (t + best.1);
                continue;
            }
            best = (r.length(), t);
            let next = range.clamp(t + r.dot(d) / d.length_squared());
            if !next.is_finite() {
                break;
            }
            if (next - t).abs() <= LAST_STEP * self.domain.length() {
                return next;
            }
            t = next;
        }
        best.1
    }

    /// The other parameter of the same point of a closed curve.
    pub(super) fn over_seam(&self, t: f64) -> Option<f64> {
        let d = self.domain;
        let epsilon = SAME_PARAMETER * d.length();
        match t {
            _ if !self.closed => None,
            t if t - d.start <= epsilon => Some(d.end),
            t if d.end - t <= epsilon => Some(d.start),
            _ => None,
        }
    }
}

/// Whether a curve ends within the tolerance of its start.
pub(super) fn is_closed(pieces: &[Piece<'_>], tolerance: f64) -> bool {
    match (pieces.first(), pieces.last()) {
        (Some(f), Some(l)) => f.start().distance_to(l.end()) <= tolerance,
        _ => false,
    }
}

/// The parameters in a range, or at most `reach` outside it, where pieces meet.
pub(super) fn joints(pieces: &[Piece<'_>], range: [f64; 2], reach: f64) -> Vec<f64> {
    let first = pieces.partition_point(|p| p.whole.start < range[0] - reach);
    let inner = pieces.get(first.max(1)..).unwrap_or(&[]).iter().map(|p| p.whole.start);
    inner.take_while(|&t| t <= range[1] + reach).collect()
}
