//! A request solved: inputs set, objects run, results for the reply.

mod bounds;
mod solution;

pub use bounds::Bounds;
pub use solution::{Answer, Solution, Timings};
