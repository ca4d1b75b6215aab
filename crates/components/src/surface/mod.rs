//! The Surface tab.

mod boxes;
mod measure;
