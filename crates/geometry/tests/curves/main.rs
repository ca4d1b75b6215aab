//! Curves: what each can do, what is made of them, and regions in the plane.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "a failing assertion is how a test reports"
)]

#[path = "../common/mod.rs"]
mod common;

mod analysis;
mod circles;
mod closed_offsets;
mod closest;
mod differential;
mod flat;
mod forms;
mod interpolation;
mod lengths;
mod made;
mod make;
mod offsets;
mod oracle;
mod pieces;
mod region_laws;
mod regions;
