//! The running CRC-32 of one open chunk (section 2).
//!
//! A chunk's CRC covers only the bytes written directly into it: nested chunks, headers and all, stay out.
//! So each open chunk keeps its own running value and the place up to which its own bytes have entered.

use crc32fast::Hasher;

/// The CRC-16 that ends chunks of version 1: the remainder modulo the polynomial 0x1021 of the bytes as they are,
/// begun at 1. The writer takes in two zeros before it writes the CRC, so that over a chunk with its CRC it is 0.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crc16(u16);

/// What the byte that leaves the register does to it.
const CRC16_TABLE: [u16; 256] = {
    let mut table = [0; 256];
    let mut byte = 0;
    while byte < 256 {
        let mut remainder = (byte as u16) << 8;
        let mut bit = 0;
        while bit < 8 {
            let carry = remainder & 0x8000 != 0;
            remainder <<= 1;
            if carry {
                remainder ^= 0x1021;
            }
            bit += 1;
        }
        table[byte] = remainder;
        byte += 1;
    }
    table
};

impl Crc16 {
    pub(crate) const START: Self = Self(1);

    /// The CRC with more bytes taken in.
    pub(crate) fn and(self, bytes: &[u8]) -> Self {
        let take = |crc: u16, byte: &u8| {
            let [leaving, _] = crc.to_be_bytes();
            (crc << 8 | u16::from(*byte)) ^ CRC16_TABLE.get(usize::from(leaving)).copied().unwrap_or_default()
        };
        Self(bytes.iter().fold(self.0, take))
    }

    pub(crate) fn is_right(self) -> bool {
        self.0 == 0
    }
}

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
