//! Chunks, the one structure everything in an archive is built from (section 2): a typecode, a value that is
//! either data (short chunk) or a body length (long chunk), and for many long chunks a CRC at the end.

mod context;
mod reader;
mod writer;

pub(crate) use context::Context;
pub(crate) use reader::{Chunk, Reader};
pub(crate) use writer::Writer;

#[cfg(test)]
mod tests;
