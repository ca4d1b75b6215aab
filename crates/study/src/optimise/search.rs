//! What a method of optimisation is asked for and told.

use std::cmp::Ordering;
use std::f64::consts::TAU;

use katydid_elementary::Elementary;

use crate::random::{hashed, unit};

/// A point of the unit cube with what it is worth.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Scored {
    /// A number from 0 to 1 for each input.
    pub(super) place: Vec<f64>,
    /// What is to be small.
    pub(super) goals: Vec<f64>,
    /// By how much constraints are missed, all together; 0 where all hold, infinite where there is no result.
    pub(super) missed: f64,
}

/// A method that asks for points in batches, and is told what they are worth.
pub(super) trait Search: Send {
    /// The next points, numbers from 0 to 1.
    fn ask(&mut self) -> Vec<Vec<f64>>;
    /// What they are worth, in the order of the points.
    fn tell(&mut self, scored: Vec<Scored>);
}

/// What holds its constraints goes before what does not, and what misses them by less before what misses them by more (Deb 2000); of
/// what holds them, the smaller goal.
pub(super) fn order(a: &Scored, b: &Scored) -> Ordering {
    let goal = |scored: &Scored| scored.goals.first().copied().unwrap_or(f64::INFINITY);
    a.missed.total_cmp(&b.missed).then(goal(a).total_cmp(&goal(b)))
}

/// Random numbers one after another, the same for the same seed.
#[derive(Debug, Clone)]
pub(super) struct Random {
    seed: u64,
    drawn: u64,
}

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self { seed, drawn: 0 }
    }

    /// From 0 to 1, without 1.
    pub(super) fn unit(&mut self) -> f64 {
        self.drawn += 1;
        unit(hashed(self.seed, 0x6f70_7469, self.drawn))
    }

    /// A whole number below `n`, or 0.
    #[allow(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        clippy::cast_precision_loss,
        reason = "a place in a short list"
    )]
    pub(super) fn below(&mut self, n: usize) -> usize {
        ((self.unit() * n as f64) as usize).min(n.saturating_sub(1))
    }

    /// A number of the normal distribution, mean 0 and deviation 1 (Box, Muller 1958).
    pub(super) fn normal(&mut self) -> f64 {
        let (u, v) = (1.0 - self.unit(), self.unit());
        (-2.0 * u.logarithm()).sqrt() * (TAU * v).cosine()
    }
}
