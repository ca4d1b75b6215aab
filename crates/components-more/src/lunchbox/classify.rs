//! LunchBox Machine Learning: mixtures of normal distributions, and the logistic curve.

use katydid_component::{Context, Message, component};
use katydid_data::{Path, Tree, TreeBuilder, Value};
use katydid_elementary::Elementary;

use super::learn::{clusters, dot, observations, whole};

/// The most rounds of a mixture; it ends before, when the likelihood no longer grows.
const ROUNDS: usize = 500;
/// A likelihood that grows by a smaller part of itself has come to rest.
const REST: f64 = 1e-12;
/// The least spread of a part, in parts of the spread of all: points of one place have none.
const LEAST_SPREAD: f64 = 1e-9;
/// The most numbers in an observation.
const MOST_NUMBERS: usize = 200;

/// The lower triangle L of a matrix L Lᵀ, row by row (A.-L. Cholesky). None where the matrix is not positive definite.
fn triangle(matrix: &[Vec<f64>]) -> Option<Vec<Vec<f64>>> {
    let mut rows: Vec<Vec<f64>> = Vec::with_capacity(matrix.len());
    for (i, source) in matrix.iter().enumerate() {
        let mut row: Vec<f64> = Vec::with_capacity(i + 1);
        for (j, value) in source.iter().take(i + 1).enumerate() {
            let left = if j == i {
                let left = value - dot(&row, &row);
                if !(left > 0.0 && left.is_finite()) {
                    return None;
                }
                left.sqrt()
            } else {
                let other = rows.get(j)?;
                (value - dot(&row, other)) / other.last()?
            };
            row.push(left);
        }
        rows.push(row);
    }
    Some(rows)
}

/// What L carries to some numbers.
fn forward(rows: &[Vec<f64>], numbers: &[f64]) -> Vec<f64> {
    let mut solved: Vec<f64> = Vec::with_capacity(rows.len());
    for (row, number) in rows.iter().zip(numbers) {
        let left = number - dot(row, &solved);
        solved.push(left / row.last().copied().unwrap_or(1.0));
    }
    solved
}

/// What L Lᵀ carries to some numbers.
fn solved(rows: &[Vec<f64>], numbers: &[f64]) -> Vec<f64> {
    let mut values = forward(rows, numbers);
    for (k, row) in rows.iter().enumerate().rev() {
        let Some((diagonal, before)) = row.split_last() else { continue };
        let value = values.get(k).copied().unwrap_or(0.0) / diagonal;
        values.iter_mut().zip(before).for_each(|(x, part)| *x -= value * part);
        if let Some(slot) = values.get_mut(k) {
            *slot = value;
        }
    }
    values
}

/// A normal distribution with its share of a mixture.
struct Normal {
    share: f64,
    mean: Vec<f64>,
    /// The triangle of its covariances.
    spread: Vec<Vec<f64>>,
}

impl Normal {
    /// The distribution of observations that count by weights.
    fn of(rows: &[Vec<f64>], weights: &[f64], floor: f64) -> Result<Self, Message> {
        let total: f64 = weights.iter().sum();
        let width = rows.first().map_or(0, Vec::len);
        let mut mean = vec![0.0; width];
        for (row, weight) in rows.iter().zip(weights) {
            mean.iter_mut().zip(row).for_each(|(sum, x)| *sum += weight * x / total);
        }
        let mut matrix = vec![vec![0.0; width]; width];
        for (row, weight) in rows.iter().zip(weights) {
            let away: Vec<f64> = row.iter().zip(&mean).map(|(x, middle)| x - middle).collect();
            for (line, x) in matrix.iter_mut().zip(&away) {
                line.iter_mut().zip(&away).for_each(|(sum, y)| *sum += weight * x * y / total);
            }
        }
        for (k, line) in matrix.iter_mut().enumerate() {
            if let Some(variance) = line.get_mut(k) {
                *variance += floor;
            }
        }
        let spread =
            triangle(&matrix).ok_or_else(|| Message::error("A cluster has lost its observations"))?;
        Ok(Self { share: total / rows.len() as f64, mean, spread })
    }

    /// The logarithm of its share times its density at an observation.
    fn logarithm(&self, row: &[f64]) -> f64 {
        let away: Vec<f64> = row.iter().zip(&self.mean).map(|(x, middle)| x - middle).collect();
        let reduced = forward(&self.spread, &away);
        let size: f64 = self.spread.iter().filter_map(|line| line.last()).map(|x| x.logarithm()).sum();
        let constant = 0.5 * row.len() as f64 * std::f64::consts::TAU.logarithm();
        self.share.logarithm() - constant - size - 0.5 * dot(&reduced, &reduced)
    }
}

/// The logarithm of a sum of which the logarithms are known.
fn sum_of(logarithms: &[f64]) -> f64 {
    let most = logarithms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    most + logarithms.iter().map(|x| (x - most).exponential()).sum::<f64>().logarithm()
}

/// The mean variance of all numbers.
fn variance(rows: &[Vec<f64>]) -> f64 {
    let width = rows.first().map_or(0, Vec::len);
    let all = |k: usize| rows.iter().filter_map(move |row| row.get(k).copied());
    let of = |k: usize| {
        let mean = all(k).sum::<f64>() / rows.len() as f64;
        all(k).map(|x| (x - mean) * (x - mean)).sum::<f64>() / rows.len() as f64
    };
    (0..width).map(of).sum::<f64>() / width as f64
}

/// Sorts observations into clusters that are normal distributions of any direction: the mixture under which the observations are
/// likeliest, found step by step from clusters of k-means (A. Dempster, N. Laird and D. Rubin, 1977). Stands for LunchBox's Gaussian
/// Mixture; the chance is our own, so that clusters have other numbers for the same seed. That each branch is an observation, or each
/// number where there is one branch, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1ca4",
    name = "Gaussian Mixture",
    nick = "GaussianMix",
    at = "LunchBox/Machine Learning"
)]
#[output("Result", "Result", "For each observation the number of its likeliest cluster, from 0.", kind = Integer)]
#[output(
    "Likelihood",
    "Likelihood",
    "For each the logarithm of the cluster's share times its density there.",
    kind = Number
)]
#[output("Probability", "Probability", "A branch for each: how likely each cluster is, 1 in all.", kind = Number)]
fn gaussian_mixture(
    context: &Context<'_>,
    /// The observations: a branch each, or a list of numbers.
    #[port("Training Inputs", "Inputs", kind = Number)]
    inputs: &Tree,
    /// The number of clusters, at least 1.
    #[port("Components", "Components", kind = Integer, optional)]
    count: &Tree,
    /// The seed.
    #[port("Random Seed", "seed", kind = Integer, optional)]
    seed: &Tree,
) -> Result<(Tree, Tree, Tree), Message> {
    let rows = observations(inputs, "Inputs")?;
    if rows.first().is_some_and(|row| row.len() > MOST_NUMBERS) {
        return Err(Message::error(format!("An observation has more than {MOST_NUMBERS} numbers")));
    }
    let (labels, centers) = clusters(context, &rows, whole(count, 3), whole(seed, 1))?;
    context.items(rows.len().saturating_mul(centers.len().saturating_add(2)))?;
    let floor = LEAST_SPREAD * variance(&rows);
    if !(floor > 0.0 && floor.is_finite()) {
        return Err(Message::error("The observations are all the same"));
    }
    // How far each observation belongs to each cluster: at first as k-means has it.
    let belongs = |k: usize| labels.iter().map(|label| f64::from(u8::from(*label == k))).collect();
    let mut weights: Vec<Vec<f64>> = (0..centers.len()).map(belongs).collect();
    let mut before = f64::NEG_INFINITY;
    let mut found: Vec<Vec<f64>> = Vec::new();
    for _ in 0..ROUNDS {
        context.check()?;
        let parts = weights.iter().map(|weights| Normal::of(&rows, weights, floor));
        let parts: Vec<Normal> = parts.collect::<Result<_, Message>>()?;
        found = rows.iter().map(|row| parts.iter().map(|part| part.logarithm(row)).collect()).collect();
        let totals: Vec<f64> = found.iter().map(|logarithms| sum_of(logarithms)).collect();
        let likelihood: f64 = totals.iter().sum();
        for (k, weights) in weights.iter_mut().enumerate() {
            for ((weight, logarithms), total) in weights.iter_mut().zip(&found).zip(&totals) {
                *weight = logarithms.get(k).map_or(0.0, |x| (x - total).exponential());
            }
        }
        if !(likelihood - before > REST * likelihood.abs()) {
            break;
        }
        before = likelihood;
    }
    let best = |logarithms: &Vec<f64>| {
        let all = logarithms.iter().copied().enumerate();
        all.fold((0, f64::NEG_INFINITY), |best, (k, x)| if x > best.1 { (k, x) } else { best })
    };
    let chosen: Vec<(usize, f64)> = found.iter().map(best).collect();
    let mut shares = TreeBuilder::<f64>::new();
    for (row, path) in (0..rows.len()).zip(0..) {
        shares.branch(Path::from([path]));
        weights.iter().for_each(|weights| shares.push(weights.get(row).copied()));
    }
    let numbers = chosen.iter().map(|(k, _)| i32::try_from(*k).unwrap_or(i32::MAX)).collect();
    let logarithms = chosen.iter().map(|(_, x)| *x).collect();
    Ok((Tree::list::<i32>(numbers), Tree::list::<f64>(logarithms), shares.finish()))
}

/// The logistic curve.
fn logistic(x: f64) -> f64 {
    // Of the two forms the one whose power is small.
    if x < 0.0 { x.exponential() / (1.0 + x.exponential()) } else { 1.0 / (1.0 + (-x).exponential()) }
}

/// The constant and the factors under which outputs are likeliest, by the method of Newton.
fn fitted(
    context: &Context<'_>,
    rows: &[Vec<f64>],
    outputs: &[bool],
    tolerance: f64,
    rounds: i32,
    penalty: f64,
) -> Result<Vec<f64>, Message> {
    let width = rows.first().map_or(0, Vec::len);
    let mut factors = vec![0.0; width];
    for _ in 0..rounds.max(0) {
        context.check()?;
        let mut slope: Vec<f64> = factors.iter().map(|x| -penalty * x).collect();
        let mut matrix = vec![vec![0.0; width]; width];
        for (k, line) in matrix.iter_mut().enumerate() {
            if let Some(own) = line.get_mut(k) {
                *own = penalty;
            }
        }
        // The constant bears no penalty.
        slope.iter_mut().take(1).for_each(|x| *x = 0.0);
        matrix.iter_mut().take(1).flatten().take(1).for_each(|x| *x = 0.0);
        for (row, output) in rows.iter().zip(outputs) {
            let score = logistic(dot(&factors, row));
            let left = f64::from(u8::from(*output)) - score;
            slope.iter_mut().zip(row).for_each(|(sum, x)| *sum += left * x);
            let weight = score * (1.0 - score);
            for (line, x) in matrix.iter_mut().zip(row) {
                line.iter_mut().zip(row).for_each(|(sum, y)| *sum += weight * x * y);
            }
        }
        let Some(rows) = triangle(&matrix) else {
            context.warn(
                "The outputs are told apart wholly, or an input depends on others: give a regularization",
            );
            break;
        };
        let step = solved(&rows, &slope);
        factors.iter_mut().zip(&step).for_each(|(x, step)| *x += step);
        if step.iter().all(|step| step.abs() <= tolerance) {
            break;
        }
    }
    Ok(factors)
}

/// How likely an output is true, as a logistic curve over sums of multiples of inputs: the curve under which the known outputs are
/// likeliest. Stands for LunchBox's Logistic Regression; that each branch is an observation, or each number where there is one branch,
/// and that the regularization takes half of it times the squares of the factors off the logarithm of the likelihood, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1ca5",
    name = "Logistic Regression",
    nick = "LogReg",
    at = "LunchBox/Machine Learning"
)]
#[output("Result", "Result", "For each wanted input whether true is likelier than false.", kind = Boolean)]
#[output("Score", "Score", "For each how likely true is, from 0 to 1.", kind = Number)]
fn logistic_regression(
    context: &Context<'_>,
    /// Inputs for which outputs are wanted: a branch each, or a list of numbers.
    #[port("Test Data", "Test", kind = Number)]
    test: &Tree,
    /// The inputs of the observations: a branch each, or a list of numbers.
    #[port("Training Inputs", "Inputs", kind = Number)]
    inputs: &Tree,
    /// The output of each.
    #[port("Training Output", "Output", kind = Boolean)]
    outputs: &Tree,
    /// It ends when no factor moves by more.
    #[port("Tolerance", "Tol", default = 1e-9)]
    tolerance: f64,
    /// The most rounds.
    #[port("Maximum Iterations", "MaxIter", default = 100)]
    rounds: i32,
    /// How much large factors are held back, 0 for not at all.
    #[port("Regularization Value", "Regular", default = 1e-6)]
    penalty: f64,
    /// A seed; the method of Newton needs no chance.
    #[port("Random Seed", "seed", default = 1)]
    _seed: i32,
) -> Result<(Tree, Tree), Message> {
    let inputs = observations(inputs, "Inputs")?;
    let width = inputs.first().map_or(0, Vec::len);
    let truth = |at: usize| match outputs.column().get(at) {
        Some(Value::Boolean(truth)) => Ok(truth),
        _ => Err(Message::error("An output is missing")),
    };
    let truths = (0..outputs.item_count()).map(truth).collect::<Result<Vec<bool>, Message>>()?;
    if truths.len() != inputs.len() {
        let (n, m) = (inputs.len(), truths.len());
        return Err(Message::error(format!("There are {n} inputs and {m} outputs")));
    }
    let mut test = observations(test, "Test")?;
    if width > 1 && test.iter().all(|row| row.len() == 1) {
        test = vec![test.concat()];
    }
    if test.iter().any(|row| row.len() != width) || width > MOST_NUMBERS {
        return Err(Message::error(format!(
            "Test: a branch must have {width} numbers, as the inputs have, and no more than {MOST_NUMBERS}"
        )));
    }
    if !(penalty >= 0.0 && penalty.is_finite() && tolerance >= 0.0) {
        return Err(Message::error("The tolerance and the regularization must be at least 0"));
    }
    context.items(test.len().saturating_mul(2))?;
    let with_constant = |row: &Vec<f64>| [&[1.0], row.as_slice()].concat();
    let rows: Vec<Vec<f64>> = inputs.iter().map(with_constant).collect();
    let factors = fitted(context, &rows, &truths, tolerance, rounds, penalty)?;
    let scores: Vec<f64> = test.iter().map(|row| logistic(dot(&factors, &with_constant(row)))).collect();
    let results = scores.iter().map(|score| *score > 0.5).collect();
    Ok((Tree::list::<bool>(results), Tree::list::<f64>(scores)))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Tree, Value};

    fn numbers(tree: &Tree) -> Vec<f64> {
        let of = |at| match tree.column().get(at) {
            Some(Value::Number(x)) => x,
            other => panic!("{other:?}"),
        };
        (0..tree.item_count()).map(of).collect()
    }

    fn near(a: f64, b: f64, room: f64) {
        assert!((a - b).abs() <= room, "{a} {b}");
    }

    #[test]
    fn one_cluster_is_a_normal_distribution() {
        let out = Trial::of("Gaussian Mixture").list([-1.0, 1.0, -1.0, 1.0]).item(1).run().outputs;
        // The mean is 0 and the variance 1.
        let wanted = -0.5 * std::f64::consts::TAU.ln() - 0.5;
        numbers(&out[1]).into_iter().for_each(|x| near(x, wanted, 1e-8));
        numbers(&out[2]).into_iter().for_each(|x| near(x, 1.0, 1e-12));
    }

    #[test]
    fn clusters_that_lie_apart() {
        let places = [0.0, 0.1, 0.2, 10.0, 10.1, 10.2];
        let out = Trial::of("Gaussian Mixture").list(places).item(2).run().outputs;
        let label = |at| out[0].column().get(at).unwrap();
        assert!((0..3).all(|k| label(k) == label(0) && label(k + 3) == label(3)) && label(0) != label(3));
        assert_eq!(out[2].branch_count(), 6);
        // Half of all, with the variance 0.02 / 3.
        let variance: f64 = 0.02 / 3.0;
        let wanted = 0.5_f64.ln() - 0.5 * (std::f64::consts::TAU * variance).ln();
        near(numbers(&out[1])[1], wanted, 1e-5);
    }

    #[test]
    fn mixtures_that_cannot_be() {
        let trial = |count: i32| Trial::of("Gaussian Mixture").list([1.0, 1.0, 1.0]).item(count);
        assert_eq!(trial(1).message(), "The observations are all the same");
        assert_eq!(trial(4).message(), "4 clusters of 3 observations cannot be");
        assert_eq!(trial(0).message(), "0 clusters of 3 observations cannot be");
        assert!(Trial::of("Gaussian Mixture").list([f64::NAN]).item(1).message().contains("finite"));
    }

    #[test]
    fn shares_of_two_groups() {
        // Of four zeros one is true, of four ones three.
        let inputs = [0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 1.0];
        let outputs = [true, false, false, false, true, true, true, false];
        let trial = Trial::of("Logistic Regression").list([0.0, 1.0, 0.5]).list(inputs).list(outputs);
        let out = trial.default().default().item(0.0).run();
        assert!(out.messages.is_empty(), "{:?}", out.messages);
        let scores = numbers(&out.outputs[1]);
        [0.25, 0.75, 0.5].iter().zip(&scores).for_each(|(wanted, score)| near(*score, *wanted, 1e-12));
        assert_eq!(out.outputs[0].column().get(0), Some(Value::Boolean(false)));
        assert_eq!(out.outputs[0].column().get(1), Some(Value::Boolean(true)));
    }

    #[test]
    fn groups_that_are_told_apart_wholly() {
        let trial = |penalty: f64| {
            let trial = Trial::of("Logistic Regression").list([-9.0, 9.0]).list([-2.0, -1.0, 1.0, 2.0]);
            trial.list([false, false, true, true]).default().default().item(penalty)
        };
        let out = trial(0.1).run();
        assert!(out.messages.is_empty(), "{:?}", out.messages);
        let scores = numbers(&out.outputs[1]);
        assert!(scores[0] < 0.01 && scores[1] > 0.99, "{scores:?}");
        let scores = numbers(&trial(0.0).run().outputs[1]);
        assert!(scores[0] < 1e-6 && scores[1] > 1.0 - 1e-6, "{scores:?}");
        assert!(trial(-1.0).message().contains("at least 0"));
        let uneven = Trial::of("Logistic Regression").list([0.0]).list([1.0, 2.0]).list([true]);
        assert_eq!(uneven.message(), "There are 2 inputs and 1 outputs");
    }
}
