//! What a study is of: `study.json`.

use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

use katydid_session::write_file;
use serde::{Deserialize, Serialize};

use crate::thresholds::MOST_ABOUT_BYTES;
use crate::{Bound, Constraint, Goal, Objective, Output, StudyError, Variable};

/// The name of the file in the study's folder.
const NAME: &str = "study.json";

/// What a study is of, as `study.json` in its folder says. The tables have the results; this has what they do not say.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct About {
    /// The definition, where it is a file.
    #[serde(default)]
    pub definition: Option<DefinitionFile>,
    /// The names of the inputs, in the order of the columns.
    pub inputs: Vec<String>,
    /// The names of the outputs, in the order of the columns.
    pub outputs: Vec<String>,
    /// What an optimisation makes small or large.
    #[serde(default)]
    pub goals: Vec<NamedGoal>,
    /// What must hold in an optimisation.
    #[serde(default)]
    pub bounds: Vec<NamedBound>,
    /// How many points the plan has, or how many a search solves at most.
    pub points: u64,
}

/// The definition of a study, and how it was read.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct DefinitionFile {
    /// The file.
    pub file: PathBuf,
    /// The Rhino model beside it.
    #[serde(default)]
    pub model: Option<PathBuf>,
    /// The length unit that was asked for, as Rhino writes it; else that of the file or the model.
    #[serde(default)]
    pub units: Option<String>,
    /// Inputs that were set for all points.
    #[serde(default)]
    pub set: Vec<(String, String)>,
}

/// A goal with the name of its output.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NamedGoal {
    /// The output.
    pub output: String,
    /// What it is to be.
    pub goal: Goal,
}

/// A bound with the name of its output.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct NamedBound {
    /// The output.
    pub output: String,
    /// The side on which it must stay.
    pub bound: Bound,
}

impl About {
    /// That of a study of these inputs and outputs.
    pub(crate) fn new(
        definition: Option<&DefinitionFile>,
        variables: &[Variable],
        outputs: &[Output],
        points: u64,
    ) -> Self {
        Self {
            definition: definition.cloned(),
            inputs: variables.iter().map(|variable| variable.name.clone()).collect(),
            outputs: outputs.iter().map(|output| output.name.clone()).collect(),
            points,
            ..Self::default()
        }
    }

    /// The same with what a search is for.
    pub(crate) fn searching(mut self, objectives: &[Objective], constraints: &[Constraint]) -> Self {
        let name = |output: usize| self.outputs.get(output).cloned().unwrap_or_default();
        let goals = objectives.iter().map(|one| NamedGoal { output: name(one.output), goal: one.goal });
        let bounds = constraints.iter().map(|one| NamedBound { output: name(one.output), bound: one.bound });
        (self.goals, self.bounds) = (goals.collect(), bounds.collect());
        self
    }

    /// Writes it into a study's folder. A definition whose path is no text is left out.
    ///
    /// # Errors
    /// The file cannot be written.
    pub(crate) fn write(&self, folder: &Path) -> Result<(), StudyError> {
        let path = folder.join(NAME);
        let text = serde_json::to_string_pretty(self)
            .or_else(|_| serde_json::to_string_pretty(&Self { definition: None, ..self.clone() }))
            .map_err(|error| StudyError::file(&path, error))?;
        write_file(&path, format!("{text}\n").as_bytes()).map_err(|error| StudyError::file(&path, error))
    }

    /// Reads it; `None` where the folder has none, as folders of other programs.
    ///
    /// # Errors
    /// It cannot be read, or is none.
    pub(crate) fn read(folder: &Path) -> Result<Option<Self>, StudyError> {
        let path = folder.join(NAME);
        if !fs::metadata(&path).is_ok_and(|about| about.is_file()) {
            return Ok(None);
        }
        let mut text = String::new();
        let file = File::open(&path).map_err(|error| StudyError::file(&path, error))?;
        file.take(MOST_ABOUT_BYTES)
            .read_to_string(&mut text)
            .map_err(|error| StudyError::file(&path, error))?;
        serde_json::from_str(&text).map(Some).map_err(|error| StudyError::file(&path, error))
    }
}
