//! Chunks made anew for archives whose chunk lengths are of another width, in bytes whose layout is not known.
//!
//! The chunks inside are found by their check sums: what looks like a chunk is one when the bytes that are its own
//! give the CRC at its end, and a reading of a record is right when the record's CRC says so. Bytes for which that
//! does not come out are given up, so that nothing is ever guessed. Derived from the layout of chunks (section 2).

use crate::chunk::{Context, Reader, Writer};
use crate::class_object::UserData;
use crate::version::Version;
use crate::{Limits, typecode};

/// How deep chunks may nest. Real files stay below 30.
const DEPTH: usize = 40;
/// Bytes looked at in all, as a multiple of those given: deep nesting makes every byte count again.
const EFFORT: usize = 64;

/// A stretch of a body: bytes of its own, or a chunk.
enum Part<'a> {
    Own(&'a [u8]),
    Short {
        typecode: u32,
        value: i64,
    },
    Long {
        typecode: u32,
        parts: Vec<Part<'a>>,
    },
    /// User data, whose body keeps its own version.
    UserData(Box<UserData>),
}

/// The body of a record or chunk of the given typecode, its CRC included, for another width of chunk lengths;
/// nothing when its chunks cannot be told for certain.
pub(crate) fn recode(typecode: u32, body: &[u8], from: Version, to: Version) -> Option<Vec<u8>> {
    if from.is_wide() == to.is_wide() {
        return Some(body.to_vec());
    }
    let mut search = Search { from, left: body.len().saturating_mul(EFFORT) };
    let parts = search.parts(typecode, body, 0)?;
    let mut w = Writer::new(to);
    write_chunk(typecode, &parts, &mut w)?;
    Some(w.into_bytes().split_off(if to.is_wide() { 12 } else { 8 }))
}

struct Search {
    from: Version,
    left: usize,
}

impl Search {
    /// The parts of a body, when its CRC agrees or, where it has none, when chunks fill it.
    fn parts<'a>(&mut self, typecode: u32, body: &'a [u8], depth: usize) -> Option<Vec<Part<'a>>> {
        self.left = self.left.checked_sub(body.len())?;
        if depth > DEPTH {
            return None;
        }
        if typecode & typecode::CRC == 0 {
            let parts = self.split(body, depth);
            let filled = parts.iter().all(|part| !matches!(part, Part::Own(_)));
            return (filled && !parts.is_empty()).then_some(parts);
        }
        let (bytes, stored) = body.split_last_chunk::<4>()?;
        let parts = self.split(bytes, depth);
        let mut crc = crc32fast::Hasher::new();
        for part in &parts {
            if let Part::Own(own) = part {
                crc.update(own);
            }
        }
        (crc.finalize() == u32::from_le_bytes(*stored)).then_some(parts)
    }

    /// Bytes taken apart into chunks and what stands between them.
    fn split<'a>(&mut self, bytes: &'a [u8], depth: usize) -> Vec<Part<'a>> {
        let mut parts = Vec::new();
        let (mut start, mut at) = (0, 0);
        while at < bytes.len() {
            // Short chunks have no CRC; they are believed where a chunk ended or the body began.
            let between = start == at;
            let Some((part, length)) = bytes.get(at..).and_then(|rest| self.chunk(rest, between, depth))
            else {
                at += 1;
                continue;
            };
            if start < at {
                parts.extend(bytes.get(start..at).map(Part::Own));
            }
            parts.push(part);
            at += length;
            start = at;
        }
        if start < bytes.len() {
            parts.extend(bytes.get(start..).map(Part::Own));
        }
        parts
    }

    /// The chunk that bytes begin with, and its length, when there is one.
    fn chunk<'a>(&mut self, bytes: &'a [u8], short: bool, depth: usize) -> Option<(Part<'a>, usize)> {
        let typecode = u32::from_le_bytes(*bytes.first_chunk()?);
        if !is_plausible(typecode) {
            return None;
        }
        let (header, value) = if self.from.is_wide() {
            (12, i64::from_le_bytes(*bytes.get(4..)?.first_chunk()?))
        } else {
            let value = *bytes.get(4..)?.first_chunk()?;
            let unsigned = typecode & typecode::SHORT == 0 || typecode::is_unsigned_short(typecode);
            (8, if unsigned { u32::from_le_bytes(value).into() } else { i32::from_le_bytes(value).into() })
        };
        if typecode & typecode::SHORT != 0 {
            return short.then_some((Part::Short { typecode, value }, header));
        }
        let end = usize::try_from(value).ok()?.checked_add(header)?;
        let body = bytes.get(header..end)?;
        if typecode == typecode::CLASS_USER_DATA {
            let context = Context::new(&Limits::default());
            let data = UserData::read(Reader::new(body, self.from, &context)).ok()?;
            return Some((Part::UserData(Box::new(data)), end));
        }
        let parts = self.parts(typecode, body, depth + 1)?;
        Some((Part::Long { typecode, parts }, end))
    }
}

/// Whether archives have chunks of this typecode inside of records.
fn is_plausible(typecode: u32) -> bool {
    matches!(
        typecode,
        typecode::ANONYMOUS
            | 0x4000_8001..=0x4000_80FF
            | typecode::CLASS..=typecode::CLASS_USER_DATA
            | typecode::CLASS_UUID
            | typecode::CLASS_DATA
            | typecode::USER_DATA_HEADER
            | typecode::CLASS_END
            | typecode::END_OF_TABLE
    ) || typecode & 0x7FFF_0000 == 0x2000_0000
}

fn write_chunk(typecode: u32, parts: &[Part<'_>], w: &mut Writer) -> Option<()> {
    w.chunk(typecode, |w| {
        for part in parts {
            match part {
                Part::Own(bytes) => w.bytes(bytes),
                Part::Short { typecode, value } => w.short(*typecode, *value),
                Part::UserData(data) => data.write(w)?,
                Part::Long { typecode, parts } => {
                    write_chunk(*typecode, parts, w).ok_or_else(|| crate::Error::CannotWrite {
                        what: "a chunk".into(),
                        version: w.version().archive,
                        why: "it is too long".into(),
                    })?;
                }
            }
        }
        Ok(())
    })
    .ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    const NARROW: Version = Version { archive: 4, opennurbs: 200_712_190 };
    const WIDE: Version = Version { archive: 70, opennurbs: 0x9000_0000 };

    fn record(version: Version) -> Vec<u8> {
        let mut w = Writer::new(version);
        w.chunk(typecode::VIEWS, |w| {
            w.i32(2);
            for name in ["first", "second view"] {
                w.chunk(0x2000_803B, |w| {
                    w.chunk(0x2000_823B, |w| w.string(name))?;
                    w.short(0xA000_013B, -1);
                    w.chunk(0x2000_8C3B, |w| {
                        w.u8(0x14);
                        // What looks like a chunk but is none.
                        w.u32(typecode::ANONYMOUS);
                        w.i32(4);
                        w.versioned(1, 0, |w| w.string("inner"))?;
                        w.f64(0.5);
                        Ok(())
                    })?;
                    w.short(typecode::END_OF_TABLE, 0);
                    Ok(())
                })?;
            }
            Ok(())
        })
        .unwrap();
        w.into_bytes().split_off(if version.is_wide() { 12 } else { 8 })
    }

    #[test]
    fn chunks_of_the_other_width_are_those_a_writer_of_that_width_writes() {
        for (from, to) in [(NARROW, WIDE), (WIDE, NARROW)] {
            assert_eq!(recode(typecode::VIEWS, &record(from), from, to), Some(record(to)));
        }
    }

    #[test]
    fn a_changed_byte_is_given_up() {
        let good = record(NARROW);
        for at in 0..good.len() {
            let mut bad = good.clone();
            bad[at] ^= 1;
            if let Some(made) = recode(typecode::VIEWS, &bad, NARROW, WIDE) {
                // Values of short chunks are under no CRC.
                assert!(made.len() == record(WIDE).len(), "byte {at}");
            }
        }
    }

    #[test]
    fn deep_nests_end() {
        let mut w = Writer::new(NARROW);
        fn nest(w: &mut Writer, depth: usize) -> crate::Result<()> {
            w.chunk(typecode::ANONYMOUS, |w| if depth == 0 { Ok(()) } else { nest(w, depth - 1) })
        }
        nest(&mut w, 500).unwrap();
        let bytes = w.into_bytes();
        assert_eq!(recode(typecode::ANONYMOUS, &bytes[8..], NARROW, WIDE), None);
    }
}
