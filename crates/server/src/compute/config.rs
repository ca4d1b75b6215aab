use std::net::{IpAddr, Ipv4Addr};
use std::time::Duration;

use katydid_component::Limits;
use katydid_compute::HostKey;

use super::pool::Places;

/// The port that Hops and most clients of Rhino.Compute look for.
pub(crate) const PORT: u16 = 6500;

/// How a compute server runs.
#[derive(Debug, Clone)]
pub struct Config {
    /// The address that it listens on.
    pub address: IpAddr,
    /// The port; 0 for any that is free.
    pub port: u16,
    /// What a client must know, in the header `RhinoComputeKey`. Needed where others than this machine can ask.
    pub key: Option<String>,
    /// The pages that may ask from a browser, as `https://example.org`, or `*` for all. When there are none, all may ask
    /// a server that has a key, and those of this machine one that has none.
    pub origins: Vec<String>,
    /// The hosts that definitions may be fetched from and that Hops components may ask, as `example.org` or
    /// `127.0.0.1:8081`; none when there are none.
    pub hosts: Vec<String>,
    /// Certificates in PEM form of the authorities that are believed over https; those that browsers believe when it
    /// is empty.
    pub authorities: Vec<u8>,
    /// The server that solves definitions which Hops components name by an address, as `http://127.0.0.1:5000`; they
    /// are solved here when there is none. Its host is listed too.
    pub hops_server: Option<String>,
    /// The keys that servers ask for which Hops components ask.
    pub hops_keys: Vec<HostKey>,
    /// How long a request may take, waiting included, and how long a job may run.
    pub timeout: Duration,
    /// How long a job may run.
    pub job_timeout: Duration,
    /// The most bytes of a request, packed and unpacked.
    pub most_body: usize,
    /// What each object of a definition may put out.
    pub limits: Limits,
    /// The most bytes that all requests together may take while they are worked on.
    pub total_bytes: u64,
    /// How many solves run at a time; by the number of processors when not given.
    pub workers: Option<usize>,
    /// How many requests may wait for their turn.
    pub most_waiting: usize,
    /// How many jobs are kept, finished ones too.
    pub most_jobs: usize,
    /// How long the result of a job is kept.
    pub keep_jobs: Duration,
    /// The most bytes of definitions that are kept for the next request.
    pub cache_bytes: usize,
    /// How long requests that are under way have to end when the server stops.
    pub grace: Duration,
}

impl Default for Config {
    /// On this machine alone, without a key, with the limits of Rhino.Compute.
    fn default() -> Self {
        Self {
            address: IpAddr::V4(Ipv4Addr::LOCALHOST),
            port: PORT,
            key: None,
            origins: Vec::new(),
            hosts: Vec::new(),
            authorities: Vec::new(),
            hops_server: None,
            hops_keys: Vec::new(),
            timeout: Duration::from_secs(100),
            job_timeout: Duration::from_secs(3600),
            most_body: 52_428_800,
            limits: Limits::default(),
            total_bytes: 4 * Limits::default().bytes,
            workers: None,
            most_waiting: 1024,
            most_jobs: 256,
            keep_jobs: Duration::from_secs(600),
            cache_bytes: 256 << 20,
            grace: Duration::from_secs(30),
        }
    }
}

impl Config {
    /// The key, when there is one that says something.
    pub(crate) fn key(&self) -> Option<&str> {
        self.key.as_deref().map(str::trim).filter(|key| !key.is_empty())
    }

    pub(crate) fn places(&self) -> Places {
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        let quick = self.workers.unwrap_or(processors.max(2)).max(1);
        let half = quick.div_ceil(2);
        Places { quick, new: half, slow: half.max(2), spare: 6, waiting: self.most_waiting }
    }
}
