//! C# as script components use it.
#![forbid(unsafe_code)]
pub mod bind;
pub mod bound;
pub mod diagnostic;
pub mod sema;
pub mod source;
pub mod syntax;
