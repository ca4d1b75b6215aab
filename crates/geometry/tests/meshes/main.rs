//! Meshes: their laws, booleans, and those of implicit functions.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a failing assertion is how a test reports"
)]

#[path = "../common/mod.rs"]
mod common;

mod booleans;
mod clouds;
mod isosurfaces;
mod laws;
mod of_breps;
