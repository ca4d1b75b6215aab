//! Text of version 1: bytes, with or without a count, perhaps with zeros at the end.

use crate::Result;
use crate::chunk::Reader;

/// The text up to the first zero. Bytes that are no UTF-8 become U+FFFD.
pub(super) fn of(bytes: &[u8]) -> String {
    let end = bytes.iter().position(|byte| *byte == 0).unwrap_or(bytes.len());
    String::from_utf8_lossy(bytes.get(..end).unwrap_or_default()).into_owned()
}

/// Text after its count of bytes.
pub(super) fn counted(body: &mut Reader<'_>, what: &'static str) -> Result<String> {
    let length = body.count(1, what)?;
    Ok(of(body.take(length, what)?))
}
