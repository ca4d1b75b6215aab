//! glTF 2.0 (ISO/IEC 12113:2022), as text with its data inside, and as one binary file.
//!
//! glTF measures in metres, has y up, and single precision. Layers are nodes that hold those of their objects.

mod accessor;
mod colour;
mod document;
mod file;
mod plan;
mod read;
mod write;

pub(crate) use read::read;
pub(crate) use write::{write_glb, write_gltf};

const FORMAT: &str = "glTF";
