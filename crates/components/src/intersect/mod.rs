//! The Intersect tab.

mod mathematical;
mod mesh_boolean;
mod meshes;
mod physical;
