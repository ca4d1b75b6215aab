/// The crate's result.
pub type Result<T> = std::result::Result<T, Error>;

/// Why a file could not be written or read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The destination failed.
    #[error("writing the file: {0}")]
    Io(#[from] std::io::Error),
    /// Bytes that are no exchange structure.
    #[error("line {line}: {why}")]
    Syntax {
        /// The line, from 1.
        line: usize,
        /// What is wrong there.
        why: String,
    },
    /// An entity that does not say what it should.
    #[error("#{id}: {why}")]
    Entity {
        /// Its name in the file.
        id: u64,
        /// What is wrong with it.
        why: String,
    },
    /// More than is read of a file that nobody vouches for.
    #[error("the file is too large: {0}")]
    TooLarge(String),
    /// The kernel refused a shape.
    #[error(transparent)]
    Geometry(#[from] katydid_geometry::Error),
}

impl Error {
    /// [`Error::Entity`] in one call.
    pub(crate) fn entity(id: u64, why: impl Into<String>) -> Self {
        Self::Entity { id, why: why.into() }
    }
}
