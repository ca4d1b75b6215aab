//! What a Rhino.Compute server answers: definitions solved and geometry functions called, as JSON. No sockets: a server
//! hands over bodies and writes out what comes back.

mod fault;
pub mod wire;

pub use fault::{Cause, Fault};
