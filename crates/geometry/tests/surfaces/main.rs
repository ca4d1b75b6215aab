//! Surfaces: their kinds, their laws, and the nearest points on them.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a failing assertion is how a test reports"
)]

#[path = "../common/mod.rs"]
mod common;

mod closest;
mod closest_local;
mod developable;
mod evaluation;
mod kinds;
mod laws;
