//! What lies at addresses of other hosts: definitions, and servers that Hops components ask.
//!
//! Nobody is asked but the hosts that were listed. A name is looked up once, and the connection goes to the addresses
//! that were found and looked at: a name that changes in between leads nowhere else. Addresses of this machine and of
//! its network are refused unless they are listed themselves. Who answers with another address is not followed; time
//! and size are bounded. Over https the host has to show a certificate for its name.

mod address;
mod client;
mod hosts;
mod keys;
mod resolver;

use std::time::Duration;

pub(crate) use client::{Asked, Response, Web};
pub(crate) use hosts::authority;
pub use keys::HostKey;

/// Which hosts may be asked, and for how much.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct WebSettings {
    /// The hosts, as `example.org`, `example.org:8080`, `127.0.0.1:3000` or `[::1]:3000`; at any port where none is
    /// named. None at all unless said so.
    pub hosts: Vec<String>,
    /// Certificates in PEM form of the authorities that are believed over https; those that browsers believe when it
    /// is empty.
    pub authorities: Vec<u8>,
    /// The most bytes of one answer, packed and unpacked.
    pub bytes: usize,
}

impl Default for WebSettings {
    /// No host; 50 MiB.
    fn default() -> Self {
        Self { hosts: Vec::new(), authorities: Vec::new(), bytes: 52_428_800 }
    }
}

/// How long a host may take to be found and reached.
const REACH: Duration = Duration::from_secs(5);
