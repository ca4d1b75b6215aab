use std::cell::{Cell, RefCell};

use crate::chunk_path::ChunkPath;
use crate::{Error, Limits, Result, Warning, WarningKind, typecode};

/// How much compressed buffers may inflate to whatever the size of the archive.
const FREE_INFLATION: u64 = 128 << 20;

/// Chunks of one record that messages tell apart.
const MOST_OPENED: u32 = 1 << 16;

/// What all readers of one archive share: the limits, what they have used of them, and the warnings.
#[derive(Debug)]
pub(crate) struct Context {
    pub(crate) limits: Limits,
    /// Whether meshes that are kept beside breps are passed over: whoever computes with a brep makes its own.
    shapes_alone: bool,
    /// Whether the first broken thing ends the reading.
    strict: bool,
    /// The first broken thing, when strict.
    failure: RefCell<Option<Error>>,
    inflated: Cell<u64>,
    warnings: RefCell<Vec<Warning>>,
    /// The chunks opened since the last record was done with, for messages.
    opened: RefCell<Vec<Opened>>,
}

/// A chunk that was opened: its place in the list of [`Context`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct OpenChunk(u32);

/// Typecode and extent of a chunk, and the chunk around it.
#[derive(Debug, Clone, Copy)]
struct Opened {
    typecode: u32,
    start: usize,
    end: usize,
    parent: Option<OpenChunk>,
}

impl Context {
    /// The context of bytes whose broken parts are left out with a warning.
    pub(crate) fn new(limits: &Limits) -> Self {
        Self {
            limits: limits.clone(),
            shapes_alone: false,
            strict: false,
            failure: RefCell::default(),
            inflated: Cell::new(0),
            warnings: RefCell::default(),
            opened: RefCell::default(),
        }
    }

    /// The context of a brep of which only the shape is asked for.
    pub(crate) fn of_shape(limits: &Limits) -> Self {
        Self { shapes_alone: true, ..Self::new(limits) }
    }

    /// The context of a whole archive of so many bytes.
    pub(crate) fn of_archive(limits: &Limits, bytes: usize, strict: bool) -> Self {
        let mut context = Self { strict, ..Self::new(limits) };
        let by_size = (bytes as u64).saturating_mul(limits.inflation).max(FREE_INFLATION);
        context.limits.inflated = limits.inflated.min(by_size);
        context
    }

    /// Whether meshes that are kept beside breps are passed over.
    pub(crate) fn is_of_shape(&self) -> bool {
        self.shapes_alone
    }

    /// Notes something odd that costs nothing.
    pub(crate) fn warn(&self, offset: usize, message: impl Into<String>) {
        self.note(offset, WarningKind::Odd, message.into());
    }

    /// Notes that something stays as bytes, which carry it as well. Bytes that end too soon are broken.
    pub(crate) fn kept(&self, offset: usize, what: &str, error: Error) {
        if error.is_of_geometry() {
            self.note(offset, WarningKind::Kept, format!("{what} is kept as bytes: {error}"));
        } else {
            self.broken(offset, WarningKind::Kept, &format!("{what} is kept as bytes"), error);
        }
    }

    /// Notes that something broken is left out; strict reading ends with it.
    pub(crate) fn left_out(&self, offset: usize, what: &str, error: Error) {
        self.broken(offset, WarningKind::LeftOut, &format!("{what} left out"), error);
    }

    /// Notes a checksum that does not fit; strict reading ends with it.
    pub(crate) fn bad_crc(&self, offset: usize, message: impl Into<String>) {
        if self.strict {
            self.fail(offset, Error::malformed(offset, "checksum", message));
        } else {
            self.note(offset, WarningKind::Checksum, message.into());
        }
    }

    fn broken(&self, offset: usize, kind: WarningKind, what: &str, error: Error) {
        if self.strict {
            self.fail(offset, error);
        } else {
            let at = error.offset().unwrap_or(offset);
            self.note(at, kind, format!("{what}: {error}"));
        }
    }

    fn fail(&self, offset: usize, error: Error) {
        let mut failure = self.failure.borrow_mut();
        if failure.is_none() {
            *failure = Some(self.with_path(offset, error));
        }
    }

    fn note(&self, offset: usize, kind: WarningKind, message: String) {
        let mut warnings = self.warnings.borrow_mut();
        if warnings.len() < self.limits.warnings {
            warnings.push(Warning { offset, path: self.path_to(offset), kind, message });
        }
    }

    /// An error with the chunks around it.
    pub(crate) fn with_path(&self, offset: usize, error: Error) -> Error {
        if error.path().is_some() {
            return error;
        }
        let path = self.path_to(error.offset().unwrap_or(offset));
        if path.is_empty() { error } else { Error::InChunk { path, source: Box::new(error) } }
    }

    /// The first broken thing as an error, when strict.
    pub(crate) fn check(&self) -> Result<()> {
        self.failure.borrow_mut().take().map_or(Ok(()), Err)
    }

    /// Takes `size` bytes out of the budget for inflated data.
    pub(crate) fn spend_inflated(&self, offset: usize, size: u64) -> Result<()> {
        let limit = self.limits.inflated.saturating_sub(self.inflated.get());
        if size > limit {
            return Err(Error::TooLarge { offset, size, limit });
        }
        self.inflated.set(self.inflated.get().saturating_add(size));
        Ok(())
    }

    /// The warnings so far, in the order they came.
    pub(crate) fn into_warnings(self) -> Vec<Warning> {
        self.warnings.into_inner()
    }

    /// Notes a chunk from its header to its end.
    pub(super) fn open(
        &self,
        typecode: u32,
        start: usize,
        end: usize,
        parent: Option<OpenChunk>,
    ) -> Option<OpenChunk> {
        if typecode & typecode::SHORT != 0 {
            return parent;
        }
        let mut opened = self.opened.borrow_mut();
        let place = match u32::try_from(opened.len()) {
            Ok(place) if place < MOST_OPENED => place,
            // No more are told apart from the chunk around them.
            _ => return parent,
        };
        opened.push(Opened { typecode, start, end, parent });
        Some(OpenChunk(place))
    }

    /// How many chunks are on the list.
    pub(crate) fn opened(&self) -> usize {
        self.opened.borrow().len()
    }

    /// Forgets all chunks after so many: the record they belong to is done with.
    pub(crate) fn forget(&self, opened: usize) {
        self.opened.borrow_mut().truncate(opened);
    }

    /// The chunks around an offset, outermost first.
    fn path_to(&self, offset: usize) -> ChunkPath {
        let opened = self.opened.borrow();
        // The innermost is the shortest of those around it, of equals the one opened last.
        let around = opened.iter().rev().filter(|chunk| chunk.start <= offset && offset <= chunk.end);
        let mut next = around.min_by_key(|chunk| chunk.end - chunk.start);
        let mut path = Vec::new();
        while let Some(chunk) = next.filter(|_| path.len() < self.limits.depth) {
            path.push(chunk.typecode);
            next = chunk.parent.and_then(|parent| opened.get(parent.0 as usize));
        }
        path.reverse();
        ChunkPath(path)
    }
}
