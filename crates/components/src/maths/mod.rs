//! The Maths tab.

mod arithmetic;
mod operators;
