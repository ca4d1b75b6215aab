//! Two servers, each on a port of its own, which share the loop that takes connections (`listen`) and the way to
//! compare secrets (`secret`).
//!
//! The studio's: the page, documents over a WebSocket, geometry and files over HTTP. Each document has a thread that owns it (`document`) and a thread that solves; nothing of either runs on the
//! threads that serve sockets. Who does not read fast enough is told the newest state, never everything in between.
//!
//! ```no_run
//! # async fn run() -> Result<(), katydid_server::Error> {
//! let server = katydid_server::start(katydid_server::Config::default()).await?;
//! println!("{}", server.url());
//! server.stop().await;
//! # Ok(())
//! # }
//! ```
//!
//! The other speaks as Rhino.Compute does: [`compute`].

pub mod compute;
mod config;
mod document;
mod error;
mod files;
mod framing;
mod geometry;
mod http;
mod listen;
mod lock;
mod names;
mod secret;
mod server;

pub use config::{Config, ScriptConfig, StudyConfig};
pub use error::Error;
pub use server::{Server, start};
