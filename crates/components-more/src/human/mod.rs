//! Human: previews with colours and line weights, objects of other models, and objects baked with attributes.
//!
//! Names and ports are those of public lists, ids as far as files show them.

mod attributes;
mod bake;
mod blocks;
mod display;
mod drawing;
mod expand;
mod lists;
mod screen;
mod tables;
mod units;

pub(crate) use drawing::regions;
pub(crate) use lists::by_pattern;
