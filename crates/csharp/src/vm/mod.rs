//! The machine: registers, heap, operations.

mod arith;
mod call;
pub mod heap;
mod machine;
pub mod op;
mod state;
mod unwind;
pub mod value;

pub(crate) use machine::{copy, run};
pub use state::{Limits, Raise, State, Stop};
