//! The compute server over its port, as clients meet it.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod client;
mod contract;
mod definitions;
mod endless;
mod formats;
mod hostile_bodies;
mod hostile_definitions;
mod hostile_http;
mod jobs;
mod pointers;
mod state;
