//! Sets / Sequence.

mod cull;
mod generate;
mod random;
mod repeat;
