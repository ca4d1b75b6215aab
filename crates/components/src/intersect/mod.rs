//! The Intersect tab.

mod collision;
mod contour;
mod mathematical;
mod physical;
mod piercing;
pub(crate) mod planes;
mod view;
