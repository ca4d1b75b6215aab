//! Sections moved along rails.

mod one;
mod pipe;
mod run;
mod section;
mod skinning;
mod two;

pub use one::{Miter, SweepFrame, SweepOptions, sweep_one};
pub use pipe::{PipeCap, pipe, pipe_variable};
pub use two::sweep_two;
