//! The 32 bytes before the first chunk (section 1).

use crate::chunk::{Context, Reader};
use crate::version::Version;
use crate::{Error, Result, typecode, v1};

/// What every archive begins with; the version follows in 8 bytes.
pub(crate) const SIGNATURE: &[u8; 24] = b"3D Geometry File Format ";
/// How far to look for it: old files may stand behind a wrapper of another format.
const SEARCH: usize = 32 << 20;

/// The offset of the first chunk and the archive version.
pub(crate) fn find(bytes: &[u8], context: &Context) -> Result<(usize, i32)> {
    let window = bytes.get(..SEARCH).unwrap_or(bytes);
    // The common case first: a search over megabytes is for the rare one.
    let start = if window.starts_with(SIGNATURE) {
        0
    } else {
        let found = window.windows(SIGNATURE.len()).position(|w| w == SIGNATURE);
        found.ok_or_else(|| not_an_archive(bytes))?
    };
    let digits_at = start + SIGNATURE.len();
    let digits = bytes.get(digits_at..digits_at + 8).ok_or_else(|| not_an_archive(bytes))?;
    let first_chunk = digits_at + 8;
    let mut version = match digits.trim_ascii() {
        b"X" | b"x" => 2,
        digits => std::str::from_utf8(digits)
            .ok()
            .and_then(|d| d.parse().ok())
            .ok_or_else(|| not_an_archive(bytes))?,
    };
    if version == 1 && has_tables(bytes.get(first_chunk..).unwrap_or_default(), context) {
        version = 2;
    }
    match version {
        1..=5 | 50 | 60 | 70 | 80 => {}
        newer if newer > 80 && newer <= 990 && newer % 10 == 0 => {
            context.warn(start, format!("version {newer} is newer than this reader; it is read as 80"));
        }
        other => return Err(Error::UnsupportedVersion(other)),
    }
    Ok((first_chunk, version))
}

fn not_an_archive(bytes: &[u8]) -> Error {
    let first = bytes.iter().take(8).take_while(|byte| byte.is_ascii_graphic());
    Error::NotAnArchive { begins: first.map(|byte| char::from(*byte)).collect() }
}

/// Whether tables follow: some files say version 1 but are laid out as version 2, perhaps behind chunks that
/// programs of version 1 put before all else.
fn has_tables(chunks: &[u8], context: &Context) -> bool {
    let mut reader = Reader::new(chunks, Version { archive: 1, opennurbs: 0 }, context);
    while let Ok(chunk) = reader.chunk() {
        if typecode::table_name(chunk.typecode).is_some() {
            return true;
        }
        if chunk.typecode != typecode::COMMENT && !v1::may_precede_tables(chunk.typecode) {
            return false;
        }
    }
    false
}
