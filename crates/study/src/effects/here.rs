//! What moves an output where the definition stands.

use std::collections::HashMap;

use super::borders::{self, Border, Sample};
use super::differences::{Derivative, central, one_sided};
use crate::probe::Probe;
use crate::thresholds::{CORNER, SIDE_ROOM};

/// Where an answer stops to hold.
#[derive(Debug, Clone, PartialEq)]
pub struct End {
    /// The number of the input there.
    pub at: f64,
    /// Why: the slider ends, the output jumps from one number to another, an object gives another count or fails.
    pub why: String,
    /// Whether it is the end of the input's own range.
    pub is_limit: bool,
}

/// What an output does when an input moves from where it stands.
#[derive(Debug, Clone, PartialEq)]
pub struct Here {
    /// The input's place among the variables.
    pub variable: usize,
    /// The input.
    pub name: String,
    /// The number it stands at.
    pub at: f64,
    /// What the output does.
    pub slope: Slope,
    /// From where to where that holds; `None` for inputs of whole numbers, whose output may jump at each step.
    pub holds: Option<[End; 2]>,
}

/// How an output changes with an input.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Slope {
    /// Evenly.
    Even(Derivative),
    /// From the left, or up to there, in one way and to the right in another; `None` on a side where nothing can be said.
    Corner([Option<Derivative>; 2]),
    /// By so much for a step down and a step up of an input of whole numbers; `None` where there is no step or no number.
    Steps {
        /// How far a step is.
        step: f64,
        /// Change of the output for a step down, then up.
        change: [Option<f64>; 2],
    },
    /// It jumps just where the input stands, or nothing can be said near it.
    Jump,
}

/// Looks at one variable; it is put back to where it stood.
pub(super) fn look(probe: &mut Probe, index: usize) -> Option<Here> {
    let variable = probe.variables().get(index)?.clone();
    let (at, [min, max]) = (probe.at().get(index).copied()??, variable.limits()?);
    let found = match variable.step() {
        Some(step) => {
            let here = value(probe, index, at)?;
            let mut change = |x: f64| {
                let x = variable.fitted(crate::Cell::Number(x)).number()?;
                let inside = x != at && (min..=max).contains(&x);
                inside.then(|| value(probe, index, x)).flatten().map(|y| y - here)
            };
            let change = [change(at - step), change(at + step)];
            Here {
                variable: index,
                name: variable.name.clone(),
                at,
                slope: Slope::Steps { step, change },
                holds: None,
            }
        }
        None => even(probe, index, &variable.name, at, [min, max]),
    };
    probe.set(index, at);
    Some(found)
}

fn value(probe: &mut Probe, index: usize, x: f64) -> Option<f64> {
    probe.read(index, x).numbers?.first().copied()
}

fn even(probe: &mut Probe, index: usize, name: &str, at: f64, limits: [f64; 2]) -> Here {
    let mut known: HashMap<u64, Sample> = HashMap::new();
    let mut sample = |x: f64| {
        *known.entry(x.to_bits()).or_insert_with(|| {
            let reading = probe.read(index, x);
            Sample { value: reading.numbers.and_then(|n| n.first().copied()), shape: reading.shape }
        })
    };
    let borders = limits.map(|end| borders::first(&mut sample, at, end));
    let mut value = |x: f64| sample(x).value;
    let ends = [0, 1].map(|side| borders[side].map_or(limits[side], |border| border.near));
    let slope = slope(&mut value, at, ends, limits[1] - limits[0]);
    let holds = [0, 1].map(|side| match borders[side] {
        None => End { at: limits[side], why: "the input ends".to_owned(), is_limit: true },
        Some(border) => End { at: border.far, why: why(probe, index, border, &known), is_limit: false },
    });
    Here { variable: index, name: name.to_owned(), at, slope, holds: Some(holds) }
}

fn why(probe: &mut Probe, index: usize, border: Border, known: &HashMap<u64, Sample>) -> String {
    if border.is_change {
        let what = probe.what_changes(index, border.near, border.far);
        return what.unwrap_or_else(|| "the output has no number".to_owned());
    }
    let value = |x: f64| known.get(&x.to_bits()).and_then(|sample| sample.value);
    match (value(border.near), value(border.far)) {
        (Some(a), Some(b)) => format!("the output jumps from {a} to {b}"),
        _ => "the output jumps".to_owned(),
    }
}

/// The derivative between two ends: from both sides where there is room, else from the one that has it.
fn slope(f: &mut dyn FnMut(f64) -> Option<f64>, at: f64, ends: [f64; 2], range: f64) -> Slope {
    let room = [at - ends[0], ends[1] - at];
    let has_room = |side: usize| room[side] > SIDE_ROOM * range.abs().min(room[1 - side]) && room[side] > 0.0;
    // Not wholly to the ends: what is one step of rounding behind them is another answer.
    let reach = |side: usize| 0.99 * room[side] * if side == 0 { -1.0 } else { 1.0 };
    // Long steps come first, so that a side that has no room is not asked.
    let mut sided = |side: usize| has_room(side).then(|| one_sided(f, at, reach(side))).flatten();
    let sides = [sided(0), sided(1)];
    match sides {
        [Some(left), Some(right)] => {
            let differ = (left.value - right.value).abs();
            let most = left.value.abs().max(right.value.abs());
            if differ > CORNER * most && differ > left.error + right.error {
                return Slope::Corner(sides);
            }
            let both = central(f, at, 0.99 * room[0].min(room[1]));
            let all = [Some(left), Some(right), both];
            let best = all.into_iter().flatten().min_by(|a, b| a.error.total_cmp(&b.error));
            best.map_or(Slope::Jump, Slope::Even)
        }
        [Some(one), None] | [None, Some(one)] => Slope::Even(one),
        [None, None] => Slope::Jump,
    }
}
