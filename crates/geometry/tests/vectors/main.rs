//! Vectors, transforms, and shapes known by formula.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a failing assertion is how a test reports"
)]

#[path = "../common/mod.rs"]
mod common;

mod analytic;
mod vectors;
mod xforms;
