//! Going from chunk to chunk.

use super::names::{NESTED, holds_chunks, is_opaque};
use super::{OutlineChunk, OutlineContent, OutlineCrc, class_name, name_of};
use crate::typecode;

/// From one offset up to another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Extent {
    pub(super) from: usize,
    pub(super) to: usize,
}

/// What a walk comes upon.
pub(super) enum Found {
    Chunk(Box<OutlineChunk>),
    Broken(usize, String),
}

pub(super) struct Walker<'a> {
    pub(super) bytes: &'a [u8],
    /// Whether lengths take 8 bytes.
    pub(super) is_wide: bool,
    /// Whether chunks marked so end in a CRC-32: from version 2 on.
    pub(super) has_crc: bool,
    pub(super) depth: usize,
}

/// The header of a chunk and where its body is.
#[derive(Debug, Clone, Copy)]
struct Header {
    typecode: u32,
    value: i64,
    offset: usize,
    body: Extent,
}

impl Header {
    fn is_short(&self) -> bool {
        self.typecode & typecode::SHORT != 0
    }

    /// The body without its CRC, and the CRC.
    fn checked(&self, bytes: &[u8]) -> Option<(Extent, u32)> {
        if self.is_short() || self.typecode & typecode::CRC == 0 {
            return None;
        }
        let to = self.body.to.checked_sub(4).filter(|to| *to >= self.body.from)?;
        let stored = bytes.get(to..self.body.to)?.try_into().ok()?;
        Some((Extent { to, ..self.body }, u32::from_le_bytes(stored)))
    }
}

impl Walker<'_> {
    /// The chunks in an extent that holds nothing else.
    pub(super) fn walk(&self, extent: Extent, depth: usize, found: &mut dyn FnMut(Found)) {
        let mut at = extent.from;
        while at < extent.to {
            match self.header(at, extent.to) {
                Ok(header) => {
                    at = header.body.to;
                    let ends = header.typecode == typecode::END_OF_FILE;
                    self.chunk(&header, depth, found);
                    if ends {
                        return;
                    }
                }
                Err(why) => return found(Found::Broken(at, why)),
            }
        }
    }

    fn chunk(&self, header: &Header, depth: usize, found: &mut dyn FnMut(Found)) {
        let checked = header.checked(self.bytes).filter(|_| self.has_crc);
        let body = checked.map_or(header.body, |(body, _)| body);
        let all_chunks = holds_chunks(header.typecode);
        let (crc, nested) = match checked {
            _ if all_chunks => (self.own_crc(checked, &self.chunks_of(body)), Vec::new()),
            Some((body, stored)) => self.look_inside(header, body, stored),
            None => (OutlineCrc::Absent, Vec::new()),
        };
        let content = if header.is_short() {
            OutlineContent::Value(header.value)
        } else {
            OutlineContent::Body { length: (header.body.to - header.body.from) as u64, crc }
        };
        found(Found::Chunk(Box::new(OutlineChunk {
            offset: header.offset,
            depth,
            typecode: header.typecode,
            name: name_of(header.typecode),
            content,
            class: self.class(header, body),
        })));
        if depth >= self.depth || header.is_short() {
            return;
        }
        if all_chunks {
            self.walk(body, depth + 1, found);
        }
        nested.iter().for_each(|header| self.chunk(header, depth + 1, found));
    }

    /// The chunks one behind the other that an extent begins with.
    fn chunks_of(&self, extent: Extent) -> Vec<Header> {
        let mut at = extent.from;
        let next = || {
            let header = (at < extent.to).then(|| self.header(at, extent.to).ok()).flatten()?;
            at = header.body.to;
            Some(header)
        };
        std::iter::from_fn(next).collect()
    }

    fn own_crc(&self, checked: Option<(Extent, u32)>, nested: &[Header]) -> OutlineCrc {
        let Some((body, stored)) = checked else { return OutlineCrc::Absent };
        if self.crc_but(body, nested) == stored { OutlineCrc::Right } else { OutlineCrc::Wrong }
    }

    /// The CRC of a body, whole or without the chunks found in it: whichever fits is how the body is made.
    fn look_inside(&self, header: &Header, body: Extent, stored: u32) -> (OutlineCrc, Vec<Header>) {
        if self.crc_but(body, &[]) == stored {
            return (OutlineCrc::Right, Vec::new());
        }
        // The preview image (0x20008025) holds a compressed buffer, the other properties no chunks.
        let is_leaf =
            matches!(header.typecode, 0x0002_FFFB | 0x2000_8021..=0x2000_8024 | 0x2000_8027 | 0x2000_8031);
        if is_leaf || is_opaque(header.typecode) {
            return (OutlineCrc::Wrong, Vec::new());
        }
        let nested = self.search(body);
        if nested.is_empty() {
            return (OutlineCrc::Wrong, nested);
        }
        let fits = self.crc_but(body, &nested) == stored;
        if fits { (OutlineCrc::Right, nested) } else { (OutlineCrc::Unknown, Vec::new()) }
    }

    /// What looks like chunks among other bytes, from front to back.
    fn search(&self, body: Extent) -> Vec<Header> {
        let mut nested = Vec::new();
        let mut at = body.from;
        while at + 8 <= body.to {
            let four =
                self.bytes.get(at..at + 4).and_then(|four| four.try_into().ok()).map(u32::from_le_bytes);
            let known = four.is_some_and(|four| NESTED.contains(&four));
            match self.header(at, body.to).ok().filter(|_| known) {
                Some(header) => {
                    at = header.body.to;
                    nested.push(header);
                }
                None => at += 1,
            }
        }
        nested
    }

    /// The CRC-32 of an extent without some chunks in it.
    fn crc_but(&self, extent: Extent, nested: &[Header]) -> u32 {
        let mut hasher = crc32fast::Hasher::new();
        let mut at = extent.from;
        for header in nested {
            hasher.update(self.bytes.get(at..header.offset).unwrap_or_default());
            at = header.body.to;
        }
        hasher.update(self.bytes.get(at..extent.to).unwrap_or_default());
        hasher.finalize()
    }

    /// The class named in a class object, or in the record or user data around one.
    fn class(&self, header: &Header, body: Extent) -> Option<String> {
        let of = |extent: Extent| {
            let bytes = self.bytes.get(extent.from..extent.from.checked_add(16)?)?;
            (extent.to - extent.from >= 16).then_some(class_name(bytes.try_into().ok()?))
        };
        match header.typecode {
            typecode::CLASS_UUID => of(body),
            typecode::CLASS => {
                let first = self.header(body.from, body.to).ok()?;
                (first.typecode == typecode::CLASS_UUID).then(|| of(first.body))?
            }
            typecode::OBJECT_RECORD | typecode::LIGHT_RECORD => {
                let class =
                    self.chunks_of(body).into_iter().find(|header| header.typecode == typecode::CLASS)?;
                self.class(&class, class.body)
            }
            _ => None,
        }
    }

    /// The chunk that begins at an offset and lies within a limit.
    fn header(&self, offset: usize, limit: usize) -> Result<Header, String> {
        let width = if self.is_wide { 8 } else { 4 };
        let from = offset + 4 + width;
        let head = self.bytes.get(offset..from).filter(|_| from <= limit);
        let head = head.ok_or_else(|| format!("{} bytes are no chunk", limit.saturating_sub(offset)))?;
        let (code, value) = head.split_at(4);
        let code = u32::from_le_bytes(code.try_into().unwrap_or_default());
        let short = code & typecode::SHORT != 0;
        let value = match <[u8; 8]>::try_from(value) {
            Ok(wide) => i64::from_le_bytes(wide),
            Err(_) => {
                let narrow = value.try_into().unwrap_or_default();
                let signed = short && !typecode::is_unsigned_short(code);
                if signed { i32::from_le_bytes(narrow).into() } else { u32::from_le_bytes(narrow).into() }
            }
        };
        let length = if short { Some(0) } else { usize::try_from(value).ok() };
        let to = length.and_then(|length| from.checked_add(length)).filter(|to| *to <= limit);
        let to = to.ok_or_else(|| {
            format!(
                "a chunk {code:08X} says to have {value} bytes, but {} are left",
                limit.saturating_sub(from)
            )
        })?;
        Ok(Header { typecode: code, value, offset, body: Extent { from, to } })
    }
}
