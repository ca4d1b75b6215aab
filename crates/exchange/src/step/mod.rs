//! STEP: scenes as documents of exact geometry, and back.

mod read;
mod write;

pub(crate) use read::read;
pub(crate) use write::write;
