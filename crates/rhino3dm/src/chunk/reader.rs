use std::cell::{Cell, RefCell};

use crate::crc::RunningCrc;
use crate::version::Version;
use crate::{Error, Limits, Result, Warning, typecode};

/// What all readers of one archive share: the limits, what they have used of them, and the warnings.
#[derive(Debug)]
pub(crate) struct Context {
    pub(crate) limits: Limits,
    inflated: Cell<u64>,
    warnings: RefCell<Vec<Warning>>,
}

impl Context {
    pub(crate) fn new(limits: &Limits) -> Self {
        Self { limits: limits.clone(), inflated: Cell::new(0), warnings: RefCell::default() }
    }

    /// Notes something odd, up to the number of warnings the limits allow.
    pub(crate) fn warn(&self, offset: usize, message: impl Into<String>) {
        let mut warnings = self.warnings.borrow_mut();
        if warnings.len() < self.limits.warnings {
            warnings.push(Warning { offset, message: message.into() });
        }
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
}

/// One chunk, its header read and its extent known to lie within the bytes.
#[derive(Debug)]
pub(crate) struct Chunk<'a> {
    pub(crate) typecode: u32,
    /// The data of a short chunk; the body length of a long one.
    pub(crate) value: i64,
    /// Where its header begins.
    pub(crate) offset: usize,
    /// Its body without the CRC; nothing in a short chunk.
    pub(crate) body: Reader<'a>,
    /// Its body with the CRC, verbatim.
    pub(crate) whole: &'a [u8],
}

/// Reads the body of one chunk (or a whole archive) from front to back, never past its end.
///
/// A child's extent is consumed when [`Reader::chunk`] gives it out, so leaving a child half read is safe:
/// that is how fields of newer versions are skipped.
#[derive(Debug, Clone)]
pub(crate) struct Reader<'a> {
    data: &'a [u8],
    position: usize,
    base: usize,
    depth: usize,
    crc: RunningCrc,
    stored_crc: Option<u32>,
    version: Version,
    context: &'a Context,
}

impl<'a> Reader<'a> {
    /// A reader over bytes that are not in a chunk: an archive, or an object from elsewhere.
    pub(crate) fn new(data: &'a [u8], version: Version, context: &'a Context) -> Self {
        Self {
            data,
            position: 0,
            base: 0,
            depth: 0,
            crc: RunningCrc::default(),
            stored_crc: None,
            version,
            context,
        }
    }

    /// The same, its offsets counted from `base`.
    pub(crate) fn new_at(data: &'a [u8], base: usize, version: Version, context: &'a Context) -> Self {
        Self { base, ..Self::new(data, version, context) }
    }

    pub(crate) fn version(&self) -> Version {
        self.version
    }

    /// Reads on under another version: archives tell theirs only after the first chunks, and user data
    /// brings its own.
    pub(crate) fn set_version(&mut self, version: Version) {
        self.version = version;
    }

    pub(crate) fn context(&self) -> &'a Context {
        self.context
    }

    /// Where the next byte stands, counted from the first byte of the archive.
    pub(crate) fn offset(&self) -> usize {
        self.base.saturating_add(self.position)
    }

    /// Bytes not read yet.
    pub(crate) fn left(&self) -> usize {
        self.data.len().saturating_sub(self.position)
    }

    pub(crate) fn is_at_end(&self) -> bool {
        self.left() == 0
    }

    /// The next `count` bytes.
    pub(crate) fn take(&mut self, count: usize, what: &'static str) -> Result<&'a [u8]> {
        let bytes =
            self.position.checked_add(count).and_then(|end| self.data.get(self.position..end)).ok_or(
                Error::Truncated {
                    offset: self.offset(),
                    what,
                    needed: count as u64,
                    left: self.left() as u64,
                },
            )?;
        self.position += count;
        Ok(bytes)
    }

    /// The next `N` bytes as an array.
    pub(crate) fn array<const N: usize>(&mut self, what: &'static str) -> Result<[u8; N]> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N, what)?);
        Ok(array)
    }

    /// All bytes not read yet.
    pub(crate) fn rest(&mut self) -> &'a [u8] {
        let bytes = self.data.get(self.position..).unwrap_or_default();
        self.position = self.data.len();
        bytes
    }

    /// The bytes of this body from one offset to another, both as [`Reader::offset`] gave them.
    pub(crate) fn between(&self, start: usize, end: usize) -> &'a [u8] {
        self.data.get(start.saturating_sub(self.base)..end.saturating_sub(self.base)).unwrap_or_default()
    }

    /// The typecode of the next chunk, if four bytes are left; nothing is consumed.
    pub(crate) fn peek_typecode(&self) -> Option<u32> {
        let end = self.position.checked_add(4)?;
        let bytes = self.data.get(self.position..end)?;
        Some(u32::from_le_bytes(bytes.try_into().ok()?))
    }

    /// The next chunk; this reader goes on behind it.
    pub(crate) fn chunk(&mut self) -> Result<Chunk<'a>> {
        let offset = self.offset();
        // The bytes up to here are this chunk's own; those of the nested one are not.
        self.crc.feed(self.data, self.position);
        let typecode = u32::from_le_bytes(self.array("chunk typecode")?);
        let short = typecode & typecode::SHORT != 0;
        let value = if self.version.is_wide() {
            i64::from_le_bytes(self.array("chunk length")?)
        } else {
            let bytes = self.array("chunk length")?;
            if short && !typecode::is_unsigned_short(typecode) {
                i64::from(i32::from_le_bytes(bytes))
            } else {
                i64::from(u32::from_le_bytes(bytes))
            }
        };
        let depth = self.depth + 1;
        if depth > self.context.limits.depth {
            return Err(Error::TooDeep { offset, limit: self.context.limits.depth });
        }
        let base = self.offset();
        let mut stored_crc = None;
        let mut data: &[u8] = &[];
        let mut whole = data;
        if !short {
            let length = usize::try_from(value)
                .map_err(|_| Error::malformed(offset, "chunk length", format!("{value} is no length")))?;
            data = self.take(length, "chunk body")?;
            whole = data;
            // Version 1 marks its CRCs otherwise; it is not read.
            if typecode & typecode::CRC != 0 {
                let Some((body, crc)) = data.split_last_chunk::<4>() else {
                    return Err(Error::malformed(offset, "chunk", "it is too short for its CRC"));
                };
                data = body;
                stored_crc = Some(u32::from_le_bytes(*crc));
            }
        }
        self.crc.skip_to(self.position);
        let body = Reader {
            data,
            position: 0,
            base,
            depth,
            crc: RunningCrc::default(),
            stored_crc,
            version: self.version,
            context: self.context,
        };
        Ok(Chunk { typecode, value, offset, body, whole })
    }

    /// The body of the next chunk, which must have the given typecode.
    pub(crate) fn expect(&mut self, typecode: u32, what: &'static str) -> Result<Reader<'a>> {
        let chunk = self.chunk()?;
        if chunk.typecode != typecode {
            return Err(Error::malformed(
                chunk.offset,
                what,
                format!("a chunk {typecode:08X} should stand here, not {:08X}", chunk.typecode),
            ));
        }
        Ok(chunk.body)
    }

    /// The body of the next anonymous chunk that begins with a version, and its major and minor number.
    pub(crate) fn versioned(&mut self, what: &'static str) -> Result<(Reader<'a>, i32, i32)> {
        let mut body = self.expect(typecode::ANONYMOUS, what)?;
        let major = body.i32(what)?;
        let minor = body.i32(what)?;
        Ok((body, major, minor))
    }

    /// The body of the next anonymous chunk, whose major version must be 1, and its minor version.
    pub(crate) fn versioned_1(&mut self, what: &'static str) -> Result<(Reader<'a>, i32)> {
        let offset = self.offset();
        let (body, major, minor) = self.versioned(what)?;
        if major != 1 {
            return Err(Error::malformed(offset, what, format!("major version {major} is not known")));
        }
        Ok((body, minor))
    }

    /// Ends the reading of a chunk: when all of it was read, its CRC is compared and a difference noted.
    /// A chunk left half read cannot be checked, since its nested chunks are not known.
    pub(crate) fn finish(mut self) {
        let Some(stored) = self.stored_crc else { return };
        if !self.is_at_end() {
            return;
        }
        self.crc.feed(self.data, self.position);
        let found = self.crc.value();
        if found != stored {
            self.context.warn(
                self.base,
                format!("CRC mismatch: the chunk stores {stored:08X}, its bytes give {found:08X}"),
            );
        }
    }

    /// A count of items of at least `item_bytes` each, checked against the bytes left.
    pub(crate) fn count(&mut self, item_bytes: usize, what: &'static str) -> Result<usize> {
        let offset = self.offset();
        let count = self.i32(what)?;
        let count = usize::try_from(count)
            .map_err(|_| Error::malformed(offset, what, format!("{count} is no count")))?;
        self.check_count(count, item_bytes, what)?;
        Ok(count)
    }

    /// Refuses a count whose items cannot fit into the bytes left.
    pub(crate) fn check_count(&self, count: usize, item_bytes: usize, what: &'static str) -> Result<()> {
        let needed = (count as u64).saturating_mul(item_bytes as u64);
        if needed > self.left() as u64 {
            return Err(Error::Truncated { offset: self.offset(), what, needed, left: self.left() as u64 });
        }
        Ok(())
    }
}
