//! A request solved: inputs set, objects run, results for the reply.

mod bounds;
mod run;
mod solution;
mod states;

pub use bounds::Bounds;
pub(crate) use run::{MOST_RECURSION, run};
pub use solution::{Answer, Solution, Timings};
pub(crate) use states::States;
