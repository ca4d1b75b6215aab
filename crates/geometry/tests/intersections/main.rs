//! Where curves, surfaces and solids meet each other and planes.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a failing assertion is how a test reports"
)]

#[path = "../common/mod.rs"]
mod common;

mod curve_surface;
mod curves;
mod sections;
mod solid_sections;
mod split;
