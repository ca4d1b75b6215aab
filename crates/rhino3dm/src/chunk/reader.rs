use super::context::{Context, OpenChunk};
use crate::crc::{Crc16, RunningCrc};
use crate::version::Version;
use crate::{Error, Result, typecode};

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
    /// In version 1: the CRC of the chunk's own bytes so far, and up to where it goes.
    crc16: Option<(Crc16, usize)>,
    /// The chunk that this is the body of, for messages.
    chunk: Option<OpenChunk>,
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
            crc16: None,
            chunk: None,
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

    /// Passes over one chunk without opening it; gives its typecode. Nothing when its extent passes the end.
    pub(crate) fn hop(&mut self) -> Option<u32> {
        let typecode = u32::from_le_bytes(self.array("chunk typecode").ok()?);
        let value = if self.version.is_wide() {
            i64::from_le_bytes(self.array("chunk length").ok()?)
        } else {
            i64::from(u32::from_le_bytes(self.array("chunk length").ok()?))
        };
        if typecode & typecode::SHORT == 0 {
            self.take(usize::try_from(value).ok()?, "chunk body").ok()?;
        }
        Some(typecode)
    }

    /// The same reader over other bytes that begin where its own do.
    pub(crate) fn over(&self, data: &'a [u8]) -> Self {
        Self { data, stored_crc: None, ..self.clone() }
    }

    /// Goes to an offset that this reader has passed or not, if it lies in its bytes.
    pub(crate) fn go_to(&mut self, offset: usize) {
        self.position = offset.saturating_sub(self.base).min(self.data.len());
        self.crc.skip_to(self.position);
    }

    /// The next chunk although its body is cut short: its body is all there is. Nothing when even its header is
    /// not there, or when it is a short chunk.
    pub(crate) fn cut_chunk(&mut self) -> Option<Chunk<'a>> {
        let offset = self.offset();
        let typecode = self.peek_typecode().filter(|typecode| typecode & typecode::SHORT == 0)?;
        self.take(if self.version.is_wide() { 12 } else { 8 }, "chunk header").ok()?;
        let base = self.offset();
        let whole = self.rest();
        let chunk = self.context.open(typecode, offset, self.offset(), self.chunk);
        let body = Reader {
            data: whole,
            position: 0,
            base,
            depth: self.depth + 1,
            stored_crc: None,
            chunk,
            ..self.clone()
        };
        Some(Chunk { typecode, value: i64::try_from(whole.len()).unwrap_or(i64::MAX), offset, body, whole })
    }

    /// The next chunk; this reader goes on behind it.
    pub(crate) fn chunk(&mut self) -> Result<Chunk<'a>> {
        let offset = self.offset();
        // The bytes up to here are this chunk's own; those of the nested one are not.
        self.take_in();
        let typecode = u32::from_le_bytes(self.array("chunk typecode")?);
        let first = self.version.archive == 1;
        let mut short = typecode & typecode::SHORT != 0;
        let value = if self.version.is_wide() {
            i64::from_le_bytes(self.array("chunk length")?)
        } else {
            let bytes = self.array("chunk length")?;
            let signed = i32::from_le_bytes(bytes);
            // In version 1 a length below zero, or the typecode zero, make a short chunk.
            short |= first && (typecode == 0 || signed < 0);
            if short && !typecode::is_unsigned_short(typecode) {
                i64::from(signed)
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
            if !first && typecode & typecode::CRC != 0 {
                let Some((body, crc)) = data.split_last_chunk::<4>() else {
                    return Err(Error::malformed(offset, "chunk", "it is too short for its CRC"));
                };
                data = body;
                stored_crc = Some(u32::from_le_bytes(*crc));
            }
        }
        self.leave_out();
        let crc16 = (first && typecode::has_crc16(typecode)).then_some((Crc16::START, 0));
        let body = Reader {
            data,
            position: 0,
            base,
            depth,
            crc: RunningCrc::default(),
            stored_crc,
            crc16,
            chunk: self.context.open(typecode, offset, self.offset(), self.chunk),
            version: self.version,
            context: self.context,
        };
        Ok(Chunk { typecode, value, offset, body, whole })
    }

    /// Takes the chunk's own bytes read so far into its CRC.
    fn take_in(&mut self) {
        self.crc.feed(self.data, self.position);
        if let Some((crc, fed)) = &mut self.crc16 {
            *crc = crc.and(self.data.get(*fed..self.position).unwrap_or_default());
            *fed = self.position;
        }
    }

    /// Leaves a nested chunk out of the CRC.
    fn leave_out(&mut self) {
        self.crc.skip_to(self.position);
        if let Some((_, fed)) = &mut self.crc16 {
            *fed = self.position;
        }
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
        if self.crc16.is_some() {
            self.finish_crc16();
        }
        let Some(stored) = self.stored_crc else { return };
        if !self.is_at_end() {
            return;
        }
        self.crc.feed(self.data, self.position);
        let found = self.crc.value();
        if found != stored {
            self.context.bad_crc(
                self.base,
                format!("CRC mismatch: the chunk stores {stored:08X}, its bytes give {found:08X}"),
            );
        }
    }

    /// Chunks of version 1 have a CRC when two bytes are left of them.
    fn finish_crc16(&mut self) {
        if self.left() != 2 {
            return;
        }
        self.take_in();
        let rest = self.rest();
        if self.crc16.is_some_and(|(crc, _)| !crc.and(rest).is_right()) {
            self.context.bad_crc(self.base, "CRC mismatch in a chunk of version 1");
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
