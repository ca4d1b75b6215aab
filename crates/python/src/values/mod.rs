//! Values of a definition as Python's, and back.

mod colour;
mod given;
mod opaque;
mod python;
mod tree;

pub(crate) use colour::Colour;
pub(crate) use given::given;
pub(crate) use opaque::Item;
pub(crate) use python::{column_to_python, to_python};
pub(crate) use tree::Tree;
