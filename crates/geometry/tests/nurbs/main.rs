//! NURBS curves and surfaces: their numbers, edits that keep the shape, and evaluation of many at once.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a failing assertion is how a test reports"
)]

#[path = "../common/mod.rs"]
mod common;

mod bench_inputs;
mod edit;
mod fast_evaluation;
mod numbers;
