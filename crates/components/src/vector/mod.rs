//! The Vector tab.

mod cloud;
mod early;
mod field;
mod field_display;
mod grid;
pub(crate) mod hit;
mod near;
mod plane;
mod point;
mod populate;
mod solar;
mod vectors;
