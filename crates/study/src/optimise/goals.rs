//! What is to be small, large or near a number, and what must hold.

use serde::{Deserialize, Serialize};

use super::search::Scored;
use crate::Outcome;

/// What an output is to be.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Goal {
    /// As small as can be.
    Least,
    /// As large as can be.
    Most,
    /// As near to a number as can be.
    Near(f64),
}

impl Goal {
    /// What a number is worth; less is better.
    pub(crate) fn worth(self, x: f64) -> f64 {
        match self {
            Self::Least => x,
            Self::Most => -x,
            Self::Near(wanted) => (x - wanted).abs(),
        }
    }
}

/// An output with its goal.
#[derive(Debug, Clone, PartialEq)]
pub struct Objective {
    /// The place of the output in the list of outputs.
    pub output: usize,
    /// What it is to be.
    pub goal: Goal,
}

/// A side on which an output must stay.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Bound {
    /// At most so much.
    AtMost(f64),
    /// At least so much.
    AtLeast(f64),
}

impl Bound {
    /// By how much a number is on the wrong side; 0 on the right one.
    pub(crate) fn missed(self, x: f64) -> f64 {
        match self {
            Self::AtMost(most) => f64::max(x - most, 0.0),
            Self::AtLeast(least) => f64::max(least - x, 0.0),
        }
    }
}

/// An output that must stay on one side of a number.
#[derive(Debug, Clone, PartialEq)]
pub struct Constraint {
    /// The place of the output in the list of outputs.
    pub output: usize,
    /// The side.
    pub bound: Bound,
}

/// What an outcome is worth at a place of the cube.
pub(super) fn scored(
    place: Vec<f64>,
    outcome: &Outcome,
    objectives: &[Objective],
    constraints: &[Constraint],
) -> Scored {
    let number = |output: usize| outcome.cells.get(output)?.number().filter(|x| x.is_finite());
    let goals: Option<Vec<f64>> = objectives
        .iter()
        .map(|objective| number(objective.output).map(|x| objective.goal.worth(x)))
        .collect();
    let missed: Option<f64> = constraints
        .iter()
        .map(|constraint| number(constraint.output).map(|x| constraint.bound.missed(x)))
        .sum();
    match (goals, missed) {
        (Some(goals), Some(missed)) if outcome.status.is_good() => Scored { place, goals, missed },
        _ => Scored { place, goals: vec![f64::INFINITY; objectives.len()], missed: f64::INFINITY },
    }
}
