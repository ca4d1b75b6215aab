//! What an archive looks like from outside: its chunks one under the other, without taking any of them apart.
//!
//! Chunks do not say whether others lie in them. Tables and records are known; in other bodies chunks are looked for, and
//! the CRC, which leaves nested chunks out, proves whether what was found is right.

mod names;
mod walk;

use crate::chunk::Context;
use crate::read::find_header;
use crate::{Limits, Result, class_ids};
use names::name_of;
use uuid::Uuid;
use walk::{Extent, Found, Walker};

/// A chunk of an archive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutlineChunk {
    /// Where it begins, from the first byte given.
    pub offset: usize,
    /// How many chunks it lies in.
    pub depth: usize,
    /// The four bytes that say what it is.
    pub typecode: u32,
    /// What that means; nothing for a typecode that is not known.
    pub name: Option<&'static str>,
    /// The bytes of its body, or the data of a chunk without one.
    pub content: OutlineContent,
    /// The class of the object in it, where it holds one.
    pub class: Option<String>,
}

/// What a chunk holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutlineContent {
    /// A number in place of a body.
    Value(i64),
    /// A body.
    Body {
        /// Its bytes, the CRC among them.
        length: u64,
        /// What its checksum says.
        crc: OutlineCrc,
    },
}

/// What the checksum of a chunk says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutlineCrc {
    /// It has none.
    Absent,
    /// It fits.
    Right,
    /// It does not fit: bytes were changed.
    Wrong,
    /// It cannot be told: which of the bytes belong to chunks inside is not known.
    Unknown,
}

/// How a walk over an archive ended.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Outline {
    /// Where the archive begins, behind what a wrapper put before it.
    pub start: usize,
    /// The version of the archive.
    pub version: i32,
    /// Whether the end mark was found.
    pub ended: bool,
    /// Where chunks passed the end of what they lie in: the offset, and what is wrong there.
    pub broken: Vec<(usize, String)>,
}

/// How many broken places are told of.
const MOST_BROKEN: usize = 100;
/// The bytes before the first chunk.
const HEADER: usize = 32;
/// No archive is walked deeper than this.
const DEEPEST: usize = 64;

/// Walks over the chunks of an archive from front to back, down to a depth (0 for those at the top alone), and hands each
/// to `visit`. Objects and their bodies are not taken apart, and user data not gone into, so broken archives can be
/// walked, too.
///
/// # Errors
/// The bytes hold no .3dm header, or one of a version that is not known.
///
/// ```
/// use katydid_3dm::{Model, outline};
///
/// let bytes = Model::default().write(70)?;
/// let mut names = Vec::new();
/// let outline = outline(&bytes, 0, |chunk| names.extend(chunk.name))?;
/// assert!(outline.ended && outline.version == 70);
/// assert_eq!(names[..3], ["comment", "properties table", "settings table"]);
/// # Ok::<(), katydid_3dm::Error>(())
/// ```
pub fn outline(bytes: &[u8], depth: usize, mut visit: impl FnMut(OutlineChunk)) -> Result<Outline> {
    let (first, version) = find_header(bytes, &Context::new(&Limits::default()))?;
    let depth = depth.min(DEEPEST);
    let mut outline = Outline { start: first.saturating_sub(HEADER), version, ..Outline::default() };
    let walker = Walker { bytes, is_wide: version >= 50, has_crc: version >= 2, depth };
    walker.walk(Extent { from: first, to: bytes.len() }, 0, &mut |found| match found {
        Found::Chunk(chunk) => {
            outline.ended |= chunk.depth == 0 && chunk.typecode == crate::typecode::END_OF_FILE;
            visit(*chunk);
        }
        Found::Broken(offset, why) if outline.broken.len() < MOST_BROKEN => {
            outline.broken.push((offset, why))
        }
        Found::Broken(..) => {}
    });
    Ok(outline)
}

/// The name of a class by the 16 bytes of its identifier as archives have them.
fn class_name(bytes: [u8; 16]) -> String {
    let id = Uuid::from_bytes_le(bytes);
    if id.is_nil() {
        "null object".into()
    } else {
        class_ids::name(id).map_or_else(|| id.to_string(), str::to_owned)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Model, Object};
    use katydid_geometry::{Mesh, MeshFace, Point3};

    fn archive(version: i32) -> Vec<u8> {
        let mut model = Model::default();
        let points = (0..40).map(|i| Point3::new(f64::from(i), f64::from(i * i), 0.5)).collect();
        let mesh = Mesh::new(points, vec![MeshFace::Triangle([0, 1, 2]); 30]).unwrap();
        model.objects.push(Object::from(mesh).into());
        model.objects.push(Object::Point(Point3::ORIGIN).into());
        model.write(version).unwrap()
    }

    #[test]
    fn every_checksum_of_a_written_archive_is_right() {
        for version in [4, 50, 60, 70, 80] {
            let (mut right, mut classes) = (0, Vec::new());
            let outline = outline(&archive(version), 20, |chunk| {
                if let OutlineContent::Body { crc, .. } = chunk.content {
                    assert!(matches!(crc, OutlineCrc::Absent | OutlineCrc::Right), "{version}: {chunk:?}");
                    right += usize::from(crc == OutlineCrc::Right);
                }
                if chunk.typecode == crate::typecode::CLASS {
                    classes.extend(chunk.class);
                }
            })
            .unwrap();
            assert!(outline.ended && outline.broken.is_empty(), "{version}: {outline:?}");
            assert!(right > 15, "{version}: {right}");
            assert_eq!(classes, ["Layer", "Mesh", "Point"], "{version}");
        }
    }

    #[test]
    fn a_changed_byte_is_found_where_it_is() {
        let bytes = archive(70);
        let mut records = Vec::new();
        outline(&bytes, 9, |chunk| records.push(chunk)).unwrap();
        let data = records.iter().rev().find(|chunk| chunk.name == Some("class data")).unwrap();
        let mut changed = bytes.clone();
        changed[data.offset + 12 + 5] ^= 1;
        let mut wrong = Vec::new();
        outline(&changed, 9, |chunk| {
            if matches!(
                chunk.content,
                OutlineContent::Body { crc: OutlineCrc::Wrong | OutlineCrc::Unknown, .. }
            ) {
                wrong.push(chunk.offset);
            }
        })
        .unwrap();
        assert_eq!(wrong, [data.offset]);
    }

    #[test]
    fn every_beginning_of_an_archive_is_walked() {
        let bytes = archive(60);
        for length in 0..bytes.len() {
            let walked = outline(&bytes[..length], 30, |_| {});
            assert_eq!(walked.is_ok(), length >= 32);
        }
    }
}
