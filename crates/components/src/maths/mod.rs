//! The Maths tab.

mod arithmetic;
pub(crate) mod formula;

mod operators;
