//! Source text to syntax trees.

pub mod ast;
mod lexer;
mod number;
mod parser;
mod text;
pub mod token;

pub use lexer::tokens;
pub use parser::parse;
