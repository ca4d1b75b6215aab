//! Points of a cube as values of inputs, and what the definition gives there.

#[cfg(feature = "studies")]
use katydid_component::Cancel;

use crate::plan::{Axis, placed, whole_range};
use crate::{Cell, Outcome, Status, StudyError, Variable};
#[cfg(feature = "studies")]
use crate::{Prepared, pool::Pool};

/// The ranges of all variables.
pub(crate) struct Space {
    axes: Vec<Axis>,
    variables: Vec<Variable>,
}

impl Space {
    /// The whole range of each.
    ///
    /// # Errors
    /// One has no range.
    pub(crate) fn of(variables: &[Variable]) -> Result<Self, StudyError> {
        let axes = variables.iter().map(whole_range).collect::<Result<_, _>>()?;
        Ok(Self { axes, variables: variables.to_vec() })
    }

    /// How many variables there are.
    pub(crate) fn dimensions(&self) -> usize {
        self.axes.len()
    }

    /// Where the variables stand in a document, numbers from 0 to 1; the middle for what is no slider and no gene.
    pub(crate) fn unit(&self) -> Vec<f64> {
        let place = |(axis, variable): (&Axis, &Variable)| {
            let x = variable.stands_at()?;
            let [from, to] = match axis {
                Axis::Range(range) => *range,
                #[allow(clippy::cast_precision_loss, reason = "at most a million")]
                Axis::Steps { from, step, count } => [from - 0.5 * step, from + step * (*count as f64 - 0.5)],
                Axis::Values(_) => return None,
            };
            (to > from).then(|| ((x - from) / (to - from)).clamp(0.0, 1.0))
        };
        self.axes.iter().zip(&self.variables).map(|pair| place(pair).unwrap_or(0.5)).collect()
    }

    /// Numbers from 0 to 1 as values, rounded as the inputs round them.
    pub(crate) fn point(&self, unit: &[f64]) -> Vec<Cell> {
        let placed = placed(&self.axes, unit).into_iter();
        placed.zip(&self.variables).map(|(cell, variable)| variable.fitted(cell)).collect()
    }
}

/// The first output's number at a point that came out well.
pub(crate) fn value_of(outcome: &Outcome) -> Option<f64> {
    let is_good = matches!(outcome.status, Status::Ok | Status::Warning);
    outcome.cells.first().filter(|_| is_good).and_then(Cell::number)
}

/// The first output's number at each point, in their order; `None` where there is none.
///
/// # Errors
/// Somebody asked to stop, or no thread could be started.
#[cfg(feature = "studies")]
pub(super) fn solve_all(
    prepared: &Prepared,
    workers: usize,
    points: Vec<Vec<Cell>>,
    cancel: &Cancel,
) -> Result<Vec<Option<f64>>, StudyError> {
    let mut values = vec![None; points.len()];
    let asked = cancel.clone();
    let tasks = points
        .into_iter()
        .enumerate()
        .map(move |task| if asked.is_cancelled() { Err(StudyError::Stopped) } else { Ok(task) });
    Pool::new(prepared.clone(), workers, None).each(
        tasks,
        |worker, (at, point)| (at, worker.solve(&point)),
        |(at, _), outcome| (at, outcome),
        |(at, outcome)| {
            if let Some(slot) = values.get_mut(at) {
                *slot = value_of(&outcome);
            }
            Ok(())
        },
    )?;
    if cancel.is_cancelled() { Err(StudyError::Stopped) } else { Ok(values) }
}
