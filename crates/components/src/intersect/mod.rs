//! The Intersect tab.

mod mathematical;
mod physical;
