use std::path::Path;

use katydid_session::InputError;

/// Why a study could not be made or go on.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum StudyError {
    /// An input could not be found or set.
    #[error("{0}")]
    Input(#[from] InputError),
    /// An output could not be found.
    #[error("{0}")]
    Output(String),
    /// The plan makes no sense.
    #[error("the plan: {0}")]
    Plan(String),
    /// A file could not be read or written.
    #[error("{0}")]
    File(String),
    /// What was asked for cannot be done with this definition.
    #[error("{0}")]
    Unfit(String),
    /// Somebody asked to stop.
    #[error("stopped; the same command goes on where it stopped")]
    Stopped,
}

impl StudyError {
    /// A file that could not be read or written.
    pub(crate) fn file(path: &Path, error: impl std::fmt::Display) -> Self {
        Self::File(format!("{}: {error}", path.display()))
    }
}
