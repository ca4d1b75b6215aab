//! Zlib streams (RFC 1950, RFC 1951) byte for byte as openNURBS writes them.
//!
//! Archives hold large arrays as zlib streams of the highest level. A stream says nothing of how it was found, and
//! any compressor's would be read; but only the choices of the original compressor give the same bytes, so that
//! archives can be compared: hash chains over three bytes, lazy evaluation of matches, blocks of 16383 symbols, and
//! codes built in one certain order.

mod bits;
mod block;
mod codes;
mod matches;
mod symbols;

#[cfg(test)]
mod tests;

/// Window of 32 KiB, deflate; highest level.
const HEADER: [u8; 2] = [0x78, 0xDA];

/// The zlib stream of some bytes.
pub(crate) fn zlib(plain: &[u8]) -> Vec<u8> {
    let mut out = bits::BitWriter::new(plain.len() / 2 + 64);
    out.bytes(&HEADER);
    matches::deflate(plain, &mut out);
    out.bytes(&adler32(plain).to_be_bytes());
    out.into_bytes()
}

/// The checksum of RFC 1950: two sums modulo the greatest prime below 2¹⁶.
fn adler32(bytes: &[u8]) -> u32 {
    const MODULUS: u32 = 65521;
    /// So many bytes can be summed before 32 bits overflow.
    const STRETCH: usize = 5552;
    let (mut a, mut b) = (1_u32, 0_u32);
    for stretch in bytes.chunks(STRETCH) {
        for byte in stretch {
            a += u32::from(*byte);
            b += a;
        }
        a %= MODULUS;
        b %= MODULUS;
    }
    b << 16 | a
}
