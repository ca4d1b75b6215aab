//! The book's worked numbers.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a failing assertion is how a test reports"
)]

#[path = "../common/mod.rs"]
mod common;

mod curves;
mod matrices;
mod vectors;
