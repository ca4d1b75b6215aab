//! Inputs for a wanted result: sliders move within their ranges until outputs are where they are wanted.

use std::time::Duration;

use katydid_component::Cancel;
use web_time::Instant;

use crate::probe::Probe;
use crate::thresholds::{LEAST_MOVE, MOST_ROUNDS, NUDGE};
use crate::{Cell, Prepared, StudyError};

/// Inputs for a wanted result.
#[derive(Debug, Clone, PartialEq)]
pub struct Solution {
    /// What the variables are to stand at, rounded as their sliders round.
    pub inputs: Vec<f64>,
    /// The numbers that the outputs give there, one after another; of a point, its three coordinates.
    pub numbers: Vec<f64>,
    /// How far they are from those that were wanted: the root of the sum of squares.
    pub off: f64,
    /// How often the definition was solved.
    pub solves: u64,
}

/// How long is searched.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Effort {
    /// Rounds, each of which solves the definition once or a few times for each variable.
    pub rounds: usize,
    /// How long at most; what is best by then is the answer. A solve that has begun is not cut short.
    pub time: Option<Duration>,
}

impl Default for Effort {
    fn default() -> Self {
        Self { rounds: MOST_ROUNDS, time: None }
    }
}

/// When a search that has begun is to end.
pub(crate) struct Clock {
    pub(crate) began: Instant,
    pub(crate) time: Option<Duration>,
}

impl Clock {
    fn is_over(&self, probe: &mut Probe) -> bool {
        probe.is_time_over(|| self.time.is_some_and(|time| self.began.elapsed() >= time))
    }
}

/// Finds where the variables of a prepared definition must stand so that its outputs give the wanted numbers, as nearly as their
/// ranges let them: least squares by Levenberg's and Marquardt's method, with moves cut off at the ends of the ranges, and inputs
/// left out that press against one (Kanzow, Yamashita, Fukushima 2004). It begins where the definition stands, and finds what is
/// best near there.
///
/// # Errors
/// A variable has no range or takes whole numbers only, an output gives no numbers as the definition stands or another count of them
/// than is wanted, or somebody asked to stop.
pub fn solve_for(
    prepared: &Prepared,
    wanted: &[f64],
    effort: Effort,
    cancel: &Cancel,
) -> Result<Solution, StudyError> {
    let clock = Clock { began: Instant::now(), time: effort.time };
    search(&mut Probe::new(prepared), wanted, effort.rounds, &clock, cancel)
}

/// The search of [`solve_for`], by a probe of the definition.
pub(crate) fn search(
    probe: &mut Probe,
    wanted: &[f64],
    rounds: usize,
    clock: &Clock,
    cancel: &Cancel,
) -> Result<Solution, StudyError> {
    // What a solve that was stopped does not give is no fault of the definition.
    let unfit =
        |why: String| if cancel.is_cancelled() { StudyError::Stopped } else { StudyError::Unfit(why) };
    let mut ranges = Vec::new();
    for variable in probe.variables() {
        if variable.step().is_some() {
            return Err(unfit(format!("'{}' takes whole numbers: it cannot be moved evenly", variable.name)));
        }
        let range = variable.limits().filter(|[min, max]| max > min);
        ranges.push(range.ok_or_else(|| unfit(format!("'{}' has no range of numbers", variable.name)))?);
    }
    if ranges.is_empty() {
        return Err(unfit("no input may move".to_owned()));
    }
    let mut x: Vec<f64> = probe.at().iter().map(|x| x.unwrap_or(0.0)).collect();
    let numbers = probe.solve().numbers;
    let numbers =
        numbers.ok_or_else(|| unfit("the outputs give no numbers as the definition stands".to_owned()))?;
    if numbers.len() != wanted.len() {
        let (n, m) = (numbers.len(), wanted.len());
        return Err(unfit(format!("the outputs give {n} numbers, not {m}: a point has three")));
    }
    let mut errors: Vec<f64> = numbers.iter().zip(wanted).map(|(y, w)| y - w).collect();
    let mut damping = 1e-3;
    for _ in 0..rounds {
        if cancel.is_cancelled() {
            return Err(StudyError::Stopped);
        }
        let Some(slopes) = slopes(probe, &x, &ranges, wanted, &errors, clock) else { break };
        let mut is_better = false;
        while damping < 1e12 && !clock.is_over(probe) {
            let Some(to) = step(&x, &ranges, &slopes, &errors, damping) else { break };
            let moved = to.iter().zip(&x).zip(&ranges).map(|((a, b), r)| ((a - b) / (r[1] - r[0])).abs());
            if moved.fold(0.0, f64::max) < LEAST_MOVE {
                break;
            }
            match errors_at(probe, &to, wanted) {
                Some(new) if size(&new) < size(&errors) => {
                    (x, errors, is_better) = (to, new, true);
                    damping = f64::max(damping / 9.0, 1e-15);
                    break;
                }
                _ => damping *= 11.0,
            }
        }
        if !is_better || size(&errors) == 0.0 || clock.is_over(probe) {
            break;
        }
    }
    let rounded: Vec<f64> = probe
        .variables()
        .iter()
        .zip(&x)
        .map(|(variable, x)| variable.fitted(Cell::Number(*x)).number().unwrap_or(*x))
        .collect();
    let last = errors_at(probe, &rounded, wanted)
        .ok_or_else(|| unfit("the outputs give no numbers where the sliders round to".to_owned()))?;
    let numbers = last.iter().zip(wanted).map(|(e, w)| e + w).collect();
    Ok(Solution { inputs: rounded, numbers, off: size(&last).sqrt(), solves: probe.solves })
}

fn size(errors: &[f64]) -> f64 {
    errors.iter().map(|e| e * e).sum()
}

fn errors_at(probe: &mut Probe, x: &[f64], wanted: &[f64]) -> Option<Vec<f64>> {
    x.iter().enumerate().for_each(|(at, x)| probe.set(at, *x));
    let numbers = probe.solve().numbers.filter(|numbers| numbers.len() == wanted.len())?;
    Some(numbers.iter().zip(wanted).map(|(y, w)| y - w).collect())
}

/// The change of each error for each variable, of a range of 1; a row a variable, of zeros once the time is over. `None` where all
/// differences fail.
fn slopes(
    probe: &mut Probe,
    x: &[f64],
    ranges: &[[f64; 2]],
    wanted: &[f64],
    errors: &[f64],
    clock: &Clock,
) -> Option<Vec<Vec<f64>>> {
    let mut rows = Vec::new();
    for (at, [min, max]) in ranges.iter().enumerate() {
        let range = max - min;
        let mut row = None;
        // The other side is asked where one has no numbers, or no room.
        for nudge in [NUDGE, -NUDGE] {
            if clock.is_over(probe) {
                break;
            }
            let mut beside = x.to_vec();
            let Some(moved) = beside.get_mut(at) else { continue };
            *moved += nudge * range;
            if *moved < *min || *moved > *max {
                continue;
            }
            let part = (*moved - x.get(at)?) / range;
            if let Some(new) = errors_at(probe, &beside, wanted) {
                row = Some(new.iter().zip(errors).map(|(a, b)| (a - b) / part).collect());
                break;
            }
        }
        rows.push(row);
    }
    let found = rows.iter().any(Option::is_some);
    found.then(|| rows.into_iter().map(|row| row.unwrap_or_else(|| vec![0.0; errors.len()])).collect())
}

/// The damped step within the ranges, or `None` where no variable can go down.
fn step(
    x: &[f64],
    ranges: &[[f64; 2]],
    slopes: &[Vec<f64>],
    errors: &[f64],
    damping: f64,
) -> Option<Vec<f64>> {
    let downhill: Vec<f64> =
        slopes.iter().map(|row| -row.iter().zip(errors).map(|(s, e)| s * e).sum::<f64>()).collect();
    let free: Vec<usize> = (0..x.len())
        .filter(|at| {
            let [min, max] = ranges[*at];
            let presses = (x[*at] <= min && downhill[*at] < 0.0) || (x[*at] >= max && downhill[*at] > 0.0);
            downhill[*at] != 0.0 && !presses
        })
        .collect();
    if free.is_empty() {
        return None;
    }
    let product = |a: usize, b: usize| slopes[a].iter().zip(&slopes[b]).map(|(s, t)| s * t).sum::<f64>();
    let most = free.iter().map(|at| product(*at, *at)).fold(0.0, f64::max);
    let mut rows: Vec<Vec<f64>> = free
        .iter()
        .map(|a| {
            let mut row: Vec<f64> = free.iter().map(|b| product(*a, *b)).collect();
            let own = free.iter().position(|at| at == a)?;
            row[own] += damping * most;
            row.push(downhill[*a]);
            Some(row)
        })
        .collect::<Option<_>>()?;
    let moves = solved(&mut rows)?;
    let mut to = x.to_vec();
    for (at, by) in free.iter().zip(moves) {
        let [min, max] = ranges[*at];
        to[*at] = (x[*at] + by * (max - min)).clamp(min, max);
    }
    Some(to)
}

/// Gauss's elimination with the largest pivot of a column, of rows that end with their right sides.
fn solved(rows: &mut [Vec<f64>]) -> Option<Vec<f64>> {
    let n = rows.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|a, b| rows[*a][k].abs().total_cmp(&rows[*b][k].abs()))?;
        rows.swap(k, pivot);
        let top = rows[k].clone();
        if top[k] == 0.0 || !top[k].is_finite() {
            return None;
        }
        for row in rows.iter_mut().skip(k + 1) {
            let by = row[k] / top[k];
            for (x, t) in row.iter_mut().zip(&top) {
                *x -= by * t;
            }
        }
    }
    let mut x = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| rows[k][j] * x[j]).sum();
        x[k] = (rows[k][n] - known) / rows[k][k];
    }
    x.iter().all(|x| x.is_finite()).then_some(x)
}
