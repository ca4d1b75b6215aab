//! STL, as the StereoLithography Interface Specification describes it: triangles and nothing else.

mod read;
mod write;

pub(crate) use read::read;
pub(crate) use write::write;

const FORMAT: &str = "STL";
/// The bytes of a header, and of a triangle: its normal, three corners, and 16 bits that mean nothing.
const HEADER: usize = 80;
const TRIANGLE: usize = 50;
