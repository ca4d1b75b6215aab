//! What is kept of a point, as bytes: in a study's file, and on the way from another process.
//!
//! A record has its length and a checksum before it, so that what was cut off or damaged is told from what is whole.

use std::io::{self, Read};
use std::time::Duration;

use crate::thresholds::MOST_RECORD_BYTES;
use crate::{Cell, Outcome, Status};

/// The name of a point or a study: what it is made of, hashed.
pub(crate) type Name = [u8; 16];

/// The first bytes of a BLAKE3 hash.
pub(crate) fn name_of(hasher: &blake3::Hasher) -> Name {
    hasher.finalize().as_bytes().first_chunk().copied().unwrap_or_default()
}

/// What is kept of a point.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Kept {
    pub(crate) name: Name,
    pub(crate) outcome: Outcome,
    /// The names of its picture and its geometry; empty where there is none.
    pub(crate) files: [String; 2],
}

/// A record: the length and the checksum of what is kept, and the bytes of it.
pub(crate) fn framed(kept: &Kept) -> Vec<u8> {
    let payload = encode(kept);
    let mut bytes = Vec::with_capacity(payload.len() + 8);
    bytes.extend(u32::try_from(payload.len()).unwrap_or(u32::MAX).to_le_bytes());
    bytes.extend(crc32fast::hash(&payload).to_le_bytes());
    bytes.extend(payload);
    bytes
}

/// Reads the payload of the next record; `false` where there is no whole one.
pub(crate) fn record(reader: &mut impl Read, left: u64, bytes: &mut Vec<u8>) -> io::Result<bool> {
    if left < 8 {
        return Ok(false);
    }
    let mut head = [0; 8];
    reader.read_exact(&mut head)?;
    let [length, sum] =
        [0, 4].map(|at| head.get(at..at + 4).and_then(|b| b.try_into().ok()).map_or(0, u32::from_le_bytes));
    if length > MOST_RECORD_BYTES || u64::from(length) > left - 8 {
        return Ok(false);
    }
    bytes.resize(length as usize, 0);
    reader.read_exact(bytes)?;
    Ok(crc32fast::hash(bytes) == sum)
}

pub(crate) fn encode(kept: &Kept) -> Vec<u8> {
    let mut out = Vec::with_capacity(128);
    out.extend(kept.name);
    out.push(kept.outcome.status as u8);
    out.extend(u64::try_from(kept.outcome.time.as_nanos()).unwrap_or(u64::MAX).to_le_bytes());
    let texts = [&kept.outcome.reason, &kept.files[0], &kept.files[1]];
    texts.iter().for_each(|text| Cell::Text((*text).clone()).encode(&mut out));
    kept.outcome.cells.iter().for_each(|cell| cell.encode(&mut out));
    out
}

pub(crate) fn decode(bytes: &[u8]) -> Option<Kept> {
    let mut rest = bytes;
    let name = taken(&mut rest)?;
    let [status] = taken(&mut rest)?;
    let time = Duration::from_nanos(u64::from_le_bytes(taken(&mut rest)?));
    let mut text = || match cell(&mut rest)? {
        Cell::Text(text) => Some(text),
        _ => None,
    };
    let (reason, files) = (text()?, [text()?, text()?]);
    let cells = cells(rest)?;
    let outcome = Outcome { status: Status::of_byte(status)?, reason, cells, time };
    Some(Kept { name, outcome, files })
}

/// The cells that bytes stand for; `None` where they are damaged.
pub(crate) fn cells(mut rest: &[u8]) -> Option<Vec<Cell>> {
    let mut cells = Vec::new();
    while !rest.is_empty() {
        cells.push(cell(&mut rest)?);
    }
    Some(cells)
}

fn taken<const N: usize>(rest: &mut &[u8]) -> Option<[u8; N]> {
    let (head, tail) = rest.split_first_chunk()?;
    *rest = tail;
    Some(*head)
}

fn cell(rest: &mut &[u8]) -> Option<Cell> {
    let [kind] = taken(rest)?;
    Some(match kind {
        0 => Cell::Null,
        1 => Cell::Boolean(taken::<1>(rest)? != [0]),
        2 => Cell::Number(f64::from_bits(u64::from_le_bytes(taken(rest)?))),
        3 => {
            let length = u32::from_le_bytes(taken(rest)?);
            let (head, tail) = rest.split_at_checked(length as usize)?;
            *rest = tail;
            Cell::Text(String::from_utf8(head.to_vec()).ok()?)
        }
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn bytes_are_decoded_or_refused(bytes: Vec<u8>) {
            if let Some(kept) = decode(&bytes) {
                prop_assert_eq!(decode(&encode(&kept)).map(|k| encode(&k)), Some(encode(&kept)));
            }
        }
    }
}
