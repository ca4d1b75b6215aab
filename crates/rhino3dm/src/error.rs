/// The crate's result.
pub type Result<T> = std::result::Result<T, Error>;

/// Why an archive or an object could not be read or written. Offsets count from the first byte given.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The bytes stop before a thing is complete.
    #[error("at byte {offset}: {what} needs {needed} bytes, but {left} are left")]
    Truncated {
        /// Where the thing begins.
        offset: usize,
        /// The thing.
        what: &'static str,
        /// Bytes it needs.
        needed: u64,
        /// Bytes there are.
        left: u64,
    },
    /// The bytes are there but do not make sense.
    #[error("at byte {offset}: {what}: {why}")]
    Malformed {
        /// Where the thing begins.
        offset: usize,
        /// The thing.
        what: &'static str,
        /// What is wrong with it.
        why: String,
    },
    /// Chunks nested deeper than [`Limits::depth`](crate::Limits::depth).
    #[error("at byte {offset}: chunks are nested more than {limit} deep")]
    TooDeep {
        /// Where the chunk begins.
        offset: usize,
        /// The limit.
        limit: usize,
    },
    /// A compressed buffer that would pass [`Limits::inflated`](crate::Limits::inflated).
    #[error("at byte {offset}: a compressed buffer of {size} bytes passes the limit of {limit} bytes")]
    TooLarge {
        /// Where the buffer begins.
        offset: usize,
        /// Its size once inflated.
        size: u64,
        /// Bytes still allowed.
        limit: u64,
    },
    /// The bytes hold no .3dm header.
    #[error("this is not a .3dm archive: its header is missing")]
    NotAnArchive,
    /// An archive version this crate does not read or write.
    #[error("version {0} is not supported yet")]
    UnsupportedVersion(i32),
    /// The numbers are read, but the kernel refuses them.
    #[error("at byte {offset}: {what}: {source}")]
    Geometry {
        /// Where the object begins.
        offset: usize,
        /// The class.
        what: &'static str,
        /// The kernel's reason.
        source: katydid_geometry::Error,
    },
    /// An object that the wanted archive version cannot carry as it is.
    #[error("{what} cannot be written to a version {version} archive: {why}")]
    CannotWrite {
        /// The object.
        what: String,
        /// The archive version asked for.
        version: i32,
        /// The reason.
        why: String,
    },
    /// The destination of a write failed.
    #[error("writing the archive: {0}")]
    Io(#[from] std::io::Error),
}

impl Error {
    /// [`Error::Malformed`] in one call.
    pub(crate) fn malformed(offset: usize, what: &'static str, why: impl Into<String>) -> Self {
        Self::Malformed { offset, what, why: why.into() }
    }

    /// The kernel's refusal of a class read at `offset`.
    pub(crate) fn geometry(offset: usize, what: &'static str, source: katydid_geometry::Error) -> Self {
        Self::Geometry { offset, what, source }
    }
}

/// Something odd in an archive that did not stop the reading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Warning {
    /// Offset of the chunk it concerns, from the first byte given.
    pub offset: usize,
    /// What is odd.
    pub message: String,
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "at byte {}: {}", self.offset, self.message)
    }
}
