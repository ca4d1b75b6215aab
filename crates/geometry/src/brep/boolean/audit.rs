//! A last look at results: a volume that the operands cannot give is refused.
//!
//! The volumes of union and intersection add up to those of the operands whatever is chosen, as long as every part is
//! chosen for one of them: that identity tells nothing of one result. What tells is between which volumes it must lie.

use super::{Made, Refusal, RefusalClass};
use crate::{Brep, Error, Result, cancellation};

/// What was asked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operation {
    Union,
    Difference,
    Intersection,
}

/// Volumes are measured to this part of themselves: parts that are chosen wrongly are far larger.
const MEASURED: f64 = 1e-4;
/// Volumes may be off by this part of those of all operands together.
const WITHIN: f64 = 1e-3;

/// Refuses a result whose volume lies outside of what the volumes of the operands allow.
pub(super) fn volumes(operation: Operation, first: &[Brep], second: &[Brep], made: &[Made]) -> Result<()> {
    let closed = |breps: &[Brep]| breps.iter().all(Brep::is_solid);
    if !(closed(first) && closed(second) && made.iter().all(|m| m.brep.is_solid())) {
        return Ok(());
    }
    let (Some(a), Some(b)) = (measured(first)?, measured(second)?) else { return Ok(()) };
    let results: Vec<Brep> = made.iter().map(|m| m.brep.clone()).collect();
    let Some(c) = measured(&results)? else { return Ok(()) };
    let (all, others, found) = (sum(&a), sum(&b), sum(&c));
    let largest = |of: &[f64]| of.iter().copied().fold(0.0, f64::max);
    // Operands of one side may overlap each other.
    let [least, most] = match operation {
        Operation::Union => [largest(&a), all],
        Operation::Difference => [largest(&a) - others, all],
        Operation::Intersection => [0.0, all.min(others)],
    };
    let near = WITHIN * (all + others);
    if found < least - near || found > most + near || c.iter().any(|v| *v <= 0.0) {
        return Err(Refusal::at(RefusalClass::Unsound, &[], None));
    }
    Ok(())
}

fn sum(of: &[f64]) -> f64 {
    of.iter().sum()
}

/// The volumes of solids; none where one cannot be measured.
fn measured(breps: &[Brep]) -> Result<Option<Vec<f64>>> {
    let mut out = Vec::with_capacity(breps.len());
    for brep in breps {
        match brep.volume_properties(MEASURED, || !cancellation::was_given_up()) {
            Ok(found) => out.push(found.amount),
            Err(Error::Stopped) => return Err(Error::Stopped),
            Err(_) => return Ok(None),
        }
    }
    Ok(Some(out))
}
