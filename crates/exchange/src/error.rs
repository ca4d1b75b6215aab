/// The crate's result.
pub type Result<T> = std::result::Result<T, Error>;

/// Why a file could not be written or read.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The destination failed.
    #[error("writing the file: {0}")]
    Io(#[from] std::io::Error),
    /// A coordinate is NaN or infinite, or too large for the numbers of the format.
    #[error("{what} has a coordinate that {format} cannot hold: {value}")]
    Coordinate {
        /// The thing, by name or place.
        what: String,
        /// The format.
        format: &'static str,
        /// The coordinate.
        value: f64,
    },
    /// More than the format can count.
    #[error("{format} cannot hold {what}")]
    TooLarge {
        /// The format.
        format: &'static str,
        /// What is too large.
        what: String,
    },
    /// A file that does not keep to its format.
    #[error("this is no {format} file that can be read: {place}: {why}")]
    Malformed {
        /// The format.
        format: &'static str,
        /// Line or byte, in words.
        place: String,
        /// What is wrong there.
        why: String,
    },
    /// Something in a file that is not read, by name.
    #[error("not supported: {0}")]
    Unsupported(String),
}

impl Error {
    /// [`Error::Malformed`] in one call.
    pub(crate) fn malformed(format: &'static str, place: impl Into<String>, why: impl Into<String>) -> Self {
        Self::Malformed { format, place: place.into(), why: why.into() }
    }
}
