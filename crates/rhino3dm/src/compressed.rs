//! Compressed buffers (section 4): a size, a CRC of the plain bytes, then either those bytes or a chunk that
//! holds them as a zlib stream.

mod stored;

use std::io::Write;

pub use stored::StoredBuffer;

use flate2::write::ZlibEncoder;
use flate2::{Compression, Decompress, FlushDecompress, Status};
use miniz_oxide::inflate::decompress_slice_iter_to_slice;

use crate::chunk::{Context, Reader, Writer};
use crate::{Error, Result, typecode};

/// Deflate cannot make a stream shorter than about a 1032nd of its content.
const MOST_INFLATION: u64 = 1040;
/// Buffers up to this size are stored plain.
const PLAIN: usize = 128;
/// Streams are some three hundredths longer at this level than at the highest, which openNURBS uses, and take a quarter
/// of its time.
const LEVEL: u32 = 6;
/// Content no longer than the window of deflate is inflated without one. The window takes more room than many a small
/// archive with all that is read from it.
const WINDOW: usize = 1 << 15;
/// Buffers of fewer bytes together are not worth the start of other threads.
#[cfg(feature = "parallel")]
const PARALLEL: usize = 1 << 15;

/// A compressed buffer that is found but not inflated: its size is one that its bytes can hold and the limits
/// allow.
#[derive(Debug)]
pub(crate) struct CompressedBuffer<'a> {
    what: &'static str,
    offset: usize,
    size: usize,
    crc: u32,
    content: Content<'a>,
}

#[derive(Debug)]
enum Content<'a> {
    Plain(&'a [u8]),
    Deflated(&'a [u8]),
}

impl<'a> Reader<'a> {
    /// The compressed buffer that comes next.
    pub(crate) fn compressed_buffer(&mut self, what: &'static str) -> Result<CompressedBuffer<'a>> {
        let offset = self.offset();
        let stated = self.u32(what)?;
        let size = usize::try_from(stated).unwrap_or(usize::MAX);
        if size == 0 {
            return Ok(CompressedBuffer { what, offset, size, crc: 0, content: Content::Plain(&[]) });
        }
        let crc = self.u32(what)?;
        let content = match self.u8(what)? {
            0 => Content::Plain(self.take(size, what)?),
            1 => {
                let mut chunk = self.expect(typecode::ANONYMOUS, what)?;
                let stream = chunk.rest();
                chunk.finish();
                if u64::from(stated) > (stream.len() as u64).saturating_mul(MOST_INFLATION) {
                    let why = format!("{} compressed bytes cannot hold {size}", stream.len());
                    return Err(Error::malformed(offset, what, why));
                }
                self.context().spend_inflated(offset, u64::from(stated))?;
                Content::Deflated(stream)
            }
            method => {
                return Err(Error::malformed(offset, what, format!("unknown compression method {method}")));
            }
        };
        Ok(CompressedBuffer { what, offset, size, crc, content })
    }
}

impl CompressedBuffer<'_> {
    /// Bytes it holds once inflated.
    pub(crate) fn size(&self) -> usize {
        self.size
    }

    /// Fills `room`, which must have [`CompressedBuffer::size`] bytes. Bytes that differ from their CRC are a
    /// warning.
    pub(crate) fn inflate_into(&self, context: &Context, room: &mut [u8]) -> Result<()> {
        let malformed = |why: String| Error::malformed(self.offset, self.what, why);
        match self.content {
            Content::Plain(bytes) if bytes.len() == room.len() => room.copy_from_slice(bytes),
            Content::Plain(_) => return Err(malformed("it is read into room of another size".into())),
            Content::Deflated(stream) => inflate(stream, room).map_err(malformed)?,
        }
        if self.size > 0 && crc32fast::hash(room) != self.crc {
            self.warn_of_crc(context);
        }
        Ok(())
    }

    fn warn_of_crc(&self, context: &Context) {
        context.bad_crc(self.offset, format!("CRC mismatch in the compressed {}", self.what));
    }
}

/// Inflates a zlib stream that must fill `room` exactly.
fn inflate(stream: &[u8], room: &mut [u8]) -> std::result::Result<(), String> {
    if room.len() <= WINDOW {
        let made = decompress_slice_iter_to_slice(room, std::iter::once(stream), true, false);
        if made == Ok(room.len()) {
            return Ok(());
        }
    }
    // What is wrong with a stream is told in one place, whatever its length.
    inflate_with_window(stream, room)
}

fn inflate_with_window(stream: &[u8], room: &mut [u8]) -> std::result::Result<(), String> {
    let size = room.len() as u64;
    let mut state = Decompress::new(true);
    let status = state.decompress(stream, room, FlushDecompress::Finish).map_err(|e| e.to_string())?;
    if state.total_out() != size {
        return Err(format!("{size} bytes are promised, but its stream does not hold that many"));
    }
    if status != Status::StreamEnd {
        let left = usize::try_from(state.total_in()).ok().and_then(|read| stream.get(read..));
        let more = state.decompress(left.unwrap_or_default(), &mut [0], FlushDecompress::Finish);
        more.map_err(|e| e.to_string())?;
        if state.total_out() != size {
            return Err(format!("{size} bytes are promised, but its stream holds more"));
        }
    }
    Ok(())
}

/// A buffer compressed already.
#[derive(Debug, Default)]
pub(crate) struct Packed {
    /// Bytes it holds once inflated.
    size: usize,
    crc: u32,
    /// The zlib stream, or the plain bytes of a small buffer.
    content: Vec<u8>,
}

impl Packed {
    /// Plain up to 128 bytes, deflated beyond.
    fn new(plain: &[u8]) -> Result<Self> {
        let content = if plain.len() <= PLAIN { plain.to_vec() } else { deflate(plain)? };
        Ok(Self { size: plain.len(), crc: crc32fast::hash(plain), content })
    }
}

fn deflate(plain: &[u8]) -> Result<Vec<u8>> {
    let mut stream = ZlibEncoder::new(Vec::new(), Compression::new(LEVEL));
    stream.write_all(plain)?;
    Ok(stream.finish()?)
}

/// Buffers, each compressed on a thread of its own when they are large. The bytes do not depend on the threads.
pub(crate) fn pack_all<const N: usize>(plain: [&[u8]; N]) -> Result<[Packed; N]> {
    let mut packed: [Packed; N] = std::array::from_fn(|_| Packed::default());
    let pack = |(slot, plain): (&mut Packed, &[u8])| -> Result<()> {
        *slot = Packed::new(plain)?;
        Ok(())
    };
    #[cfg(feature = "parallel")]
    if plain.iter().map(|plain| plain.len()).sum::<usize>() >= PARALLEL {
        use rayon::prelude::*;
        let all = packed.par_iter_mut().zip(plain);
        // A thread that waits may be given others' work, which has a token of its own.
        katydid_geometry::CancellationToken::waiting(|| all.try_for_each(pack))?;
        return Ok(packed);
    }
    packed.iter_mut().zip(plain).try_for_each(pack)?;
    Ok(packed)
}

impl Writer {
    /// A buffer compressed before.
    pub(crate) fn packed(&mut self, buffer: &Packed) -> Result<()> {
        let size = u32::try_from(buffer.size).map_err(|_| Error::CannotWrite {
            what: format!("a buffer of {} bytes", buffer.size),
            version: self.version().archive,
            why: "buffers end at 4 GiB".into(),
        })?;
        self.u32(size);
        if size == 0 {
            return Ok(());
        }
        self.u32(buffer.crc);
        if buffer.size <= PLAIN {
            self.u8(0);
            self.bytes(&buffer.content);
            return Ok(());
        }
        self.u8(1);
        self.chunk(typecode::ANONYMOUS, |w| {
            w.bytes(&buffer.content);
            Ok(())
        })
    }
}
