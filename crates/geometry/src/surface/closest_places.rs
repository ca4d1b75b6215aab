//! Ranges of a surface's parameters, of which those that touch are one place: directly, over a seam or at a pole.

use crate::{Direction, Interval, NurbsSurface, Side};

/// A range in which a minimum of the distance was found.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
    /// The parameters that stand for the range.
    pub(super) at: [f64; 2],
    /// The squared distance there, and what rounding may do to it.
    pub(super) squared: f64,
    pub(super) noise: f64,
    /// Ranges no further apart than this touch.
    pub(super) epsilon: [f64; 2],
}

/// How a surface's parameters hang together.
#[derive(Debug, Clone, Copy)]
pub(super) struct Domain {
    pub(super) ranges: [Interval; 2],
    /// Whether the surface meets itself where a parameter ends.
    pub(super) closed: [bool; 2],
    /// Whether the side where a parameter starts, and that where it ends, is a single point.
    pub(super) singular: [[bool; 2]; 2],
}

impl Domain {
    pub(super) fn of(surface: &NurbsSurface) -> Self {
        let sides = [[Side::West, Side::East], [Side::South, Side::North]];
        Self {
            ranges: Direction::BOTH.map(|d| surface.domain(d)),
            closed: Direction::BOTH.map(|d| surface.is_closed(d)),
            singular: sides.map(|pair| pair.map(|side| surface.is_singular(side))),
        }
    }

    fn touch(&self, a: &Place, b: &Place) -> bool {
        let epsilon: [f64; 2] = std::array::from_fn(|d| a.epsilon[d].max(b.epsilon[d]));
        let meet = |d: usize, shift: f64| {
            a.low[d] + shift <= b.high[d] + epsilon[d] && b.low[d] <= a.high[d] + shift + epsilon[d]
        };
        let along = |d: usize| {
            let turn = self.ranges[d].length();
            meet(d, 0.0) || (self.closed[d] && (meet(d, turn) || meet(d, -turn)))
        };
        let at_pole = |d: usize, end: usize| {
            let Interval { start, end: last } = self.ranges[d];
            let there = |p: &Place| match end {
                0 => p.low[d] <= start + epsilon[d],
                _ => p.high[d] >= last - epsilon[d],
            };
            self.singular[d][end] && there(a) && there(b)
        };
        (along(0) && along(1)) || (0..2).any(|d| at_pole(d, 0) || at_pole(d, 1))
    }

    /// One place for all that touch each other: the nearest, of equally near ones that with the least parameters.
    pub(super) fn distinct(&self, places: &[Place]) -> Vec<Place> {
        let mut free: Vec<Place> = places.to_vec();
        let mut out = Vec::new();
        while let Some(seed) = free.pop() {
            let mut group = vec![seed];
            let mut next = 0;
            while let Some(&member) = group.get(next) {
                next += 1;
                let mut i = 0;
                while i < free.len() {
                    if self.touch(&member, &free[i]) {
                        group.push(free.swap_remove(i));
                    } else {
                        i += 1;
                    }
                }
            }
            let least = group.iter().map(|p| p.squared + p.noise).fold(f64::INFINITY, f64::min);
            let equal = group.into_iter().filter(|p| p.squared <= least);
            out.extend(equal.min_by(|a, b| a.at[0].total_cmp(&b.at[0]).then(a.at[1].total_cmp(&b.at[1]))));
        }
        out
    }
}
