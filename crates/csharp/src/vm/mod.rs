//! The machine: registers, heap, operations.

mod arith;
mod array;
mod call;
mod decimal;
mod dynamic;
pub mod elements;
pub mod heap;
mod machine;
mod member;
mod narrow;
mod native;
pub mod op;
mod plain;
pub(crate) mod real;
mod start;
mod state;
mod unwind;
pub mod value;

pub(crate) use array::copy;
pub(crate) use decimal::overflow as decimal_overflow;
pub(crate) use start::run;
pub use state::{Limits, Raise, State, Stop};
