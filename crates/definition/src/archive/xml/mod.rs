//! The tree as XML: `<Archive>` around `<items>` and `<chunks>`, as .ghx files have it.

mod number;
mod read;
mod text;
mod value;
mod write;

pub(super) use read::read;
pub(super) use text::looks_like_xml;
pub(super) use write::write;
