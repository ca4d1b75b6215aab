//! What a Rhino.Compute server answers: definitions solved and geometry functions called, as JSON. It listens to nobody:
//! a server hands over bodies and writes out what comes back. It asks only hosts that were listed (`web`).
//!
//! A [`Compute`] is shared by all requests. It keeps definitions by what they are called in later requests (see
//! [`Compute::load`]) and solves each request on its own copy, so that no request sees what another one brought.
//!
//! ```
//! use katydid_compute::{Bounds, Compute, Settings, SolveRequest};
//!
//! let compute = Compute::new(Settings::default());
//! let request = SolveRequest::read(br#"{"pointer": "md5_0", "values": []}"#, &compute.settings().request)?;
//! assert!(compute.locate(&request).is_err());
//! # let _ = Bounds::default();
//! # Ok::<(), katydid_compute::Fault>(())
//! ```

pub mod cache;
mod compute;
pub mod definition;
pub mod geometry;
mod hops;
pub mod reply;
pub mod request;
pub mod solve;
mod web;

pub use compute::{Compute, Located, Settings};
pub use definition::{Definition, Description};
pub use hops::{HopsSettings, hops};
pub use katydid_members::{Cause, Fault, wire};
pub use reply::{Reply, to_json};
pub use request::{CacheControl, RequestLimits, SolveRequest};
pub use solve::{Answer, Bounds, Solution, Timings};
pub use web::{HostKey, WebSettings};
