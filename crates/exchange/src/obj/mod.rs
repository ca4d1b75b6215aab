//! Wavefront OBJ, as the Advanced Visualizer manual describes it.

mod read;
mod write;

pub(crate) use read::read;
pub(crate) use write::write;

const FORMAT: &str = "OBJ";
