//! The compute server over its port, as clients meet it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

/// As in the program: what solves take is counted.
#[global_allocator]
static ALLOCATOR: katydid_memory::Counting = katydid_memory::Counting;

mod client;
mod contract;
mod definitions;
mod endless;
mod formats;
mod hops;
mod hostile_bodies;
mod hostile_definitions;
mod hostile_geometry;
mod hostile_http;
mod hostile_wires;
mod jobs;
mod pointers;
mod state;
