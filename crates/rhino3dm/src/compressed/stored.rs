//! Buffers that stay as their archive has them until somebody asks for the bytes: a preview takes a few kilobytes
//! stored, and megabytes as pixels.

use flate2::{Decompress, FlushDecompress, Status};

use super::{Content, PLAIN, Packed, WINDOW, inflate};
use crate::chunk::{Reader, Writer};
use crate::{Error, Result};

/// Bytes inflated at a time when only their checksum is wanted.
const STEP: usize = 1 << 12;

/// Bytes as an archive stores them: deflated when they are many. What is read from an archive has been seen to inflate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StoredBuffer {
    size: usize,
    crc: u32,
    stored: Stored,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Stored {
    Plain(Vec<u8>),
    /// A zlib stream.
    Deflated(Vec<u8>),
}

impl StoredBuffer {
    /// Bytes that no archive holds yet.
    pub fn new(bytes: Vec<u8>) -> Self {
        Self { size: bytes.len(), crc: crc32fast::hash(&bytes), stored: Stored::Plain(bytes) }
    }

    /// How many bytes [`StoredBuffer::to_bytes`] gives.
    pub fn size(&self) -> usize {
        self.size
    }

    /// The bytes.
    ///
    /// # Errors
    /// They cannot be inflated, which does not happen to those that were read from an archive.
    pub fn to_bytes(&self) -> Result<Vec<u8>> {
        match &self.stored {
            Stored::Plain(bytes) => Ok(bytes.clone()),
            Stored::Deflated(stream) => {
                let mut bytes = vec![0; self.size];
                inflate(stream, &mut bytes).map_err(|why| Error::malformed(0, "buffer", why))?;
                Ok(bytes)
            }
        }
    }
}

impl Reader<'_> {
    /// A compressed buffer, kept as it is stored once its stream has been found to hold what it promises. Bytes that
    /// differ from their CRC are a warning.
    pub(crate) fn stored_buffer(&mut self, what: &'static str) -> Result<StoredBuffer> {
        let buffer = self.compressed_buffer(what)?;
        match buffer.content {
            Content::Deflated(stream) if buffer.size > PLAIN => {
                let found = inflated_crc(stream, buffer.size)
                    .map_err(|why| Error::malformed(buffer.offset, what, why))?;
                if found != buffer.crc {
                    buffer.warn_of_crc(self.context());
                }
                // With the checksum that its bytes have: who reads it next shall not be warned of what is known.
                Ok(StoredBuffer { size: buffer.size, crc: found, stored: Stored::Deflated(stream.to_vec()) })
            }
            _ => {
                let mut bytes = vec![0; buffer.size];
                buffer.inflate_into(self.context(), &mut bytes)?;
                Ok(StoredBuffer::new(bytes))
            }
        }
    }
}

impl Writer {
    /// A buffer as it is stored; one that no archive held yet is deflated now.
    pub(crate) fn stored_buffer(&mut self, buffer: &StoredBuffer) -> Result<()> {
        match &buffer.stored {
            Stored::Plain(bytes) => self.packed(&Packed::new(bytes)?),
            Stored::Deflated(stream) => {
                self.packed(&Packed { size: buffer.size, crc: buffer.crc, content: stream.clone() })
            }
        }
    }
}

/// The checksum of what a zlib stream inflates to, which must be `size` bytes, without room for all of it.
fn inflated_crc(stream: &[u8], size: usize) -> std::result::Result<u32, String> {
    if size <= WINDOW {
        let mut room = vec![0; size];
        return inflate(stream, &mut room).map(|()| crc32fast::hash(&room));
    }
    let mut room = [0; STEP];
    let mut state = Decompress::new(true);
    let mut crc = crc32fast::Hasher::new();
    loop {
        let (read, made) = (state.total_in(), state.total_out());
        let left = usize::try_from(read).ok().and_then(|read| stream.get(read..)).unwrap_or_default();
        let status =
            state.decompress(left, &mut room, FlushDecompress::None).map_err(|error| error.to_string())?;
        let new = usize::try_from(state.total_out() - made).unwrap_or_default();
        crc.update(room.get(..new).unwrap_or_default());
        if state.total_out() > size as u64 {
            return Err(format!("{size} bytes are promised, but its stream holds more"));
        }
        if status == Status::StreamEnd || (state.total_in() == read && new == 0) {
            break;
        }
    }
    if state.total_out() != size as u64 {
        return Err(format!("{size} bytes are promised, but its stream does not hold that many"));
    }
    Ok(crc.finalize())
}
