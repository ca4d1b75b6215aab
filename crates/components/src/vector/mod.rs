//! The Vector tab.

mod grid;
mod plane;
mod point;
mod vector;
