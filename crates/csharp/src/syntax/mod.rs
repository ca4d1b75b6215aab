//! Source text to syntax trees.

pub(crate) mod ast;
mod declaration;
mod lexer;
mod number;
mod parser;
mod text;
pub(crate) mod token;

pub(crate) use lexer::tokens;
pub(crate) use parser::parse;
