//! The records of a journal, as bytes.

use std::sync::Arc;

use crc32fast::hash;
use katydid_definition::archive::{self, Chunk, Encoding, Limits};
use katydid_definition::document::Difference;

use super::{Source, difference};

/// How a journal begins.
pub(super) const MAGIC: &[u8; 8] = b"KTJL\x01\0\0\0";
/// The length and the checksum before each record.
const HEAD: usize = 8;
/// No record is longer.
const LONGEST: usize = 1 << 30;

/// One thing that happened.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Record {
    /// The document as it was at first.
    Begin(Box<Begin>),
    /// A step, or one more edit of the gesture that the last step is.
    Step(Step),
    /// The last step was taken back.
    Undo,
    /// The last step that was taken back was made again.
    Redo,
    /// The last step was taken back for good.
    Abandon,
}

/// The head of a journal.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Begin {
    /// What it belongs to.
    pub(crate) source: Source,
    /// Whether the document at first is the one that was saved.
    pub(crate) saved: bool,
    /// The encoding of the document's file.
    pub(crate) encoding: Encoding,
    /// The document at first, as a .gh file.
    pub(crate) document: Vec<u8>,
}

/// A step with what it did.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Step {
    pub(super) name: String,
    pub(super) gesture: Option<u64>,
    /// Seconds since 1970.
    pub(super) at: u64,
    pub(super) difference: Arc<Difference>,
}

/// Adds a record to what is to be written.
pub(super) fn write(record: &Record, out: &mut Vec<u8>) -> Result<(), katydid_definition::Error> {
    let payload = archive::write_gh(&chunk(record))?;
    let length = u32::try_from(payload.len()).unwrap_or(u32::MAX);
    out.extend_from_slice(&length.to_le_bytes());
    out.extend_from_slice(&hash(&payload).to_le_bytes());
    out.extend_from_slice(&payload);
    Ok(())
}

/// The records of a journal, up to the first that is cut short or damaged, and how many bytes they take.
pub(super) fn read(bytes: &[u8]) -> (Vec<Record>, usize) {
    let mut records = Vec::new();
    let Some(mut rest) = bytes.strip_prefix(MAGIC) else { return (records, 0) };
    while let Some((payload, after)) = next(rest) {
        let Some(record) = parse(payload) else { break };
        records.push(record);
        rest = after;
    }
    (records, bytes.len() - rest.len())
}

/// The bytes of the first record, and what follows them.
fn next(bytes: &[u8]) -> Option<(&[u8], &[u8])> {
    let word = |at: usize| Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?));
    let length = usize::try_from(word(0)?).ok().filter(|length| *length <= LONGEST)?;
    let payload = bytes.get(HEAD..HEAD.checked_add(length)?)?;
    (hash(payload) == word(4)?).then_some((payload, bytes.get(HEAD + length..)?))
}

fn chunk(record: &Record) -> Chunk {
    match record {
        Record::Begin(begin) => {
            let mut chunk = Chunk::new("Begin");
            if let Some(path) = &begin.source.path {
                chunk.set("Path", path.as_str());
            }
            chunk.set("Hash", begin.source.hash.as_str());
            chunk.set("Saved", begin.saved);
            chunk.set("Xml", begin.encoding == Encoding::Xml);
            chunk.set("Document", archive::ItemValue::ByteArray(begin.document.clone()));
            chunk
        }
        Record::Step(step) => {
            let mut chunk = Chunk::new("Step");
            chunk.set("Name", step.name.as_str());
            if let Some(gesture) = step.gesture {
                chunk.set("Gesture", archive::ItemValue::Int64(gesture.cast_signed()));
            }
            chunk.set("At", archive::ItemValue::Int64(step.at.cast_signed()));
            difference::write(&step.difference, &mut chunk);
            chunk
        }
        Record::Undo => Chunk::new("Undo"),
        Record::Redo => Chunk::new("Redo"),
        Record::Abandon => Chunk::new("Abandon"),
    }
}

fn parse(payload: &[u8]) -> Option<Record> {
    let chunk = archive::read(payload, &Limits::default()).ok()?.root;
    Some(match chunk.name.as_str() {
        "Begin" => Record::Begin(Box::new(Begin {
            source: Source {
                path: chunk.str("Path").map(str::to_owned),
                hash: chunk.str("Hash").unwrap_or_default().to_owned(),
            },
            saved: chunk.bool("Saved").unwrap_or(false),
            encoding: if chunk.bool("Xml") == Some(true) { Encoding::Xml } else { Encoding::Binary },
            document: chunk.bytes("Document")?.to_vec(),
        })),
        "Step" => {
            let difference = difference::read(&chunk)?;
            Record::Step(Step {
                name: chunk.str("Name").unwrap_or_default().to_owned(),
                gesture: chunk.i64("Gesture").map(i64::cast_unsigned),
                at: chunk.i64("At").unwrap_or(0).cast_unsigned(),
                difference: Arc::new(difference),
            })
        }
        "Undo" => Record::Undo,
        "Redo" => Record::Redo,
        "Abandon" => Record::Abandon,
        _ => return None,
    })
}
