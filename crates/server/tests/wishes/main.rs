//! What users of compute servers ask for, one test a wish. Those that need the program itself, as a process of its own,
//! are in `crates/cli/tests/serve_wishes.rs`.
//!
//! | wish | tests |
//! | --- | --- |
//! | memory that does not grow | `serve_wishes.rs` |
//! | a hung worker does not say that it is healthy; busy is told from dead | `health`, `serve_wishes.rs` |
//! | right answers when requests overlap, whatever is asked for | `overlap` |
//! | long work: submit, poll, fetch | `jobs` |
//! | a running solve is cancelled, and its thread is free | `cancel` |
//! | it runs anywhere, without a licence | `serve_wishes.rs` |
//! | optimisers and timers without a canvas say so | `headless` |
//! | optional inputs, and defaults, of geometry too | `defaults` |
//! | the trees of the definition | `trees` |
//! | any type through a Data parameter | `types` |
//! | units, tolerances and a model for each request | `documents` |
//! | a definition by its path, .ghx too | `files` |
//! | functions of another program as components | `functions` |
//! | caches that can be refused; errors are never kept | `caches` |
//! | scripts where they are allowed, other programs never | `programs` |

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, reason = "a test may fail loudly")]
#![allow(clippy::print_stdout, reason = "what was measured is told, and not asserted")]

/// As in the program: what solves take is counted.
#[global_allocator]
static ALLOCATOR: katydid_memory::Counting = katydid_memory::Counting;

#[allow(dead_code, reason = "the tests of the server use the rest")]
#[path = "../compute/client.rs"]
mod client;
#[allow(dead_code, reason = "the tests of the server use the rest")]
#[path = "../compute/definitions.rs"]
mod definitions;

mod caches;
mod cancel;
mod defaults;
mod documents;
mod files;
mod functions;
mod headless;
mod health;
mod jobs;
mod overlap;
mod programs;
mod stuck;
mod trees;
mod types;
