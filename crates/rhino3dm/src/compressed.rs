//! Compressed buffers (section 4): a size, a CRC of the plain bytes, then either those bytes or a chunk that
//! holds them as a zlib stream.

use std::io::{Read, Write};

use flate2::Compression;
use flate2::read::ZlibDecoder;
use flate2::write::ZlibEncoder;

use crate::chunk::{Reader, Writer};
use crate::{Error, Result, typecode};

/// Deflate cannot make a stream shorter than about a 1032nd of its content.
const MOST_INFLATION: u64 = 1040;
/// Buffers up to this size are stored plain.
const PLAIN: usize = 128;

impl Reader<'_> {
    /// The plain bytes of a compressed buffer, bounded by the limits on inflated data.
    pub(crate) fn compressed(&mut self, what: &'static str) -> Result<Vec<u8>> {
        let offset = self.offset();
        let size = self.u32(what)?;
        if size == 0 {
            return Ok(Vec::new());
        }
        let stored = self.u32(what)?;
        let size = u64::from(size);
        let plain = match self.u8(what)? {
            0 => self.take(usize::try_from(size).unwrap_or(usize::MAX), what)?.to_vec(),
            1 => {
                let mut chunk = self.expect(typecode::ANONYMOUS, what)?;
                let stream = chunk.rest();
                chunk.finish();
                if size > (stream.len() as u64).saturating_mul(MOST_INFLATION) {
                    return Err(Error::malformed(
                        offset,
                        what,
                        format!("{} compressed bytes cannot hold {size}", stream.len()),
                    ));
                }
                self.context().spend_inflated(offset, size)?;
                inflate(stream, size).map_err(|why| Error::malformed(offset, what, why))?
            }
            method => {
                return Err(Error::malformed(offset, what, format!("unknown compression method {method}")));
            }
        };
        if crc32fast::hash(&plain) != stored {
            self.context().bad_crc(offset, format!("CRC mismatch in the compressed {what}"));
        }
        Ok(plain)
    }
}

/// Inflates a zlib stream that must give exactly `size` bytes.
fn inflate(stream: &[u8], size: u64) -> std::result::Result<Vec<u8>, String> {
    let mut plain = Vec::new();
    ZlibDecoder::new(stream).take(size + 1).read_to_end(&mut plain).map_err(|e| e.to_string())?;
    if plain.len() as u64 != size {
        return Err(format!("{size} bytes are promised, but its stream does not hold that many"));
    }
    Ok(plain)
}

impl Writer {
    /// A compressed buffer: plain up to 128 bytes, deflated beyond.
    pub(crate) fn compressed(&mut self, plain: &[u8]) -> Result<()> {
        let size = u32::try_from(plain.len()).map_err(|_| Error::CannotWrite {
            what: format!("a buffer of {} bytes", plain.len()),
            version: self.version().archive,
            why: "buffers end at 4 GiB".into(),
        })?;
        self.u32(size);
        if size == 0 {
            return Ok(());
        }
        self.u32(crc32fast::hash(plain));
        if plain.len() <= PLAIN {
            self.u8(0);
            self.bytes(plain);
            return Ok(());
        }
        self.u8(1);
        let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
        encoder.write_all(plain)?;
        let stream = encoder.finish()?;
        self.chunk(typecode::ANONYMOUS, |w| {
            w.bytes(&stream);
            Ok(())
        })
    }
}
