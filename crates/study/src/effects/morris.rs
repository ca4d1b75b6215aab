//! Screening: which inputs matter at all, with few solves (Morris 1991, "Factorial sampling plans for preliminary computational
//! experiments"; the mean of sizes after Campolongo, Cariboni, Saltelli 2007).

use crate::random::hashed;
use crate::thresholds::DEVIATIONS_95;

/// What changes of one input do to the output over the whole range.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Screening {
    /// The mean size of the output's change, for a change of the input over its whole range.
    pub size: f64,
    /// From `size` less this to `size` and this is where it lies with a confidence of 95 in 100.
    pub confidence: f64,
    /// The mean with its sign: nearer to 0 than `size` where the output goes both up and down.
    pub mean: f64,
    /// The standard deviation of the changes: large where the input acts together with others, or unevenly.
    pub deviation: f64,
}

/// Walks through a grid of four levels, each of which moves every input once, by two thirds of its range.
#[derive(Debug)]
pub(super) struct Walks {
    /// Points of the unit cube, so many and one more a walk.
    pub(super) points: Vec<Vec<f64>>,
    /// Which input each step of each walk moves, and by how much.
    steps: Vec<(usize, f64)>,
    dimensions: usize,
}

impl Walks {
    pub(super) fn new(dimensions: usize, count: usize, seed: u64) -> Self {
        const STEP: f64 = 2.0 / 3.0;
        let (mut points, mut steps) = (Vec::new(), Vec::new());
        for walk in 0..count as u64 {
            let random = |what: u64, input: usize| hashed(seed, 2 * walk + what, input as u64);
            let mut point: Vec<f64> = (0..dimensions)
                .map(|input| if random(0, input) & 1 == 0 { 0.0 } else { 1.0 / 3.0 })
                .collect();
            // Half of the inputs begin high and go down.
            let up: Vec<bool> = (0..dimensions).map(|input| random(0, input) >> 1 & 1 == 0).collect();
            for (x, up) in point.iter_mut().zip(&up) {
                *x += if *up { 0.0 } else { STEP };
            }
            let mut order: Vec<usize> = (0..dimensions).collect();
            order.sort_by_key(|input| random(1, *input));
            points.push(point.clone());
            for input in order {
                let step = if up.get(input) == Some(&true) { STEP } else { -STEP };
                if let Some(x) = point.get_mut(input) {
                    *x += step;
                }
                points.push(point.clone());
                steps.push((input, step));
            }
        }
        Self { points, steps, dimensions }
    }

    /// What the values at the points say of each input; `None` where fewer than two of its changes have both values.
    pub(super) fn screened(&self, values: &[Option<f64>]) -> Vec<Option<Screening>> {
        let mut effects = vec![Vec::new(); self.dimensions];
        let walks = values.chunks(self.dimensions + 1).zip(self.steps.chunks(self.dimensions.max(1)));
        for (values, steps) in walks {
            for (pair, (input, step)) in values.windows(2).zip(steps) {
                if let ([Some(a), Some(b)], Some(effects)) = (pair, effects.get_mut(*input)) {
                    effects.push((b - a) / step);
                }
            }
        }
        effects.iter().map(|effects| screening(effects)).collect()
    }
}

#[allow(clippy::cast_precision_loss, reason = "there are few walks")]
fn screening(effects: &[f64]) -> Option<Screening> {
    let n = effects.len() as f64;
    if effects.len() < 2 {
        return None;
    }
    let mean_of = |f: &dyn Fn(f64) -> f64| effects.iter().map(|x| f(*x)).sum::<f64>() / n;
    let deviation_of = |f: &dyn Fn(f64) -> f64| {
        let mean = mean_of(f);
        let squares: f64 = effects.iter().map(|x| (f(*x) - mean) * (f(*x) - mean)).sum();
        (squares / (n - 1.0)).sqrt()
    };
    Some(Screening {
        size: mean_of(&f64::abs),
        confidence: DEVIATIONS_95 * deviation_of(&f64::abs) / n.sqrt(),
        mean: mean_of(&|x| x),
        deviation: deviation_of(&|x| x),
    })
}
