//! Every kind of geometry through every transform and deformation of the stock: nothing is refused, and every point goes
//! where the map says.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]

mod affine;
mod kinds;
mod morphs;
