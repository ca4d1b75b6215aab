//! The compute server over its port, as clients meet it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

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
