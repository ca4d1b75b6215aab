//! Which points a sweep solves.

mod file;
pub(crate) mod rows;
pub(crate) mod sampling;
pub(crate) mod sobol;

use std::path::PathBuf;

use katydid_definition::document::Document;

pub use file::PlanFile;
use file::{InputPlan, Sample};
pub(crate) use sampling::placed;

use crate::thresholds::{MOST_POINTS, MOST_VALUES};
use crate::{Cell, Output, StudyError, Variable, marked};

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

/// A plan bound to a definition: its points can be asked for again and again, always the same.
#[derive(Debug, Clone)]
pub struct Plan {
    variables: Vec<Variable>,
    outputs: Vec<Output>,
    points: Points,
    /// How many; for rows of a file, counted when it was bound.
    count: u64,
    /// Whether each point gets a picture.
    pub pictures: bool,
    /// The extension of the geometry that each point gets.
    pub geometry: Option<String>,
}

#[derive(Debug, Clone)]
enum Points {
    Grid(Vec<Vec<Cell>>),
    LatinHypercube { axes: Vec<Axis>, seed: u64 },
    Sobol { axes: Vec<Axis>, seed: u64 },
    Rows { path: PathBuf, columns: Vec<usize> },
    Listed(Vec<Vec<Cell>>),
}

/// The points of a plan one by one: a cell for each input, or why a row of a file is none.
pub type PlanPoints<'a> = Box<dyn Iterator<Item = Result<Vec<Cell>, StudyError>> + Send + 'a>;

impl Plan {
    /// Binds a plan to a definition: finds its inputs and outputs, and counts its points.
    ///
    /// # Errors
    /// An input or output is not there, or the plan makes no sense for it.
    pub fn bind(file: &PlanFile, document: &Document) -> Result<Self, StudyError> {
        let mut outputs: Vec<Output> =
            file.outputs.iter().map(|name| Output::find(document, name)).collect::<Result<_, _>>()?;
        if outputs.is_empty() {
            outputs = marked(document);
        }
        if outputs.is_empty() && !file.pictures && file.geometry.is_none() {
            return Err(StudyError::Plan(
                "it names no outputs, and the definition marks none: a group called RH_OUT:name, Context Print, or a wired panel"
                    .to_owned(),
            ));
        }
        let (variables, points, count) = match file.sample {
            Sample::Rows => Self::rows(file, document)?,
            Sample::Grid | Sample::LatinHypercube | Sample::Sobol => Self::sampled(file, document)?,
        };
        for (at, variable) in variables.iter().enumerate() {
            if variables.iter().take(at).any(|other| other.name == variable.name) {
                return Err(StudyError::Plan(format!("the input '{}' is named twice", variable.name)));
            }
        }
        if count > MOST_POINTS {
            return Err(StudyError::Plan(format!("{count} points are more than {MOST_POINTS}")));
        }
        Ok(Self {
            variables,
            outputs,
            points,
            count,
            pictures: file.pictures,
            geometry: file.geometry.clone(),
        })
    }

    /// The plan of points that are known, with values as the inputs round them.
    pub(crate) fn listed(variables: Vec<Variable>, outputs: Vec<Output>, points: Vec<Vec<Cell>>) -> Self {
        let count = points.len() as u64;
        Self { variables, outputs, points: Points::Listed(points), count, pictures: false, geometry: None }
    }

    fn rows(file: &PlanFile, document: &Document) -> Result<(Vec<Variable>, Points, u64), StudyError> {
        let path = file
            .rows
            .clone()
            .ok_or_else(|| StudyError::Plan("'rows' names the file with the points".to_owned()))?;
        let (header, count) = rows::look(&path)?;
        let chosen = rows::columns(&header, &file.inputs.names())?;
        let variables: Result<Vec<_>, _> =
            chosen.iter().map(|(_, name)| Variable::find(document, name)).collect();
        let columns = chosen.iter().map(|(column, _)| *column).collect();
        Ok((variables?, Points::Rows { path, columns }, count))
    }

    fn sampled(file: &PlanFile, document: &Document) -> Result<(Vec<Variable>, Points, u64), StudyError> {
        let mut variables = Vec::new();
        let mut axes = Vec::new();
        for (name, spec) in &file.inputs.0 {
            let variable = Variable::find(document, name)?;
            axes.push(axis(&variable, spec, file.sample == Sample::Grid)?);
            variables.push(variable);
        }
        if variables.is_empty() {
            return Err(StudyError::Plan("it names no inputs".to_owned()));
        }
        if file.sample == Sample::Grid {
            let lists: Vec<Vec<Cell>> =
                axes.into_iter().zip(&variables).map(|(axis, v)| axis.values(v)).collect();
            let count = lists.iter().try_fold(1_u64, |n, list| n.checked_mul(list.len() as u64));
            return Ok((variables, Points::Grid(lists), count.unwrap_or(u64::MAX)));
        }
        let count = file.points.filter(|n| *n > 0);
        let count = count.ok_or_else(|| StudyError::Plan("'points' says how many".to_owned()))?;
        let seed = file.seed;
        let points = match file.sample {
            Sample::Sobol if axes.len() > sobol::DIMENSIONS => {
                return Err(StudyError::Plan(format!(
                    "Sobol points have at most {} inputs",
                    sobol::DIMENSIONS
                )));
            }
            Sample::Sobol => Points::Sobol { axes, seed },
            _ => Points::LatinHypercube { axes, seed },
        };
        Ok((variables, points, count))
    }

    /// The variables, in the order of the cells of points.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The outputs.
    pub fn outputs(&self) -> &[Output] {
        &self.outputs
    }

    /// How many points there are.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// The points in order, with values as the inputs round them. Nothing but the one at hand is held in memory.
    ///
    /// # Errors
    /// The file with the points cannot be read; so may each point then.
    pub fn points(&self) -> Result<PlanPoints<'_>, StudyError> {
        let fitted = |cells: Vec<Cell>| -> Vec<Cell> {
            self.variables.iter().zip(cells).map(|(variable, cell)| variable.fitted(cell)).collect()
        };
        Ok(match &self.points {
            Points::Grid(lists) => {
                Box::new((0..self.count).map(move |k| Ok(fitted(sampling::grid(lists, k)))))
            }
            Points::LatinHypercube { axes, seed } => {
                let plan = sampling::LatinHypercube::new(axes.len(), self.count, *seed);
                Box::new((0..self.count).map(move |k| Ok(fitted(sampling::placed(axes, &plan.point(k))))))
            }
            Points::Sobol { axes, seed } => {
                let points = sobol::Sobol::new(axes.len(), *seed);
                Box::new((0..self.count).map(move |k| Ok(fitted(sampling::placed(axes, &points.point(k))))))
            }
            Points::Listed(points) => Box::new(points.iter().cloned().map(Ok)),
            Points::Rows { path, columns } => {
                let rows = rows::read(path, columns.clone())?;
                Box::new(rows.map(move |row| row.map(&fitted)))
            }
        })
    }
}

impl Axis {
    /// The values of a grid along it.
    #[allow(clippy::cast_precision_loss, reason = "there are at most a million")]
    fn values(self, variable: &Variable) -> Vec<Cell> {
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
fn axis(variable: &Variable, spec: &InputPlan, grid: bool) -> Result<Axis, StudyError> {
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

#[cfg(test)]
mod tests;
