//! Sets / Sequence.

mod cull;
mod generate;
mod random;
mod recurrence;
mod repeat;
