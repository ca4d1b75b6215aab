use crate::chunk_path::ChunkPath;

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
    #[error("this is not a .3dm archive: at byte 0 begins {begins:?}, and no .3dm header follows")]
    NotAnArchive {
        /// The first bytes as text, as far as they are printable.
        begins: String,
    },
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
    /// Another error, and the chunks around the place it is about.
    #[error("{source} (in {path})")]
    InChunk {
        /// The chunks, outermost first.
        path: ChunkPath,
        /// What is wrong there.
        source: Box<Error>,
    },
    /// The destination of a write failed.
    #[error("writing the archive: {0}")]
    Io(#[from] std::io::Error),
}

impl Error {
    /// The byte it is about, counted from the first byte given; nothing for errors that are not about a place.
    pub fn offset(&self) -> Option<usize> {
        match self {
            Self::Truncated { offset, .. }
            | Self::Malformed { offset, .. }
            | Self::TooDeep { offset, .. }
            | Self::TooLarge { offset, .. }
            | Self::Geometry { offset, .. } => Some(*offset),
            Self::InChunk { source, .. } => source.offset(),
            Self::NotAnArchive { .. } => Some(0),
            Self::UnsupportedVersion(_) | Self::CannotWrite { .. } | Self::Io(_) => None,
        }
    }

    /// The chunks around that byte, outermost first, when it was found in an archive.
    pub fn path(&self) -> Option<&ChunkPath> {
        if let Self::InChunk { path, .. } = self { Some(path) } else { None }
    }

    /// What is wrong, without the chunks around it.
    pub fn reason(&self) -> &Self {
        if let Self::InChunk { source, .. } = self { source.reason() } else { self }
    }

    /// Whether the bytes are whole, but hold what is no geometry.
    pub(crate) fn is_of_geometry(&self) -> bool {
        matches!(self.reason(), Self::Geometry { .. } | Self::Malformed { .. })
    }

    /// The same error about another byte.
    pub(crate) fn moved_to(mut self, at: usize) -> Self {
        match &mut self {
            Self::Truncated { offset, .. }
            | Self::Malformed { offset, .. }
            | Self::TooDeep { offset, .. }
            | Self::TooLarge { offset, .. }
            | Self::Geometry { offset, .. } => *offset = at,
            _ => {}
        }
        self
    }

    /// [`Error::Malformed`] in one call.
    pub(crate) fn malformed(offset: usize, what: &'static str, why: impl Into<String>) -> Self {
        Self::Malformed { offset, what, why: why.into() }
    }

    /// The kernel's refusal of a class read at `offset`.
    pub(crate) fn geometry(offset: usize, what: &'static str, source: katydid_geometry::Error) -> Self {
        Self::Geometry { offset, what, source }
    }
}

/// Something in an archive that did not stop the reading.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Warning {
    /// Offset of what it concerns, from the first byte given.
    pub offset: usize,
    /// The chunks around that offset, outermost first.
    pub path: ChunkPath,
    /// What it means for the model.
    pub kind: WarningKind,
    /// What is wrong.
    pub message: String,
}

/// What a warning means for the model.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum WarningKind {
    /// Something broken is not in the model.
    LeftOut,
    /// An object that the kernel refuses is in the model as its bytes.
    Kept,
    /// Bytes were read although their checksum does not fit: they may be wrong.
    Checksum,
    /// Nothing is lost.
    Odd,
}

impl std::fmt::Display for Warning {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "at byte {}: {}", self.offset, self.message)?;
        if self.path.is_empty() { Ok(()) } else { write!(f, " (in {})", self.path) }
    }
}
