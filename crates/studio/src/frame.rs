//! Geometry in a binary frame, as [`Event::Preview`](katydid_session::protocol::Event::Preview) tells of it.

/// How many bytes of a hash name geometry.
const HASH_BYTES: usize = 16;

/// Writes geometry behind others in one frame: the 16 bytes of its hash, its length (`u32`), four zeros, its bytes, and
/// zeros up to a multiple of 8. `false`, and nothing written, where the hash is none or the geometry is too long.
pub fn write_frame(hash: &str, bytes: &[u8], frame: &mut Vec<u8>) -> bool {
    let (Some(hash), Ok(length)) = (hash_bytes(hash), u32::try_from(bytes.len())) else { return false };
    frame.reserve(framed_size(bytes));
    frame.extend_from_slice(&hash);
    frame.extend_from_slice(&u64::from(length).to_le_bytes());
    frame.extend_from_slice(bytes);
    frame.resize(frame.len().next_multiple_of(8), 0);
    true
}

/// How many bytes geometry takes in a frame.
pub fn framed_size(bytes: &[u8]) -> usize {
    HASH_BYTES + 8 + bytes.len().next_multiple_of(8)
}

fn hash_bytes(text: &str) -> Option<[u8; HASH_BYTES]> {
    let mut hash = [0; HASH_BYTES];
    let pairs = text.as_bytes().chunks(2);
    for (byte, pair) in hash.iter_mut().zip(pairs) {
        *byte = u8::from_str_radix(std::str::from_utf8(pair).ok()?, 16).ok()?;
    }
    (text.len() == 2 * HASH_BYTES).then_some(hash)
}
