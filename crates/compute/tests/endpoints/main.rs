//! Functions called by path, against closed forms.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

mod breps;
mod curves;
mod edited;
mod helpers;
mod intersections;
mod masses;
mod mended;
mod meshes;
mod shapes;
mod surfaces;
mod table;
mod wrong;
