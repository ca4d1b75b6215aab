//! Grasshopper's expression language and .NET format strings.
//!
//! One small language serves the Expression and Evaluate components, the expression on a parameter (`x*2`),
//! the items of a value list, buttons, sliders and the targets of a path mapper. This crate parses it, binds
//! names to slots, and evaluates: value by value over [`Variant`]s, or in one sweep over columns of numbers.
//! What a file holds is the text after Grasshopper's editor has put symbols in (`π`, `≥`, `²`); both spellings
//! are read.
//!
//! Nothing here knows of trees, components or files. Text that cannot be read is a [`ParseError`] and a value
//! that cannot be computed an [`EvalError`]; both know their place in the text and can draw it.
//!
//! ```
//! use katydid_expression::{Expression, Variant};
//!
//! let program = Expression::parse("if(x≥2, x², -x)")?.bind(&["x"])?;
//! assert_eq!(program.evaluate(&[Variant::Number(3.0)])?, Variant::Number(9.0));
//!
//! let error = Expression::parse("2 * sinn(x)").unwrap_err();
//! assert_eq!(
//!     error.render("2 * sinn(x)"),
//!     "unknown function 'sinn': did you mean 'sin'?\n  2 * sinn(x)\n      ^^^^"
//! );
//! # Ok::<(), katydid_expression::Error>(())
//! ```
//!
//! Where the manual of the original is silent the choices made here are written at the place that makes them.

mod arithmetic;
mod ast;
pub mod circular;
mod columns;
mod compare;
mod complex;
mod error;
pub mod format;
mod functions;
mod lexer;
mod names;
mod operator;
mod parser;
mod program;
mod span;
mod symbols;
mod variant;

pub use ast::Expression;
pub use columns::ColumnError;
pub use error::{Error, EvalError, EvalErrorKind, ParseError, ParseErrorKind};
pub use format::{Dialect, FormatError, format, number_text, parse_number};
pub use functions::{FunctionHelp, functions};
pub use program::{Program, evaluate};
pub use span::Span;
pub use variant::Variant;

/// The longest expression that is read, in bytes. Real ones stay below a few hundred.
pub const MAX_LENGTH: usize = 1 << 16;

/// How deep brackets, signs and operators may nest before the text is refused.
pub const MAX_DEPTH: usize = 256;

/// The longest text an expression may build, in bytes, so that no formula can eat the machine.
pub const MAX_TEXT: usize = 1 << 24;
