use crate::crc::RunningCrc;
use crate::version::Version;
use crate::{Error, Result, typecode};

/// Writes chunks into memory. Lengths and CRCs are filled in when a chunk ends.
#[derive(Debug)]
pub(crate) struct Writer {
    out: Vec<u8>,
    version: Version,
    /// One running CRC per open chunk, innermost last.
    open: Vec<RunningCrc>,
}

impl Writer {
    pub(crate) fn new(version: Version) -> Self {
        Self { out: Vec::new(), version, open: Vec::new() }
    }

    pub(crate) fn version(&self) -> Version {
        self.version
    }

    /// Bytes written so far.
    pub(crate) fn len(&self) -> usize {
        self.out.len()
    }

    /// What was written from a length on.
    pub(crate) fn since(&self, start: usize) -> &[u8] {
        self.out.get(start..).unwrap_or_default()
    }

    /// Everything written.
    pub(crate) fn into_bytes(self) -> Vec<u8> {
        self.out
    }

    /// Raw bytes, part of the innermost chunk's CRC.
    pub(crate) fn bytes(&mut self, bytes: &[u8]) {
        self.out.extend_from_slice(bytes);
    }

    /// Takes what was written so far into the innermost CRC: a nested chunk begins.
    fn suspend(&mut self) {
        if let Some(crc) = self.open.last_mut() {
            crc.feed(&self.out, self.out.len());
        }
    }

    /// Goes on behind a nested chunk.
    fn resume(&mut self) {
        if let Some(crc) = self.open.last_mut() {
            crc.skip_to(self.out.len());
        }
    }

    /// Complete chunks written elsewhere, headers and CRCs included; they stay out of the CRC here.
    pub(crate) fn chunks(&mut self, chunks: &[u8]) {
        self.suspend();
        self.out.extend_from_slice(chunks);
        self.resume();
    }

    /// A long chunk whose whole body, its CRC included, was written elsewhere.
    pub(crate) fn foreign_chunk(&mut self, typecode: u32, body: &[u8]) -> Result<()> {
        self.suspend();
        self.out.extend_from_slice(&typecode.to_le_bytes());
        let (length, width) = self.length(body.len())?;
        self.out.extend_from_slice(length.get(..width).unwrap_or_default());
        self.out.extend_from_slice(body);
        self.resume();
        Ok(())
    }

    /// A short chunk.
    pub(crate) fn short(&mut self, typecode: u32, value: i64) {
        self.suspend();
        self.out.extend_from_slice(&typecode.to_le_bytes());
        let value = value.to_le_bytes();
        let width = if self.version.is_wide() { 8 } else { 4 };
        self.out.extend_from_slice(value.get(..width).unwrap_or(&value));
        self.resume();
    }

    /// A long chunk, with a CRC when its typecode asks for one; `body` writes what it holds.
    pub(crate) fn chunk(&mut self, typecode: u32, body: impl FnOnce(&mut Self) -> Result<()>) -> Result<()> {
        self.suspend();
        self.out.extend_from_slice(&typecode.to_le_bytes());
        let place = self.out.len();
        let (_, width) = self.length(0)?;
        self.out.resize(place + width, 0);
        let start = self.out.len();
        self.open.push(RunningCrc::starting_at(start));
        body(self)?;
        if let Some(mut crc) = self.open.pop()
            && typecode & typecode::CRC != 0
        {
            crc.feed(&self.out, self.out.len());
            self.out.extend_from_slice(&crc.value().to_le_bytes());
        }
        let (length, width) = self.length(self.out.len() - start)?;
        if let (Some(field), Some(length)) = (self.out.get_mut(place..start), length.get(..width)) {
            field.copy_from_slice(length);
        }
        self.resume();
        Ok(())
    }

    /// An anonymous chunk that begins with a version.
    pub(crate) fn versioned(
        &mut self,
        major: i32,
        minor: i32,
        body: impl FnOnce(&mut Self) -> Result<()>,
    ) -> Result<()> {
        self.chunk(typecode::ANONYMOUS, |w| {
            w.i32(major);
            w.i32(minor);
            body(w)
        })
    }

    /// A body length, and how many of its bytes this archive stores.
    fn length(&self, length: usize) -> Result<([u8; 8], usize)> {
        let bytes = (length as u64).to_le_bytes();
        if self.version.is_wide() {
            return Ok((bytes, 8));
        }
        u32::try_from(length).map(|_| (bytes, 4)).map_err(|_| Error::CannotWrite {
            what: format!("a chunk of {length} bytes"),
            version: self.version.archive,
            why: "chunks of this version end at 4 GiB".into(),
        })
    }

    /// A count of items, stored as a signed 32-bit number.
    pub(crate) fn count(&mut self, count: usize, what: &str) -> Result<()> {
        let count = i32::try_from(count).map_err(|_| Error::CannotWrite {
            what: format!("{count} {what}"),
            version: self.version.archive,
            why: "counts end at 2147483647".into(),
        })?;
        self.i32(count);
        Ok(())
    }
}
