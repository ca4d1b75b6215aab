//! Where a piece of source text stands: which part, which line.

use std::fmt;
use std::sync::Arc;

/// A place in all parts of the source together: an offset in bytes.
pub(crate) type Pos = u32;

/// One text of the source: a file, or one of the three parts of a script component.
#[derive(Debug, Clone)]
pub(crate) struct Part {
    /// What messages call it.
    pub name: Arc<str>,
    /// Its text.
    pub text: Arc<str>,
    base: Pos,
}

/// All parts of the source, each at its own range of places.
#[derive(Debug, Clone, Default)]
pub(crate) struct SourceMap {
    parts: Vec<Part>,
}

/// The most bytes of source in one part.
pub(crate) const MAX_SOURCE: usize = 1 << 22;

/// A place as people count it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Location {
    /// The name of the part.
    pub part: Arc<str>,
    /// The line, counted from 1.
    pub line: u32,
    /// The column in characters, counted from 1.
    pub column: u32,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}({},{})", self.part, self.line, self.column)
    }
}

impl SourceMap {
    /// Adds a text and gives the place of its first byte.
    pub(crate) fn add(&mut self, name: &str, text: &str) -> Pos {
        let base = self.parts.last().map_or(1, |part| part.base + part.text.len() as Pos + 1);
        self.parts.push(Part { name: name.into(), text: text.into(), base });
        base
    }

    fn part(&self, pos: Pos) -> Option<&Part> {
        let after = self.parts.partition_point(|part| part.base <= pos);
        self.parts.get(after.checked_sub(1)?)
    }

    /// The line and column of a place.
    pub(crate) fn locate(&self, pos: Pos) -> Location {
        let Some(part) = self.part(pos) else {
            return Location { part: "".into(), line: 1, column: 1 };
        };
        let mut at = ((pos - part.base) as usize).min(part.text.len());
        while !part.text.is_char_boundary(at) {
            at -= 1;
        }
        let before = &part.text[..at];
        let line = before.bytes().filter(|b| *b == b'\n').count() as u32 + 1;
        let start = before.rfind('\n').map_or(0, |i| i + 1);
        Location { part: part.name.clone(), line, column: before[start..].chars().count() as u32 + 1 }
    }
}
