use std::net::{IpAddr, Ipv4Addr};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use katydid_component::Limits;
use katydid_compute::HostKey;
use katydid_solver::ScriptMaker;

use super::behind::{Command, Orders};
use super::pool::Places;

/// The port that Hops and most clients of Rhino.Compute look for.
pub(crate) const PORT: u16 = 6500;

/// Which process works on what is asked for.
#[derive(Debug, Clone, Default)]
pub enum Processes {
    /// This one on everything.
    #[default]
    One,
    /// This one on what is known to be quick. All else is worked on in another, which this command starts: what takes
    /// long, takes much memory or fails there does not hold up the rest or end the server.
    Two(Command),
    /// This is the other one, and does what the first sends it.
    Behind(Orders),
}

/// So many requests are worked on in front for each solve that runs at a time.
const IN_FRONT: usize = 4;

/// How a compute server runs.
#[derive(Debug, Clone)]
pub struct Config {
    /// Which process works on what.
    pub processes: Processes,
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
    /// The folders below which a pointer may name the file of a definition by its path; none when there are none.
    pub definitions: Vec<PathBuf>,
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
    /// What runs the scripts of definitions; none run unless it is there. Whoever can ask can then run programs here.
    pub scripts: Option<Arc<dyn ScriptMaker>>,
    /// How long requests that are under way have to end when the server stops.
    pub grace: Duration,
}

impl Default for Config {
    /// On this machine alone, without a key, with the limits of Rhino.Compute.
    fn default() -> Self {
        Self {
            processes: Processes::One,
            address: IpAddr::V4(Ipv4Addr::LOCALHOST),
            port: PORT,
            key: None,
            origins: Vec::new(),
            hosts: Vec::new(),
            definitions: Vec::new(),
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
            scripts: None,
            grace: Duration::from_secs(30),
        }
    }
}

impl Config {
    /// The key, when there is one that says something. The process behind has one of its own.
    pub(crate) fn key(&self) -> Option<&str> {
        let key = match &self.processes {
            Processes::Behind(orders) => Some(orders.key()),
            _ => self.key.as_deref(),
        };
        key.map(str::trim).filter(|key| !key.is_empty())
    }

    /// How many solves can run at a time, as a rule.
    pub(crate) fn workers(&self) -> usize {
        let places = Self { processes: Processes::One, ..self.clone() }.places();
        places.quick + places.slow
    }

    /// What may run in this process.
    pub(crate) fn places(&self) -> Places {
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        let quick = self.workers.unwrap_or(processors.max(2)).max(1);
        let half = quick.div_ceil(2);
        if matches!(self.processes, Processes::Two(_)) {
            // Each has a short slice: the system lets all of them go on at a time, and nobody waits for a place.
            return Places { quick: IN_FRONT * quick, new: 0, slow: 0, spare: 0, waiting: self.most_waiting };
        }
        Places { quick, new: half, slow: half.max(2), spare: 6, waiting: self.most_waiting }
    }
}
