//! The Intersect tab.

mod collision;
mod contour;
mod mathematical;
mod mesh_boolean;
mod meshes;
mod physical;
mod piercing;
pub(crate) mod planes;
mod view;
