//! The running CRC-32 of one open chunk (section 2).
//!
//! A chunk's CRC covers only the bytes written directly into it: nested chunks, headers and all, stay out.
//! So each open chunk keeps its own running value and the place up to which its own bytes have entered.

use crc32fast::Hasher;

/// The CRC of a chunk's own bytes, fed lazily in stretches between nested chunks.
#[derive(Debug, Clone, Default)]
pub(crate) struct RunningCrc {
    hasher: Hasher,
    fed: usize,
}

impl RunningCrc {
    /// A CRC whose first byte stands at `start` of the buffer it is later fed from.
    pub(crate) fn starting_at(start: usize) -> Self {
        Self { hasher: Hasher::new(), fed: start }
    }

    /// Takes in the buffer's bytes from where it stopped up to `end`.
    pub(crate) fn feed(&mut self, buffer: &[u8], end: usize) {
        if let Some(bytes) = buffer.get(self.fed..end) {
            self.hasher.update(bytes);
        }
        self.fed = end;
    }

    /// Leaves out everything up to `end`: a nested chunk.
    pub(crate) fn skip_to(&mut self, end: usize) {
        self.fed = end;
    }

    /// The value over all bytes taken in.
    pub(crate) fn value(&self) -> u32 {
        self.hasher.clone().finalize()
    }
}
