//! CMA-ES: a cloud of points that learns the shape of what it goes down (Hansen 2016, "The CMA evolution strategy: a tutorial"), with
//! restarts in twice the number of points where a cloud has come to rest (Auger, Hansen 2005).

use katydid_elementary::Elementary;

use super::eigen::symmetric;
use super::search::{Random, Scored, Search, order};

/// The first deviation, of a range of 1: three of them reach over it.
const SIGMA: f64 = 0.3;
/// A cloud narrower than this part of the ranges has come to rest.
const NARROW: f64 = 1e-12;
/// So has one whose goals have differed by no more than this part for some time.
const FLAT: f64 = 1e-13;
/// A covariance whose axes differ by more has lost its shape to rounding.
const MOST_CONDITION: f64 = 1e14;
/// The most points that a cloud grows to.
const MOST_POINTS: usize = 4096;

/// The state of a search for the least of one goal.
#[derive(Debug, Clone)]
pub(super) struct Cma {
    n: usize,
    random: Random,
    size: usize,
    /// Weights of the better half of the points.
    weights: Vec<f64>,
    /// How many points the weights stand for.
    effective: f64,
    mean: Vec<f64>,
    sigma: f64,
    /// The covariance, row by row, and its axes.
    covariance: Vec<f64>,
    axes: Vec<f64>,
    lengths: Vec<f64>,
    path: Vec<f64>,
    path_sigma: Vec<f64>,
    generation: u32,
    /// The steps of the points that were asked for, before they are folded into the cube.
    steps: Vec<Vec<f64>>,
    /// The least goal of each generation since the cloud began.
    best: Vec<f64>,
}

impl Cma {
    /// A search from a place on; a number from 0 to 1 for each input.
    pub(super) fn new(start: Vec<f64>, seed: u64) -> Self {
        let n = start.len();
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "a small count"
        )]
        let size = 4 + (3.0 * (n as f64).logarithm()) as usize;
        let mut new = Self {
            n,
            random: Random::new(seed),
            size,
            weights: Vec::new(),
            effective: 1.0,
            mean: start.clone(),
            sigma: SIGMA,
            covariance: Vec::new(),
            axes: Vec::new(),
            lengths: Vec::new(),
            path: Vec::new(),
            path_sigma: Vec::new(),
            generation: 0,
            steps: Vec::new(),
            best: Vec::new(),
        };
        new.begin(start, size);
        new
    }

    #[allow(clippy::cast_precision_loss, reason = "small counts")]
    fn begin(&mut self, mean: Vec<f64>, size: usize) {
        let n = self.n;
        let half = size / 2;
        let raw: Vec<f64> =
            (1..=half).map(|k| ((size as f64 + 1.0) / 2.0).logarithm() - (k as f64).logarithm()).collect();
        let sum: f64 = raw.iter().sum();
        self.weights = raw.iter().map(|w| w / sum).collect();
        self.effective = 1.0 / self.weights.iter().map(|w| w * w).sum::<f64>();
        self.size = size;
        (self.mean, self.sigma) = (mean, SIGMA);
        self.covariance = (0..n * n).map(|k| if k / n == k % n { 1.0 } else { 0.0 }).collect();
        self.axes = self.covariance.clone();
        self.lengths = vec![1.0; n];
        (self.path, self.path_sigma) = (vec![0.0; n], vec![0.0; n]);
        (self.generation, self.best) = (0, Vec::new());
    }

    /// Whether the cloud has come to rest.
    fn rests(&self) -> bool {
        let longest = self.lengths.iter().fold(0.0, |most: f64, x| most.max(*x));
        let shortest = self.lengths.iter().fold(f64::INFINITY, |least: f64, x| least.min(*x));
        let wide = self.sigma * longest;
        if !(wide > NARROW && wide < 1e6) || longest > MOST_CONDITION.sqrt() * shortest {
            return true;
        }
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "a count"
        )]
        let span = 10 + (30.0 * self.n as f64 / self.size as f64).ceil() as usize;
        let Some(recent) = self.best.len().checked_sub(span).and_then(|from| self.best.get(from..)) else {
            return false;
        };
        let least = recent.iter().fold(f64::INFINITY, |least: f64, x| least.min(*x));
        let most = recent.iter().fold(f64::NEG_INFINITY, |most: f64, x| most.max(*x));
        // Where no point has a result the spread is no number.
        let spread = most - least;
        spread.is_nan() || spread <= FLAT * most.abs().max(least.abs())
    }

    /// Axes and lengths of the covariance.
    fn decompose(&mut self) {
        let (values, vectors) = symmetric(&self.covariance, self.n);
        self.lengths = values.iter().map(|x| x.max(0.0).sqrt()).collect();
        self.axes = vectors;
    }
}

/// A number folded into 0 to 1, as by mirrors at both ends.
fn folded(x: f64) -> f64 {
    let x = x.rem_euclid(2.0);
    if x > 1.0 { 2.0 - x } else { x }
}

impl Search for Cma {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        let n = self.n;
        self.steps = (0..self.size)
            .map(|_| {
                let z: Vec<f64> = self.lengths.iter().map(|length| length * self.random.normal()).collect();
                (0..n).map(|row| (0..n).map(|k| self.axes[row * n + k] * z[k]).sum()).collect()
            })
            .collect();
        let place =
            |step: &Vec<f64>| self.mean.iter().zip(step).map(|(m, y)| folded(m + self.sigma * y)).collect();
        self.steps.iter().map(place).collect()
    }

    #[allow(clippy::cast_precision_loss, reason = "small counts")]
    fn tell(&mut self, scored: Vec<Scored>) {
        let n = self.n;
        let size = n as f64;
        let mut ranks: Vec<usize> = (0..scored.len().min(self.steps.len())).collect();
        ranks.sort_by(|a, b| order(&scored[*a], &scored[*b]));
        let Some(first) = ranks.first() else { return };
        self.best.push(if scored[*first].missed == 0.0 {
            scored[*first].goals[0]
        } else {
            scored[*first].missed
        });
        let chosen: Vec<(f64, &Vec<f64>)> =
            self.weights.iter().copied().zip(ranks.iter().map(|at| &self.steps[*at])).collect();
        let step: Vec<f64> = (0..n).map(|k| chosen.iter().map(|(w, y)| w * y[k]).sum()).collect();
        for (m, y) in self.mean.iter_mut().zip(&step) {
            *m += self.sigma * y;
        }
        // The constants of table 1 of the tutorial.
        let mu = self.effective;
        let c_sigma = (mu + 2.0) / (size + mu + 5.0);
        let damping = 1.0 + 2.0 * f64::max(((mu - 1.0) / (size + 1.0)).sqrt() - 1.0, 0.0) + c_sigma;
        let c_path = (4.0 + mu / size) / (size + 4.0 + 2.0 * mu / size);
        let c_one = 2.0 / ((size + 1.3) * (size + 1.3) + mu);
        let c_mu = f64::min(1.0 - c_one, 2.0 * (mu - 2.0 + 1.0 / mu) / ((size + 2.0) * (size + 2.0) + mu));
        // The step without the shape of the cloud: through the inverse root of the covariance.
        let along: Vec<f64> = (0..n)
            .map(|k| {
                (0..n).map(|row| self.axes[row * n + k] * step[row]).sum::<f64>()
                    / self.lengths[k].max(1e-300)
            })
            .collect();
        let round: Vec<f64> =
            (0..n).map(|row| (0..n).map(|k| self.axes[row * n + k] * along[k]).sum()).collect();
        let gain = (c_sigma * (2.0 - c_sigma) * mu).sqrt();
        for (p, z) in self.path_sigma.iter_mut().zip(&round) {
            *p = (1.0 - c_sigma) * *p + gain * z;
        }
        let length = self.path_sigma.iter().map(|x| x * x).sum::<f64>().sqrt();
        let expected = size.sqrt() * (1.0 - 1.0 / (4.0 * size) + 1.0 / (21.0 * size * size));
        self.generation += 1;
        let settled = 1.0 - (1.0 - c_sigma).raised_to(2.0 * f64::from(self.generation));
        let is_short = length / settled.sqrt() < (1.4 + 2.0 / (size + 1.0)) * expected;
        let gain = if is_short { (c_path * (2.0 - c_path) * mu).sqrt() } else { 0.0 };
        for (p, y) in self.path.iter_mut().zip(&step) {
            *p = (1.0 - c_path) * *p + gain * y;
        }
        let lost = if is_short { 0.0 } else { c_one * c_path * (2.0 - c_path) };
        for row in 0..n {
            for k in 0..n {
                let many: f64 = chosen.iter().map(|(w, y)| w * y[row] * y[k]).sum();
                let c = &mut self.covariance[row * n + k];
                *c = (1.0 - c_one - c_mu + lost) * *c + c_one * self.path[row] * self.path[k] + c_mu * many;
            }
        }
        self.sigma *= ((c_sigma / damping) * (length / expected - 1.0)).min(1.0).exponential();
        self.decompose();
        if self.rests() {
            let mean = (0..n).map(|_| self.random.unit()).collect();
            self.begin(mean, (2 * self.size).min(MOST_POINTS));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn least(f: impl Fn(&[f64]) -> f64, n: usize, evaluations: usize, seed: u64) -> f64 {
        let mut cma = Cma::new(vec![0.5; n], seed);
        let (mut best, mut done) = (f64::INFINITY, 0);
        while done < evaluations {
            let places = cma.ask();
            done += places.len();
            let scored: Vec<Scored> = places
                .into_iter()
                .map(|place| Scored { goals: vec![f(&place)], missed: 0.0, place })
                .collect();
            best = scored.iter().fold(best, |best, s| best.min(s.goals[0]));
            cma.tell(scored);
        }
        best
    }

    #[test]
    fn the_least_of_known_functions_is_found() {
        // Rosenbrock's function on [-2, 2], whose least is 0 at 1, 1, …
        let rosenbrock = |u: &[f64]| -> f64 {
            let x: Vec<f64> = u.iter().map(|u| 4.0 * u - 2.0).collect();
            x.windows(2)
                .map(|w| 100.0 * (w[1] - w[0] * w[0]) * (w[1] - w[0] * w[0]) + (1.0 - w[0]) * (1.0 - w[0]))
                .sum()
        };
        let ellipsoid = |u: &[f64]| -> f64 {
            u.iter().enumerate().map(|(k, u)| 10.0_f64.raised_to(k as f64) * (u - 0.3) * (u - 0.3)).sum()
        };
        // The least lies in a corner of the cube.
        let corner = |u: &[f64]| -> f64 { u.iter().sum() };
        for seed in 1..6 {
            assert!(least(rosenbrock, 5, 6000, seed) < 1e-8, "{seed}");
            assert!(least(ellipsoid, 6, 4000, seed) < 1e-8, "{seed}");
            assert!(least(corner, 4, 4000, seed) < 1e-6, "{seed}");
        }
    }
}
