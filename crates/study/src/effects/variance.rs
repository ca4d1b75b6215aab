//! Shares of the output's variance: how much of it each input makes alone, and with others (Sobol 1993; first orders after Saltelli
//! et al. 2010, totals after Jansen 1999).

use crate::plan::sobol::{DIMENSIONS, Sobol};
use crate::random::{hashed, unit};
use crate::thresholds::{DEVIATIONS_95, RESAMPLES};

/// The share of an input in the output's variance, from 0 to 1 up to what chance does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Share {
    /// What it makes alone.
    pub alone: f64,
    /// How far `alone` may be off, with a confidence of 95 in 100.
    pub alone_confidence: f64,
    /// What it makes alone and together with others.
    pub total: f64,
    /// How far `total` may be off, with a confidence of 95 in 100.
    pub total_confidence: f64,
}

/// Pairs of points of the unit cube, and for each input the first of a pair with that input of the second.
#[derive(Debug)]
pub(super) struct Pairs {
    dimensions: usize,
    count: usize,
    sobol: Option<Sobol>,
    seed: u64,
}

impl Pairs {
    pub(super) fn new(dimensions: usize, count: usize, seed: u64) -> Self {
        // Both points of a pair are one point of the sequence in twice the dimensions, where it has so many.
        let sobol = (2 * dimensions <= DIMENSIONS).then(|| Sobol::new(2 * dimensions, seed.max(1)));
        Self { dimensions, count, sobol, seed }
    }

    /// All points: the two of a pair and the mixed ones, pair after pair.
    pub(super) fn points(&self) -> impl Iterator<Item = Vec<f64>> + '_ {
        (0..self.count as u64).flat_map(|k| {
            let both = match &self.sobol {
                Some(sobol) => sobol.point(k),
                None => (0..2 * self.dimensions as u64).map(|d| unit(hashed(self.seed, d, k))).collect(),
            };
            let (a, b) = both.split_at(self.dimensions);
            let mut all = vec![a.to_vec(), b.to_vec()];
            for input in 0..self.dimensions {
                let mut mixed = a.to_vec();
                if let (Some(slot), Some(x)) = (mixed.get_mut(input), b.get(input)) {
                    *slot = *x;
                }
                all.push(mixed);
            }
            all
        })
    }

    /// The shares of all inputs; `None` where the output does not change, or fewer than two pairs have all values.
    pub(super) fn shares(&self, values: &[Option<f64>]) -> Option<Vec<Share>> {
        let rows: Vec<Vec<f64>> =
            values.chunks(self.dimensions + 2).filter_map(|row| row.iter().copied().collect()).collect();
        let all: Vec<usize> = (0..rows.len()).collect();
        let found = estimate(&rows, &all, self.dimensions)?;
        let mut spread = vec![[0.0_f64; 2]; self.dimensions];
        let mut counted = 0.0;
        for turn in 0..RESAMPLES {
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                clippy::cast_precision_loss,
                reason = "a place in the rows"
            )]
            let drawn: Vec<usize> = (0..rows.len() as u64)
                .map(|k| (unit(hashed(self.seed ^ RESAMPLES, turn, k)) * rows.len() as f64) as usize)
                .collect();
            let Some(again) = estimate(&rows, &drawn, self.dimensions) else { continue };
            counted += 1.0;
            for ((spread, again), found) in spread.iter_mut().zip(again).zip(&found) {
                for k in 0..2 {
                    spread[k] += (again[k] - found[k]) * (again[k] - found[k]);
                }
            }
        }
        let shares = found.iter().zip(spread).map(|(share, spread)| {
            let [alone, total] = spread.map(|sum| DEVIATIONS_95 * (sum / f64::max(counted, 1.0)).sqrt());
            Share { alone: share[0], alone_confidence: alone, total: share[1], total_confidence: total }
        });
        Some(shares.collect())
    }
}

/// First order and total of each input from some rows: values at the two points of a pair and at the mixed ones.
#[allow(clippy::cast_precision_loss, reason = "there are fewer rows than 2^53")]
fn estimate(rows: &[Vec<f64>], chosen: &[usize], dimensions: usize) -> Option<Vec<[f64; 2]>> {
    let n = chosen.len() as f64;
    if chosen.len() < 2 {
        return None;
    }
    let chosen: Vec<&[f64]> = chosen.iter().filter_map(|at| rows.get(*at)).map(Vec::as_slice).collect();
    let pairs = || chosen.iter().filter_map(|row| row.first_chunk::<2>());
    let mean = pairs().map(|[a, b]| a + b).sum::<f64>() / (2.0 * n);
    let variance =
        pairs().map(|[a, b]| (a - mean) * (a - mean) + (b - mean) * (b - mean)).sum::<f64>() / (2.0 * n);
    let least = (f64::EPSILON * mean.abs()) * (f64::EPSILON * mean.abs());
    if !(variance > 64.0 * least && variance.is_finite()) {
        return None;
    }
    let of_input = |input: usize| {
        let mut sums = [0.0, 0.0];
        for row in &chosen {
            if let ([a, b, ..], Some(mixed)) = (row, row.get(input + 2)) {
                // Without their mean the products vary less.
                sums[0] += (b - mean) * (mixed - a);
                sums[1] += (a - mixed) * (a - mixed);
            }
        }
        [sums[0] / n / variance, sums[1] / (2.0 * n) / variance]
    };
    Some((0..dimensions).map(of_input).collect())
}
