//! The exchange structure: how entities and their values are spelled (ISO 10303-21).

mod lexer;
mod parse;
mod sheet;
mod text;
mod value;

pub(crate) use parse::{Bounds, parse};
pub(crate) use sheet::{Id, Sheet, list, quoted, real};
pub(crate) use value::{Instance, Structure, Value};
