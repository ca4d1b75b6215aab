//! The Vector tab.

mod cloud;
mod grid;
pub(crate) mod hit;
mod near;
mod plane;
mod point;
mod populate;
mod vectors;
