//! The file of a plan.

use std::fmt;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use serde::de::{MapAccess, Visitor};

use crate::StudyError;
use crate::thresholds::MOST_PLAN_BYTES;

/// A plan as its file has it: which inputs, how their values are chosen, which results are kept.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PlanFile {
    /// The inputs in the order of their columns.
    #[serde(default)]
    pub(crate) inputs: Inputs,
    /// How points are chosen.
    #[serde(default)]
    pub(crate) sample: Sample,
    /// How many points, where that is free.
    pub(crate) points: Option<u64>,
    /// What random numbers begin with.
    #[serde(default)]
    pub(crate) seed: u64,
    /// The file whose rows are the points.
    pub(crate) rows: Option<PathBuf>,
    /// The results that are kept; those that the definition marks when there are none.
    #[serde(default)]
    pub(crate) outputs: Vec<String>,
    /// Whether each point gets a picture.
    #[serde(default)]
    pub(crate) pictures: bool,
    /// The extension of the geometry that each point gets.
    pub(crate) geometry: Option<String>,
}

/// How points are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
pub(crate) enum Sample {
    /// All combinations.
    #[default]
    #[serde(rename = "grid")]
    Grid,
    /// Each input's range in as many equal parts as there are points, one point in each.
    #[serde(rename = "latin hypercube")]
    LatinHypercube,
    /// Sobol's sequence.
    #[serde(rename = "sobol")]
    Sobol,
    /// The rows of a file.
    #[serde(rename = "rows")]
    Rows,
}

/// The inputs by name, in the order of the file.
#[derive(Debug, Clone, Default)]
pub(crate) struct Inputs(pub(crate) Vec<(String, InputPlan)>);

/// What an input goes through.
#[derive(Debug, Clone, Deserialize)]
#[serde(untagged)]
pub(crate) enum InputPlan {
    /// These values.
    Values(Vec<serde_json::Value>),
    /// A range; where a limit is left out, the slider's own.
    Range {
        /// Where it begins.
        from: Option<f64>,
        /// Where it ends.
        to: Option<f64>,
        /// How many values a grid has of it.
        steps: Option<u64>,
    },
}

impl PlanFile {
    /// Reads a plan; paths in it start where the file lies.
    ///
    /// # Errors
    /// The file cannot be read or is no plan.
    pub fn read(path: &Path) -> Result<Self, StudyError> {
        let size = std::fs::metadata(path).map_err(|error| StudyError::file(path, error))?.len();
        if size > MOST_PLAN_BYTES {
            return Err(StudyError::file(path, format!("{size} bytes are more than any plan has")));
        }
        let text = std::fs::read_to_string(path).map_err(|error| StudyError::file(path, error))?;
        let mut plan = Self::parse(&text).map_err(|error| StudyError::file(path, error))?;
        if let (Some(rows), Some(folder)) = (&mut plan.rows, path.parent()) {
            *rows = folder.join(&*rows);
        }
        Ok(plan)
    }

    /// Reads a plan from its text.
    ///
    /// # Errors
    /// It is no plan.
    pub fn parse(text: &str) -> Result<Self, StudyError> {
        serde_json::from_str(text).map_err(|error| StudyError::Plan(error.to_string()))
    }
}

impl Inputs {
    pub(crate) fn names(&self) -> Vec<&str> {
        self.0.iter().map(|(name, _)| name.as_str()).collect()
    }
}

impl<'de> Deserialize<'de> for Inputs {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct InOrder;
        impl<'de> Visitor<'de> for InOrder {
            type Value = Inputs;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("an object from the names of inputs to lists of values or {from, to, steps}")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Inputs, A::Error> {
                let mut inputs = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    inputs.push(entry);
                }
                Ok(Inputs(inputs))
            }
        }
        deserializer.deserialize_map(InOrder)
    }
}
