//! Studies: points handed out, solved and kept. What users see is the Python module `katydid.studies`.

mod cells;
mod host;
mod solver;

use std::ffi::OsString;
use std::path::PathBuf;

use katydid_cli::{CallFiles, SweepCall};
use katydid_study::StudyError;
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;

pub(crate) use host::StudyCore;
pub(crate) use solver::StudySolver;

use crate::errors::{FileError, InputError, KatydidError};

/// The files of a study, as Python has them: definition, model, plan.
type Files = (PathBuf, Option<PathBuf>, PathBuf);

/// Opens what the words of `katydid sweep` name.
fn opened(words: Vec<OsString>, files: Option<Files>) -> PyResult<SweepCall> {
    let files = files.map(|(definition, model, plan)| CallFiles { definition, model, plan });
    SweepCall::open(words, files).map_err(KatydidError::new_err)
}

fn failed(error: StudyError) -> PyErr {
    let text = error.to_string();
    match error {
        StudyError::Input(_) | StudyError::Output(_) | StudyError::Plan(_) => InputError::new_err(text),
        StudyError::File(_) => FileError::new_err(text),
        StudyError::Stopped => PyKeyboardInterrupt::new_err(text),
        _ => KatydidError::new_err(text),
    }
}
