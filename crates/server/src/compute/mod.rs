//! Answers as Rhino.Compute does: definitions solved, geometry functions called, on a port of its own.
//!
//! What is asked for is found in `katydid-compute`, which knows nothing of sockets. Here are the addresses (`route`), the
//! middleware that every request passes (`middleware`: ids, keys, other sites' pages, logs, figures), the threads that solve
//! (`pool`), work that nobody waits for (`jobs`), and definitions fetched from elsewhere (`fetch`).
//!
//! ```no_run
//! # async fn run() -> Result<(), katydid_server::Error> {
//! let server = katydid_server::compute::start(katydid_server::compute::Config::default()).await?;
//! println!("{}", server.url());
//! server.stop().await;
//! # Ok(())
//! # }
//! ```

mod about;
mod asked;
mod behind;
mod body;
mod config;
mod cors;
mod form;
mod geometry;
mod health;
mod jobs;
mod key;
mod memory;
mod metrics;
mod middleware;
mod openapi;
mod pool;
mod query;
mod refusal;
mod route;
mod sent;
mod server;
mod service;
mod solve;
mod work;

pub use behind::{Command, Orders, stand_behind, stand_in_front};
pub use config::{Config, Processes};
pub use server::{Server, start};
