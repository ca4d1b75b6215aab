//! PLY, as Greg Turk's description of the Stanford triangle format has it.

mod header;
mod read;
mod write;

pub(crate) use read::read;
pub(crate) use write::write;

const FORMAT: &str = "PLY";
