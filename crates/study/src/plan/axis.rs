//! What an input goes through.

use super::InputPlan;
use crate::thresholds::MOST_VALUES;
use crate::{Cell, StudyError, Variable};

/// What an input goes through.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Axis {
    /// These values.
    Values(Vec<Cell>),
    /// All numbers between two.
    Range([f64; 2]),
    /// The multiples of a step from a number on, so many.
    Steps { from: f64, step: f64, count: u64 },
}

impl Axis {
    /// The values of a grid along it.
    #[allow(clippy::cast_precision_loss, reason = "there are at most a million")]
    pub(super) fn values(self, variable: &Variable) -> Vec<Cell> {
        match self {
            Self::Values(values) => values,
            Self::Range(range) => range.map(Cell::Number).to_vec(),
            Self::Steps { from, step, count } => {
                (0..count).map(|k| variable.fitted(Cell::Number(from + step * k as f64))).collect()
            }
        }
    }
}

/// What an input goes through, as the plan says or, where it says nothing, the input itself.
pub(super) fn axis(variable: &Variable, spec: &InputPlan, grid: bool) -> Result<Axis, StudyError> {
    let wrong = |why: String| StudyError::Plan(format!("'{}': {why}", variable.name));
    let InputPlan::Range { from, to, steps } = spec else {
        let InputPlan::Values(values) = spec else { return Err(wrong("it has no values".to_owned())) };
        if values.is_empty() || values.len() > MOST_VALUES {
            return Err(wrong(format!("a list has 1 to {MOST_VALUES} values")));
        }
        return Ok(Axis::Values(values.iter().map(Cell::of_json).collect()));
    };
    if let (Some(choices), None, None) = (variable.choices(), from, to) {
        return Ok(Axis::Values(choices));
    }
    let limits = variable.limits();
    let (Some(from), Some(to)) = (from.or(limits.map(|l| l[0])), to.or(limits.map(|l| l[1]))) else {
        return Err(wrong("it has no limits of its own: say from and to, or list its values".to_owned()));
    };
    if !(from.is_finite() && to.is_finite() && from <= to) {
        return Err(wrong(format!("{from} to {to} is no range")));
    }
    if let Some([min, max]) = limits
        && (from < min || to > max)
    {
        return Err(wrong(format!("the slider goes from {min} to {max}")));
    }
    if let Some(count) = *steps {
        if count == 0 || count > MOST_VALUES as u64 {
            return Err(wrong(format!("steps are 1 to {MOST_VALUES}")));
        }
        #[allow(clippy::cast_precision_loss, reason = "at most a million")]
        let step = if count == 1 { 0.0 } else { (to - from) / (count - 1) as f64 };
        return Ok(Axis::Steps { from, step, count });
    }
    match variable.step() {
        Some(step) => {
            let Cell::Number(first) = variable.fitted(Cell::Number(from)) else {
                return Err(wrong("it is no number".to_owned()));
            };
            let first = if first < from { first + step } else { first };
            let count = ((to - first) / step).floor() + 1.0;
            if !(1.0..=1e6).contains(&count) {
                return Err(wrong(format!(
                    "between {from} and {to} there are no steps of {step}, or too many"
                )));
            }
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to a million")]
            Ok(Axis::Steps { from: first, step, count: count as u64 })
        }
        None if grid => Err(wrong("a grid needs 'steps', or a list of values".to_owned())),
        None => Ok(Axis::Range([from, to])),
    }
}

/// The whole range of an input.
///
/// # Errors
/// It has none.
pub(crate) fn whole_range(variable: &Variable) -> Result<Axis, StudyError> {
    axis(variable, &InputPlan::Range { from: None, to: None, steps: None }, false)
}
