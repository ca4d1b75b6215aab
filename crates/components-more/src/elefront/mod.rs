//! EleFront: objects of the Rhino model by layer, name and user text, their attributes, and objects baked with such.
//!
//! Its documentation tells what each does and which attributes there are; names and ports are those of public lists. The model is
//! the file given with `--model`, and what is baked goes into that of `katydid run -o`.

mod annotations;
mod attributes;
mod bake;
mod blocks;
mod changes;
mod criteria;
mod filter;
mod layers;
mod reference;
mod trees;

pub(crate) use attributes::texts;
pub(crate) use changes::modified;
pub(crate) use reference::{model, objects};
