//! A definition is made, changed, undone, saved and opened again, as a user would.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail loudly")]

#[path = "../common/mod.rs"]
mod common;

mod controls;
mod given;
mod hand;
mod made;
mod ports;
mod published;
mod scripts;
mod several;
mod steps;
mod transformed;
mod wires;
