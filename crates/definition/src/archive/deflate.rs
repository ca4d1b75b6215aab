use std::io::Write;

use flate2::{Compression, Decompress, FlushDecompress, Status, write::DeflateEncoder};

use crate::{Error, Place, Result};

/// A stream, inflated.
pub(crate) struct Inflated {
    /// The bytes.
    pub(crate) data: Vec<u8>,
    /// How many bytes of the input the stream took.
    pub(crate) consumed: usize,
}

/// Inflates one raw DEFLATE stream and stops as soon as the result grows past `limit`.
pub(crate) fn inflate(bytes: &[u8], limit: usize) -> Result<Inflated> {
    let mut stream = Decompress::new(false);
    let mut data = Vec::new();
    loop {
        if data.len() == data.capacity() {
            let room = limit.saturating_add(1).saturating_sub(data.len());
            data.reserve_exact(data.len().max(1 << 16).min(room));
        }
        let consumed = usize::try_from(stream.total_in()).unwrap_or(usize::MAX);
        let rest = bytes.get(consumed..).unwrap_or_default();
        let before = data.len();
        let status = stream.decompress_vec(rest, &mut data, FlushDecompress::None).map_err(|_| {
            Error::at(Place::File, consumed, "the compressed stream is damaged, or this is another format")
        })?;
        if data.len() > limit {
            return Err(Error::Limit {
                place: Place::File,
                offset: consumed,
                what: "the inflated size in bytes",
                limit,
            });
        }
        let now = usize::try_from(stream.total_in()).unwrap_or(usize::MAX);
        if status == Status::StreamEnd {
            return Ok(Inflated { data, consumed: now });
        }
        if now == consumed && data.len() == before && data.len() < data.capacity() {
            return Err(Error::at(
                Place::File,
                bytes.len(),
                "the file ends in the middle of the compressed stream",
            ));
        }
    }
}

/// Compresses bytes into one raw DEFLATE stream.
pub(crate) fn deflate(data: &[u8]) -> Result<Vec<u8>> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::default());
    encoder
        .write_all(data)
        .and_then(|()| encoder.finish())
        .map_err(|error| Error::Unwritable(error.to_string()))
}
