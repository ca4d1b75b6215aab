//! EleFront: objects of the Rhino model by layer, name and user text, their attributes, and objects baked with such.
//!
//! Its documentation tells what each does and which attributes there are; names and ports are those of public lists. The model is
//! the file given with `--model`, and what is baked goes into that of `katydid run -o`.

mod attributes;
mod bake;
mod reference;

pub(crate) use attributes::texts;
