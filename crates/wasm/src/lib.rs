//! The engine for web pages and for Node: what a server does for the studio, without one.
//!
//! [`Definition`] opens a definition, sets its inputs, solves it and gives values, pictures and files: what the npm
//! package is made of. [`Document`] speaks the protocol of `katydid_session::protocol` with one client, as a server's
//! socket does, and keeps a journal of what was edited. `bindings` hands both to JavaScript.
//!
//! Everything here is plain Rust that also compiles outside of a page. There is one thread: who has something solved
//! waits for it, and results come in one piece.

pub mod bindings;
mod definition;
mod document;
mod journal;
mod opening;
mod outgoing;

pub use definition::{Data, Definition, Put};
pub use document::{Document, Progress};
pub use journal::{Written, written};
pub use opening::{Opened, form_of, open, options};
pub use outgoing::Message;

/// What is taken is counted, so that the limits of memory hold.
#[cfg(target_family = "wasm")]
#[global_allocator]
static ALLOCATOR: katydid_memory::Counting = katydid_memory::Counting;
