//! Files as documents.

use crate::{Document, Result};

/// What is read at most of a file that nobody vouches for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Entities of the file.
    pub entities: usize,
}
impl Default for Limits {
    fn default() -> Self {
        Self { entities: 50_000_000 }
    }
}
/// r
pub fn read(bytes: &[u8]) -> Result<Document> {
    read_with(bytes, &Limits::default())
}
/// r
pub fn read_with(bytes: &[u8], limits: &Limits) -> Result<Document> {
    let _ = crate::part21::parse(bytes, crate::part21::Bounds { entities: limits.entities, depth: 16 })?;
    Ok(Document::default())
}
