//! LunchBox Machine Learning: what is exact or soon done: least squares and k-means.

use katydid_component::{Context, List, Message, component};
use katydid_data::{Path, Tree, TreeBuilder, Value};

use super::lists::Chance;

/// The most columns of a system of least squares.
const MOST_COLUMNS: usize = 500;
/// The most rounds of k-means; it ends long before, when no observation changes its cluster.
const ROUNDS: usize = 300;
/// A column that is this small a part of what it was, once those before it are taken out, depends on them.
const DEPENDENT: f64 = 1e-10;

/// The observations of a tree: a branch each; numbers of a single branch are observations of their own.
///
/// # Errors
/// An item is no finite number, or branches differ in length.
pub(super) fn observations(tree: &Tree, what: &str) -> Result<Vec<Vec<f64>>, Message> {
    let mut rows: Vec<Vec<f64>> = Vec::with_capacity(tree.branch_count());
    for branch in tree.branches() {
        let numbers = branch.iter().map(|item| match item {
            Some(Value::Number(x)) if x.is_finite() => Ok(x),
            _ => Err(Message::error(format!("{what}: an item is not a finite number"))),
        });
        rows.push(numbers.collect::<Result<_, _>>()?);
    }
    if let [only] = rows.as_slice() {
        rows = only.iter().map(|x| vec![*x]).collect();
    }
    let width = rows.first().map_or(0, Vec::len);
    if width == 0 || rows.iter().any(|row| row.len() != width) {
        return Err(Message::error(format!("{what}: branches are empty, or of different lengths")));
    }
    Ok(rows)
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// The columns of least squares made orthonormal one after the other (the modified method of Gram and Schmidt; Å. Björck,
/// *Numerical Methods for Least Squares Problems*, 1996, 2.4).
struct Fit {
    /// The orthonormal columns.
    q: Vec<Vec<f64>>,
    /// The upper triangle by its columns.
    r: Vec<Vec<f64>>,
}

impl Fit {
    /// For observations and a constant.
    ///
    /// # Errors
    /// There are too many inputs, or one of them depends on the others.
    fn new(context: &Context<'_>, inputs: &[Vec<f64>]) -> Result<Self, Message> {
        let width = inputs.first().map_or(0, Vec::len) + 1;
        if width > MOST_COLUMNS {
            return Err(Message::error(format!("There are more than {MOST_COLUMNS} inputs")));
        }
        context.bytes(inputs.len().saturating_mul(width).saturating_mul(16))?;
        let mut fit = Self { q: Vec::new(), r: Vec::new() };
        for k in 0..width {
            context.check()?;
            // The constant comes first.
            let mut column: Vec<f64> = match k.checked_sub(1) {
                None => vec![1.0; inputs.len()],
                Some(at) => inputs.iter().filter_map(|row| row.get(at).copied()).collect(),
            };
            let size = dot(&column, &column).sqrt();
            let mut parts = Vec::with_capacity(k + 1);
            for q in &fit.q {
                let part = dot(q, &column);
                column.iter_mut().zip(q).for_each(|(x, y)| *x -= part * y);
                parts.push(part);
            }
            let left = dot(&column, &column).sqrt();
            if !(left > DEPENDENT * size) {
                let name = if k == 0 {
                    "There are no observations".to_owned()
                } else {
                    format!("Input {} depends on those before it, or there are too few observations", k - 1)
                };
                return Err(Message::error(name));
            }
            column.iter_mut().for_each(|x| *x /= left);
            parts.push(left);
            fit.q.push(column);
            fit.r.push(parts);
        }
        Ok(fit)
    }

    /// The constant and the factors whose sums are nearest to outputs.
    fn solve(&self, outputs: &[f64]) -> Vec<f64> {
        let mut left = outputs.to_vec();
        let mut right: Vec<f64> = Vec::with_capacity(self.q.len());
        for q in &self.q {
            let part = dot(q, &left);
            left.iter_mut().zip(q).for_each(|(x, y)| *x -= part * y);
            right.push(part);
        }
        for (k, column) in self.r.iter().enumerate().rev() {
            let Some((diagonal, above)) = column.split_last() else { continue };
            let value = right.get(k).copied().unwrap_or(0.0) / diagonal;
            right.iter_mut().zip(above).for_each(|(x, part)| *x -= value * part);
            if let Some(slot) = right.get_mut(k) {
                *slot = value;
            }
        }
        right
    }
}

/// The constant and the factors at an observation.
fn predicted(factors: &[f64], row: &[f64]) -> f64 {
    factors.split_first().map_or(0.0, |(constant, factors)| constant + dot(factors, row))
}

/// The straight line nearest to numbers over others, in the sense of least squares, at wanted places. Stands for LunchBox's Linear
/// Regression.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1ca1",
    name = "Linear Regression",
    nick = "LineReg",
    at = "LunchBox/Machine Learning"
)]
#[output("Result", "Result", "The values of the line at the test data.")]
fn linear_regression(
    context: &Context<'_>,
    /// Where values are wanted.
    #[port("Test Data", "Test")]
    test: List<f64>,
    /// The places.
    #[port("Training Inputs", "Inputs")]
    inputs: List<f64>,
    /// The values there, as many.
    #[port("Training Output", "Output")]
    outputs: List<f64>,
    /// A seed; least squares need no chance.
    #[port("Random Seed", "seed", default = 1)]
    _seed: i32,
) -> Result<Vec<f64>, Message> {
    let (inputs, outputs): (Vec<f64>, Vec<f64>) = (inputs.present().collect(), outputs.present().collect());
    if inputs.len() != outputs.len() || inputs.iter().chain(&outputs).any(|x| !x.is_finite()) {
        return Err(Message::error("Inputs and outputs differ in number, or are not all finite"));
    }
    context.items(test.len())?;
    let rows: Vec<Vec<f64>> = inputs.iter().map(|x| vec![*x]).collect();
    let factors = Fit::new(context, &rows)?.solve(&outputs);
    Ok(test.present().map(|x| predicted(&factors, &[x])).collect())
}

/// The sums of multiples of inputs, and a constant, nearest to outputs in the sense of least squares, at wanted inputs. Stands for
/// LunchBox's Multivariate Linear Regression; that each branch is an observation is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1ca2",
    name = "Multivariate Linear Regression",
    nick = "MultiLineReg",
    at = "LunchBox/Machine Learning"
)]
#[output("Result", "Result", "A branch for each wanted input: the outputs there.", kind = Number)]
fn multivariate_regression(
    context: &Context<'_>,
    /// Inputs for which outputs are wanted: a branch each.
    #[port("Test Data", "Test", kind = Number)]
    test: &Tree,
    /// The inputs of the observations: a branch each.
    #[port("Inputs", "Inputs", kind = Number)]
    inputs: &Tree,
    /// Their outputs: a branch each, or a list with one for each.
    #[port("Output", "Output", kind = Number)]
    outputs: &Tree,
    /// A seed; least squares need no chance.
    #[port("Random Seed", "seed", kind = Integer, optional)]
    _seed: &Tree,
) -> Result<Tree, Message> {
    let inputs = observations(inputs, "Inputs")?;
    let outputs = observations(outputs, "Output")?;
    let width = inputs.first().map_or(0, Vec::len);
    // A single branch is one observation where several numbers make one.
    let mut test = observations(test, "Test")?;
    if width > 1 && test.iter().all(|row| row.len() == 1) {
        test = vec![test.concat()];
    }
    if inputs.len() != outputs.len() {
        let (n, m) = (inputs.len(), outputs.len());
        return Err(Message::error(format!("There are {n} inputs and {m} outputs")));
    }
    if test.iter().any(|row| row.len() != width) {
        return Err(Message::error(format!("Test: a branch must have {width} numbers, as the inputs have")));
    }
    let fit = Fit::new(context, &inputs)?;
    let depth = outputs.first().map_or(0, Vec::len);
    context.items(test.len().saturating_mul(depth))?;
    let column = |k: usize| outputs.iter().filter_map(|row| row.get(k).copied()).collect::<Vec<f64>>();
    let factors: Vec<Vec<f64>> = (0..depth).map(|k| fit.solve(&column(k))).collect();
    let mut result = TreeBuilder::<f64>::new();
    for (k, row) in (0..).zip(&test) {
        result.branch(Path::from([k]));
        factors.iter().for_each(|factors| result.push(Some(predicted(factors, row))));
    }
    Ok(result.finish())
}

fn squared(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y) * (x - y)).sum()
}

/// The number of the nearest centre, of equally near ones the first, and the squared distance.
fn nearest(centers: &[Vec<f64>], row: &[f64]) -> (usize, f64) {
    let all = centers.iter().map(|center| squared(center, row)).enumerate();
    all.fold((0, f64::INFINITY), |best, (k, d)| if d < best.1 { (k, d) } else { best })
}

/// First centres, each an observation, taken by chance with weights that grow with the squared distance from those before (D.
/// Arthur and S. Vassilvitskii, *k-means++: the advantages of careful seeding*, 2007).
fn seeds(rows: &[Vec<f64>], count: usize, chance: &mut Chance) -> Vec<Vec<f64>> {
    let first = (chance.draw() * rows.len() as f64) as usize;
    let mut centers: Vec<Vec<f64>> = rows.get(first).cloned().into_iter().collect();
    while centers.len() < count {
        let weights: Vec<f64> = rows.iter().map(|row| nearest(&centers, row).1).collect();
        let mut left = chance.draw() * weights.iter().sum::<f64>();
        let last = weights.iter().rposition(|weight| *weight > 0.0).unwrap_or(0);
        let place = weights.iter().position(|weight| {
            left -= weight;
            left < 0.0
        });
        centers.extend(rows.get(place.unwrap_or(last)).cloned());
    }
    centers
}

/// The means of the observations of each cluster; a cluster without any keeps its centre.
fn means(rows: &[Vec<f64>], labels: &[usize], centers: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let mut sums: Vec<(Vec<f64>, f64)> = centers.iter().map(|c| (vec![0.0; c.len()], 0.0)).collect();
    for (row, label) in rows.iter().zip(labels) {
        if let Some((sum, count)) = sums.get_mut(*label) {
            sum.iter_mut().zip(row).for_each(|(x, y)| *x += y);
            *count += 1.0;
        }
    }
    let mean = |((sum, count), old): ((Vec<f64>, f64), &Vec<f64>)| {
        if count > 0.0 { sum.iter().map(|x| x / count).collect() } else { old.clone() }
    };
    sums.into_iter().zip(centers).map(mean).collect()
}

/// The whole number that a tree begins with, or another one.
pub(super) fn whole(tree: &Tree, otherwise: i32) -> i32 {
    match tree.column().get(0) {
        Some(Value::Integer(n)) => n,
        _ => otherwise,
    }
}

/// The number of the cluster of each observation, and the centres (S. Lloyd, 1982; begun by k-means++).
///
/// # Errors
/// There cannot be so many clusters.
pub(super) fn clusters(
    context: &Context<'_>,
    rows: &[Vec<f64>],
    count: i32,
    seed: i32,
) -> Result<(Vec<usize>, Vec<Vec<f64>>), Message> {
    let count = usize::try_from(count).ok().filter(|k| (1..=rows.len()).contains(k)).ok_or_else(|| {
        Message::error(format!("{count} clusters of {} observations cannot be", rows.len()))
    })?;
    context.items(rows.len().saturating_mul(2))?;
    let mut centers = seeds(rows, count, &mut Chance::new(seed));
    let label = |centers: &[Vec<f64>]| rows.iter().map(|row| nearest(centers, row).0).collect::<Vec<usize>>();
    let mut labels = label(&centers);
    for _ in 0..ROUNDS {
        context.check()?;
        centers = means(rows, &labels, &centers);
        let next = label(&centers);
        if next == labels {
            break;
        }
        labels = next;
    }
    Ok((labels, centers))
}

/// Sorts observations into clusters about centres, each the mean of its cluster (S. Lloyd, 1982; begun by k-means++). Stands for
/// LunchBox's K-Means Clustering; the chance is our own, so that clusters have other numbers for the same seed. That each branch
/// is an observation, or each number where there is one branch, and that the likelihood is minus half of the squared distance
/// from the centre, is our reading.
#[component(
    "6b1c7c1e-0d4e-4e3a-9d5c-3f0a5a6f1ca3",
    name = "K-Means Clustering",
    nick = "K-Means",
    at = "LunchBox/Machine Learning"
)]
#[output("Result", "Result", "For each observation the number of its cluster, from 0.", kind = Integer)]
#[output("Likelihood", "Likelihood", "For each minus half of the squared distance from the centre.", kind = Number)]
#[output("Centroids", "Centroids", "A branch for each cluster: the mean of its observations.", kind = Number)]
fn k_means(
    context: &Context<'_>,
    /// The observations: a branch each, or a list of numbers.
    #[port("Training Inputs", "Inputs", kind = Number)]
    inputs: &Tree,
    /// The number of clusters, at least 1.
    #[port("# of Clusters", "Clusters", kind = Integer, optional)]
    count: &Tree,
    /// The seed.
    #[port("Random Seed", "seed", kind = Integer, optional)]
    seed: &Tree,
) -> Result<(Tree, Tree, Tree), Message> {
    let rows = observations(inputs, "Inputs")?;
    let (labels, centers) = clusters(context, &rows, whole(count, 3), whole(seed, 1))?;
    let likelihood = rows.iter().map(|row| -0.5 * nearest(&centers, row).1).collect();
    let numbers = labels.iter().map(|k| i32::try_from(*k).unwrap_or(i32::MAX)).collect();
    let mut middles = TreeBuilder::<f64>::new();
    for (k, center) in (0..).zip(&centers) {
        middles.branch(Path::from([k]));
        center.iter().for_each(|x| middles.push(Some(*x)));
    }
    Ok((Tree::list::<i32>(numbers), Tree::list::<f64>(likelihood), middles.finish()))
}

#[cfg(test)]
mod tests {
    use katydid_component::testing::Trial;
    use katydid_data::{Path, Tree, TreeBuilder, Value};

    fn tree(rows: &[Vec<f64>]) -> Tree {
        let mut builder = TreeBuilder::<f64>::new();
        for (k, row) in (0..).zip(rows) {
            builder.branch(Path::from([k]));
            row.iter().for_each(|x| builder.push(Some(*x)));
        }
        builder.finish()
    }

    fn numbers(tree: &Tree) -> Vec<f64> {
        let number = |item| match item {
            Some(Value::Number(x)) => x,
            Some(Value::Integer(n)) => f64::from(n),
            other => panic!("{other:?}"),
        };
        tree.column().iter().map(number).collect()
    }

    #[test]
    fn lines_of_least_squares() {
        let of = |x: &[f64], y: &[f64]| {
            Trial::of("Linear Regression").list([10.0]).list(x.to_vec()).list(y.to_vec())
        };
        // On the line 3 x − 2, and (1, 1), (2, 3), (3, 2), whose line is x / 2 + 1.
        assert!(
            (numbers(&of(&[0.0, 1.0, 5.0], &[-2.0, 1.0, 13.0]).run().outputs[0])[0] - 28.0).abs() < 1e-12
        );
        assert!((numbers(&of(&[1.0, 2.0, 3.0], &[1.0, 3.0, 2.0]).run().outputs[0])[0] - 6.0).abs() < 1e-12);
        assert!(of(&[1.0, 1.0], &[1.0, 2.0]).message().contains("depends"));
        assert!(of(&[1.0], &[1.0, 2.0]).message().contains("differ in number"));
        assert!(of(&[1.0, f64::NAN], &[1.0, 2.0]).message().contains("finite"));
        assert!(
            of(&[], &[]).message().contains("no observations") || of(&[], &[]).run().outputs[0].is_empty()
        );
    }

    #[test]
    fn planes_of_least_squares() {
        let rows: Vec<Vec<f64>> =
            (0..20).map(|k| vec![f64::from(k % 5), f64::from(k * k % 7), f64::from(k)]).collect();
        let form = |r: &[f64]| vec![2.0 * r[0] - r[1] + 0.5 * r[2] + 4.0, r[1] - 3.0];
        let outputs: Vec<Vec<f64>> = rows.iter().map(|row| form(row)).collect();
        let test = [vec![1.0, -2.0, 7.0], vec![100.0, 3.0, 0.25]];
        let trial = Trial::of("Multivariate Linear Regression").tree(tree(&test));
        let result = trial.tree(tree(&rows)).tree(tree(&outputs)).run().outputs[0].clone();
        assert_eq!(result.branch_count(), 2);
        for (found, wanted) in numbers(&result).iter().zip(test.iter().flat_map(|row| form(row))) {
            assert!((found - wanted).abs() < 1e-9, "{found} {wanted}");
        }
        let short = Trial::of("Multivariate Linear Regression").tree(tree(&[vec![1.0]]));
        assert!(short.tree(tree(&rows)).tree(tree(&outputs)).message().contains("3 numbers"));
    }

    #[test]
    fn clusters_far_apart_are_found() {
        // Three clusters of 20 at the corners of a triangle, 100 apart, each within 3 of its middle.
        let corners = [[0.0, 0.0], [100.0, 0.0], [50.0, 80.0]];
        let rows: Vec<Vec<f64>> = (0..60)
            .map(|k| {
                let [x, y] = corners[k % 3];
                vec![x + f64::from((k * 7 % 5) as u8) - 2.0, y + f64::from((k * 11 % 4) as u8) - 1.5]
            })
            .collect();
        for seed in 0..10 {
            let run = Trial::of("K-Means Clustering").tree(tree(&rows)).item(3).item(seed).run().outputs;
            let labels = numbers(&run[0]);
            for k in 0..60 {
                assert_eq!(labels[k], labels[k % 3], "{seed}");
            }
            assert!(labels[0] != labels[1] && labels[1] != labels[2] && labels[2] != labels[0], "{seed}");
            // The mean of 20 observations of a corner.
            let mean = |axis: usize| (0..20).map(|k| rows[3 * k][axis]).sum::<f64>() / 20.0;
            let centers = numbers(&run[2]);
            let first = 2 * labels[0] as usize;
            assert!((centers[first] - mean(0)).abs() < 1e-9 && (centers[first + 1] - mean(1)).abs() < 1e-9);
        }
        let list = Trial::of("K-Means Clustering").list([1.0, 1.5, 9.0, 9.5]).item(2).item(5).run().outputs;
        let labels = numbers(&list[0]);
        assert!(labels[0] == labels[1] && labels[2] == labels[3] && labels[0] != labels[2]);
        assert_eq!(numbers(&list[1]), [-0.03125; 4]);
        let same = Trial::of("K-Means Clustering").list([2.0, 2.0, 2.0]).item(2).item(5).run().outputs;
        assert_eq!(numbers(&same[0]), [0.0; 3]);
        let many = Trial::of("K-Means Clustering").list([1.0, 2.0]).item(3);
        assert!(many.message().contains("3 clusters of 2"));
        assert!(Trial::of("K-Means Clustering").list([1.0, f64::NAN]).item(1).message().contains("finite"));
    }
}
