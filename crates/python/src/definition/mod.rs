//! A definition: opened, asked for its inputs and outputs, solved, saved, compared.

mod difference;
mod input;
mod limits;
mod message;
mod opened;
mod output;
mod picture;
mod solution;
mod source;

pub(crate) use difference::{Change, diff};
pub(crate) use input::Input;
pub(crate) use message::Message;
pub(crate) use opened::Definition;
pub(crate) use output::Output;
pub(crate) use picture::{geometry_glb, geometry_picture};
pub(crate) use solution::Solution;
pub(crate) use source::{bytes, extension};
