use std::fmt;

/// This crate's result.
pub type Result<T> = std::result::Result<T, Error>;

/// Why a file could not be read, written or edited.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The bytes are something else altogether: a picture, a zip file, a Rhino model.
    #[error("this is {0}, not a Grasshopper file")]
    Foreign(&'static str),
    /// The bytes break the rules of the format.
    #[error("broken at byte {offset} of {place}: {reason}")]
    Archive {
        /// Which bytes the offset counts.
        place: Place,
        /// How many bytes were read before the trouble.
        offset: usize,
        /// What is wrong there.
        reason: String,
    },
    /// The file asks for more than the caller's [`Limits`](crate::archive::Limits) allow.
    #[error("at byte {offset} of {place} {what} exceeds the limit of {limit}")]
    Limit {
        /// What the offset counts in.
        place: Place,
        /// Where the limit was reached.
        offset: usize,
        /// What there is too much of.
        what: &'static str,
        /// The most that is allowed.
        limit: usize,
    },
    /// A tree that the format cannot hold.
    #[error("cannot be written: {0}")]
    Unwritable(String),
    /// The archive is sound but is not the document it should be.
    #[error("{place}: {reason}")]
    Document {
        /// The chunk or object.
        place: String,
        /// What is wrong with it.
        reason: String,
    },
    /// An edit that the object does not take.
    #[error("{object}: {reason}")]
    Edit {
        /// The object, by its name.
        object: String,
        /// Why the edit was refused.
        reason: String,
    },
}

impl Error {
    pub(crate) fn at(place: Place, offset: usize, reason: impl Into<String>) -> Self {
        Self::Archive { place, offset, reason: reason.into() }
    }
}

/// The bytes that an offset counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// The file as it lies on the disk.
    File,
    /// What the file's compressed stream inflates to.
    Inflated,
    /// The XML text, in UTF-8.
    Text,
    /// The .NET object stream around a piece of geometry, inflated.
    OnData,
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::File => "the file",
            Self::Inflated => "the inflated data",
            Self::Text => "the XML text",
            Self::OnData => "the geometry's object stream",
        })
    }
}
