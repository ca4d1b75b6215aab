//! A plan bound to a definition: its inputs and outputs found, its points counted.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use katydid_definition::document::Document;

use super::axis::{Axis, axis};
use super::file::{PlanFile, Sample};
use super::{rows, sampling, sobol};
use crate::thresholds::MOST_POINTS;
use crate::{Cell, Output, StudyError, Variable, marked};

/// A plan bound to a definition: its points can be asked for again and again, always the same.
#[derive(Debug, Clone)]
pub struct Plan {
    variables: Arc<[Variable]>,
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
    Grid(Arc<[Vec<Cell>]>),
    LatinHypercube { axes: Arc<[Axis]>, seed: u64 },
    Sobol { axes: Arc<[Axis]>, seed: u64 },
    Rows { path: PathBuf, columns: Vec<usize> },
    Listed(Arc<[Vec<Cell>]>),
}

/// The points of a plan one by one: a cell for each input, or why a row of a file is none.
pub type PlanPoints = Box<dyn Iterator<Item = Result<Vec<Cell>, StudyError>> + Send>;

impl Plan {
    /// Binds a plan to a definition: finds its inputs and outputs, and counts its points.
    ///
    /// # Errors
    /// An input or output is not there, or the plan makes no sense for it.
    pub fn bind(file: &PlanFile, document: &Document) -> Result<Self, StudyError> {
        let outputs = Self::kept(file, document)?;
        let (variables, points, count) = match file.sample {
            Sample::Rows => Self::rows(file, document)?,
            Sample::Grid | Sample::LatinHypercube | Sample::Sobol => Self::sampled(file, document)?,
        };
        distinct(&variables)?;
        if count > MOST_POINTS {
            return Err(StudyError::Plan(format!("{count} points are more than {MOST_POINTS}")));
        }
        Ok(Self {
            variables: variables.into(),
            outputs,
            points,
            count,
            pictures: file.pictures,
            geometry: file.geometry.clone(),
        })
    }

    /// The inputs and outputs of a plan without its points: for whoever is given them one by one, or has others. The inputs are
    /// those of these names, or without any those that the plan names.
    ///
    /// # Errors
    /// An input or output is not there, or is named twice.
    pub fn space(file: &PlanFile, document: &Document, names: &[String]) -> Result<Self, StudyError> {
        let outputs = Self::kept(file, document)?;
        let names =
            if names.is_empty() { file.inputs.names() } else { names.iter().map(String::as_str).collect() };
        let variables: Vec<Variable> =
            names.into_iter().map(|name| Variable::find(document, name)).collect::<Result<_, _>>()?;
        if variables.is_empty() {
            return Err(StudyError::Plan("it names no inputs".to_owned()));
        }
        distinct(&variables)?;
        let (pictures, geometry) = (file.pictures, file.geometry.clone());
        Ok(Self { pictures, geometry, ..Self::listed(variables, outputs, Vec::new()) })
    }

    /// The same plan with other points: values as the inputs round them.
    #[must_use]
    pub fn with_points(&self, points: Vec<Vec<Cell>>) -> Self {
        Self { count: points.len() as u64, points: Points::Listed(points.into()), ..self.clone() }
    }

    /// The outputs that a plan names, or those that the definition marks.
    fn kept(file: &PlanFile, document: &Document) -> Result<Vec<Output>, StudyError> {
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
        Ok(outputs)
    }

    /// The plan of points that are known, with values as the inputs round them.
    pub(crate) fn listed(variables: Vec<Variable>, outputs: Vec<Output>, points: Vec<Vec<Cell>>) -> Self {
        let count = points.len() as u64;
        Self {
            variables: variables.into(),
            outputs,
            points: Points::Listed(points.into()),
            count,
            pictures: false,
            geometry: None,
        }
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
            return Ok((variables, Points::Grid(lists.into()), count.unwrap_or(u64::MAX)));
        }
        let count = file.points.filter(|n| *n > 0);
        let count = count.ok_or_else(|| StudyError::Plan("'points' says how many".to_owned()))?;
        let seed = file.seed;
        let axes: Arc<[Axis]> = axes.into();
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
    pub fn points(&self) -> Result<PlanPoints, StudyError> {
        let variables = Arc::clone(&self.variables);
        let fitted = move |cells: Vec<Cell>| -> Vec<Cell> {
            variables.iter().zip(cells).map(|(variable, cell)| variable.fitted(cell)).collect()
        };
        let numbers = 0..self.count;
        Ok(match &self.points {
            Points::Grid(lists) => {
                let lists = Arc::clone(lists);
                Box::new(numbers.map(move |k| Ok(fitted(sampling::grid(&lists, k)))))
            }
            Points::LatinHypercube { axes, seed } => {
                let (axes, plan) =
                    (Arc::clone(axes), sampling::LatinHypercube::new(axes.len(), self.count, *seed));
                Box::new(numbers.map(move |k| Ok(fitted(sampling::placed(&axes, &plan.point(k))))))
            }
            Points::Sobol { axes, seed } => {
                let (axes, points) = (Arc::clone(axes), sobol::Sobol::new(axes.len(), *seed));
                Box::new(numbers.map(move |k| Ok(fitted(sampling::placed(&axes, &points.point(k))))))
            }
            Points::Listed(points) => {
                let points = Arc::clone(points);
                Box::new((0..points.len()).map_while(move |k| points.get(k).cloned().map(Ok)))
            }
            Points::Rows { path, columns } => {
                let rows = rows::read(path, columns.clone())?;
                Box::new(rows.map(move |row| row.map(&fitted)))
            }
        })
    }
}

/// The points of a study's table.
///
/// # Errors
/// The file cannot be read, or has no column of an input.
pub(crate) fn rows_of(path: &Path, names: &[&str]) -> Result<Vec<Vec<Cell>>, StudyError> {
    let (header, _) = rows::look(path)?;
    let columns = rows::columns(&header, names)?.into_iter().map(|(column, _)| column).collect();
    rows::read(path, columns)?.collect()
}

/// Refuses two inputs of one name.
fn distinct(variables: &[Variable]) -> Result<(), StudyError> {
    for (at, variable) in variables.iter().enumerate() {
        if variables.iter().take(at).any(|other| other.name == variable.name) {
            return Err(StudyError::Plan(format!("the input '{}' is named twice", variable.name)));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests;
