//! Wavefront OBJ, as the Advanced Visualizer manual describes it.

mod materials;
mod read;
mod write;

pub(crate) use materials::write as write_materials;
pub(crate) use read::read;
pub(crate) use write::write;

const FORMAT: &str = "OBJ";

/// A colour's part of 255 as a number to 1 that gives the part back when it is rounded.
fn share(part: u8) -> f64 {
    (f64::from(part) / 255.0 * 1e4).round() / 1e4
}

/// What stands behind the first word of a line, without blanks around it.
fn rest<'a>(line: &'a str, word: &str) -> &'a str {
    line.trim_start().strip_prefix(word).unwrap_or_default().trim()
}
