//! A last look at results: a volume that the operands cannot give is refused.
//!
//! The volumes of union and intersection add up to those of the operands whatever is chosen, as long as every part is
//! chosen for one of them: that identity tells nothing of one result. What tells is between which volumes it must lie.

use std::f64::consts::PI;

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
/// A volume that is told roughly is at least this part of what is told: spheres, which enclose the most, are to pass.
const ROUGHLY: f64 = 0.9;
/// Volumes may be off by this part of those of all operands together.
const WITHIN: f64 = 1e-3;

/// Refuses a result whose volume lies outside of what the volumes of the operands allow.
pub(super) fn volumes(operation: Operation, first: &[Brep], second: &[Brep], made: &[Made]) -> Result<()> {
    let closed = |breps: &[Brep]| breps.iter().all(Brep::is_solid);
    if !(closed(first) && closed(second) && made.iter().all(|m| m.brep.is_solid())) {
        return Ok(());
    }
    let results: Vec<&Brep> = made.iter().map(|m| &m.brep).collect();
    let [first, second] = [first, second].map(|breps| breps.iter().collect::<Vec<&Brep>>());
    // A few digits tell mostly; only what looks wrong is measured.
    let sizes = |breps: &[&Brep]| -> Vec<f64> { breps.iter().map(|b| b.rough_volume().abs()).collect() };
    let rough: Vec<f64> = results.iter().map(|b| b.rough_volume()).collect();
    if are_possible(operation, &sizes(&first), &sizes(&second), &rough) {
        return Ok(());
    }
    let (Some(a), Some(b)) = (measured(&first)?, measured(&second)?) else { return Ok(()) };
    let Some(c) = measured(&results)? else { return Ok(()) };
    if are_possible(operation, &a, &b, &c) {
        return Ok(());
    }
    Err(Refusal::at(RefusalClass::Unsound, &[], None))
}

/// Refuses solids of more volume than their area can enclose (the isoperimetric inequality, 36 π V² ≤ A³): their faces do not
/// close, though their edges are one within the tolerance.
///
/// # Errors
/// As described; or the work was stopped.
pub(super) fn enclosed<'a>(solids: impl Iterator<Item = &'a Brep>) -> Result<()> {
    for solid in solids {
        let area = match solid.area_properties(MEASURED, || !cancellation::was_given_up()) {
            Ok(found) => found.amount,
            Err(Error::Stopped) => return Err(Error::Stopped),
            // What cannot be measured is no reason to refuse.
            Err(_) => continue,
        };
        let volume = ROUGHLY * solid.rough_volume();
        if 36.0 * PI * volume * volume > area * area * area {
            return Err(Refusal::at(RefusalClass::Unsound, &[], None));
        }
    }
    Ok(())
}

/// Whether operands of some volumes can give results of some volumes.
fn are_possible(operation: Operation, a: &[f64], b: &[f64], c: &[f64]) -> bool {
    let (all, others, found) = (sum(a), sum(b), sum(c));
    let largest = |of: &[f64]| of.iter().copied().fold(0.0, f64::max);
    // Operands of one side may overlap each other.
    let [least, most] = match operation {
        Operation::Union => [largest(a), all],
        Operation::Difference => [largest(a) - others, all],
        Operation::Intersection => [0.0, all.min(others)],
    };
    let near = WITHIN * (all + others);
    found >= least - near && found <= most + near && c.iter().all(|v| *v > 0.0)
}

fn sum(of: &[f64]) -> f64 {
    of.iter().sum()
}

/// The volumes of solids; none where one cannot be measured.
fn measured(breps: &[&Brep]) -> Result<Option<Vec<f64>>> {
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
