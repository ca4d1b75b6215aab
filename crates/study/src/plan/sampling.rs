//! Points of a grid and of a Latin hypercube, each by its number alone.

use super::Axis;
use crate::Cell;
use crate::random::{hashed, unit};

/// Point `k` of a grid: the last input changes first.
pub(super) fn grid(lists: &[Vec<Cell>], mut k: u64) -> Vec<Cell> {
    let mut point = vec![Cell::Null; lists.len()];
    for (list, cell) in lists.iter().zip(&mut point).rev() {
        let n = list.len().max(1) as u64;
        let at = usize::try_from(k % n).unwrap_or(0);
        *cell = list.get(at).cloned().unwrap_or(Cell::Null);
        k /= n;
    }
    point
}

/// Numbers from 0 to 1 as values of the inputs: every value of a list, every step, and every part of a range as often.
#[allow(
    clippy::cast_precision_loss,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "small whole numbers"
)]
pub(crate) fn placed(axes: &[Axis], unit: &[f64]) -> Vec<Cell> {
    let place = |(axis, u): (&Axis, &f64)| match axis {
        Axis::Values(values) => {
            let at = (u * values.len() as f64) as usize;
            values.get(at.min(values.len().saturating_sub(1))).cloned().unwrap_or(Cell::Null)
        }
        Axis::Range([from, to]) => Cell::Number(from + (to - from) * u),
        Axis::Steps { from, step, count } => {
            let at = (u * *count as f64).floor().min(count.saturating_sub(1) as f64);
            Cell::Number(from + step * at)
        }
    };
    axes.iter().zip(unit).map(place).collect()
}

/// A Latin hypercube (McKay, Beckman, Conover 1979): for each input, each of n equal parts of 0 to 1 has one of n points, at a
/// random place in it. The permutations are computed, not stored.
#[derive(Debug, Clone)]
pub(super) struct LatinHypercube {
    dimensions: u64,
    count: u64,
    seed: u64,
}

impl LatinHypercube {
    pub(super) fn new(dimensions: usize, count: u64, seed: u64) -> Self {
        Self { dimensions: dimensions as u64, count, seed }
    }

    /// Point `k`, numbers from 0 to 1.
    #[allow(clippy::cast_precision_loss, reason = "counts are below 2^53")]
    pub(super) fn point(&self, k: u64) -> Vec<f64> {
        let place = |dimension: u64| {
            let key = hashed(self.seed, dimension, 0);
            let part = permuted(k, self.count, key) as f64;
            let u = (part + unit(hashed(self.seed, dimension, k + 1))) / self.count as f64;
            // Rounding may give 1.
            u.min(1.0 - f64::EPSILON)
        };
        (0..self.dimensions).map(place).collect()
    }
}

/// Where a permutation of 0 to `n - 1` sends `k`: a Feistel network on the next power of four, walked until it comes back below
/// `n` (Black, Rogaway 2002, "Ciphers with arbitrary finite domains").
fn permuted(k: u64, n: u64, key: u64) -> u64 {
    /// Rounds of the network; four are as good as random.
    const ROUNDS: u64 = 6;
    let bits = (64 - n.saturating_sub(1).leading_zeros()).div_ceil(2).max(1);
    let mask = (1_u64 << bits) - 1;
    let mut x = k;
    loop {
        let (mut left, mut right) = (x >> bits, x & mask);
        for round in 0..ROUNDS {
            (left, right) = (right, left ^ (hashed(key, round, right) & mask));
        }
        x = left << bits | right;
        if x < n {
            return x;
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn a_permutation_reaches_all(n in 1_u64..3000, key: u64) {
            let mut seen: Vec<u64> = (0..n).map(|k| permuted(k, n, key)).collect();
            seen.sort_unstable();
            prop_assert!(seen.into_iter().eq(0..n));
        }

        #[test]
        fn each_part_of_a_range_has_one_point(n in 1_u64..500, seed: u64) {
            let plan = LatinHypercube::new(3, n, seed);
            for dimension in 0..3 {
                let mut parts: Vec<u64> = (0..n).map(|k| (plan.point(k)[dimension] * n as f64).floor() as u64).collect();
                parts.sort_unstable();
                // A number at the very border of a part may round into its neighbour: never for these counts.
                prop_assert!(parts.into_iter().eq(0..n));
            }
        }
    }
}
