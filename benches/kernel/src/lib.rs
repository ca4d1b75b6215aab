//! What the kernel's benchmarks share: the inputs on which the peers were measured, and the same objects in each
//! kernel's own types.

pub mod inputs;
pub mod operations;
pub mod peers;
pub mod timing;

pub use inputs::Inputs;
