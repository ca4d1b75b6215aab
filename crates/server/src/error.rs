use std::net::{IpAddr, SocketAddr};

/// Why the server could not start.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Somebody else has the port, or the machine has no such address.
    #[error("{address}: {source}")]
    Listen {
        /// The address.
        address: SocketAddr,
        /// What the system says.
        source: std::io::Error,
    },
    /// Others than this machine could ask a compute server that has no key.
    #[error("{0}: others can reach this address, so a key is needed: --key, or RHINO_COMPUTE_KEY")]
    Key(IpAddr),
    /// The process that does what may take long cannot be started.
    #[error("the second process cannot be started: {0}")]
    Behind(std::io::Error),
    /// The document that it should begin with cannot be opened.
    #[error("{0}")]
    Open(String),
}
