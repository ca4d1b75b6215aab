//! What all requests share.

use std::collections::HashMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use katydid_component::{Origin, Trust};
use katydid_compute::{Compute, HopsSettings, RequestLimits, Settings, WebSettings};

use super::behind::{Behind, IN_FRONT};
use super::body::Room;
use super::cors::Origins;
use super::health::Trial;
use super::jobs::Jobs;
use super::key::Lock;
use super::memory::Memory;
use super::metrics::Metrics;
use super::pool::{Lane, Pool, SLICE};
use super::refusal::Refusal;
use super::{Config, Processes};
use crate::lock::held;

/// Of the memory for all requests, one part in so many is for those that are worked on in front: they take little.
const PART_IN_FRONT: u64 = 8;

/// The server behind its port.
pub(crate) struct Service {
    pub(crate) config: Config,
    pub(crate) compute: Compute,
    pub(crate) pool: Pool,
    pub(crate) jobs: Jobs,
    pub(crate) metrics: Metrics,
    pub(crate) lock: Lock,
    pub(crate) origins: Origins,
    pub(crate) room: Room,
    pub(crate) memory: Memory,
    pub(crate) pace: Pace,
    pub(crate) trial: Trial,
    pub(crate) idle: Idle,
    /// The process behind, if this is the one in front.
    pub(crate) behind: Option<Behind>,
}

impl Service {
    pub(crate) fn new(mut config: Config, behind: Option<Behind>) -> Self {
        let in_front = config.total_bytes / PART_IN_FRONT;
        match &config.processes {
            Processes::One => {}
            Processes::Two(_) => config.total_bytes = in_front,
            Processes::Behind(_) => config.total_bytes -= in_front,
        }
        if !matches!(config.processes, Processes::One) {
            config.cache_bytes /= 2;
        }
        let memory = Memory::new(config.total_bytes, Pool::most(config.places()));
        if behind.is_none() {
            // What can never be had is no matter of trying again.
            config.limits = config.limits.with_bytes(config.limits.bytes.min(memory.most()));
        }
        let settings = Settings {
            files: Trust::shared(Vec::new()).files(Origin::Sent),
            definitions: config.definitions.clone(),
            cache_bytes: config.cache_bytes,
            request: RequestLimits { bytes: config.most_body, ..RequestLimits::default() },
            web: WebSettings {
                hosts: config.hosts.clone(),
                authorities: config.authorities.clone(),
                bytes: config.most_body,
            },
            hops: HopsSettings {
                server: config.hops_server.clone(),
                keys: config.hops_keys.clone(),
                ..HopsSettings::default()
            },
            scripts: config.scripts.clone(),
            ..Settings::default()
        };
        Self {
            compute: Compute::new(settings),
            pool: Pool::new(config.places()),
            // Results that are kept leave room for what is solved.
            jobs: Jobs::new(config.most_jobs, config.keep_jobs, config.total_bytes / 4),
            metrics: Metrics::default(),
            lock: Lock::new(config.key()),
            origins: Origins::new(&config.origins, config.key().is_some()),
            memory,
            room: Room::new(config.most_body, config.timeout.max(Duration::from_secs(1))),
            pace: Pace::default(),
            trial: Trial::default(),
            idle: Idle::default(),
            behind,
            config,
        }
    }

    /// Notes how long a solve took, and why it came to nothing if it did. What is given up in front is done behind, and
    /// counted there.
    pub(crate) fn solved(&self, key: Option<&str>, took: Duration, refusal: Option<&Refusal>) {
        self.idle.touch();
        let slice = if self.behind.is_some() { IN_FRONT } else { SLICE };
        let is_given_up = refusal.is_some_and(Refusal::is_for_lack);
        if let Some(key) = key
            && (refusal.is_none() || took >= slice || (is_given_up && self.behind.is_some()))
        {
            // What was given up early tells nothing, unless it was because there was so little.
            let lane = if took < slice && !is_given_up { Lane::Quick } else { Lane::Slow };
            self.pace.is(key, lane);
        }
        if self.behind.is_none() || !is_given_up {
            self.metrics.solved(took, refusal.map(|refusal| refusal.cause));
        }
    }
}

/// Which definitions took long the last time, and which did not.
#[derive(Debug, Default)]
pub(crate) struct Pace(Mutex<HashMap<String, (Lane, Instant)>>);

impl Pace {
    /// Beyond so many it begins anew: at worst each is new once more.
    const MOST: usize = 4096;
    /// What was slow is looked at anew after so long: it may have been for what else was done then.
    const AGAIN: Duration = Duration::from_secs(60);

    /// Where the next solve of a definition waits.
    pub(crate) fn lane(&self, key: &str) -> Lane {
        match held(&self.0).get(key) {
            Some((Lane::Slow, since)) if since.elapsed() >= Self::AGAIN => Lane::New,
            Some((lane, _)) => *lane,
            None => Lane::New,
        }
    }

    pub(crate) fn is(&self, key: &str, lane: Lane) {
        let mut known = held(&self.0);
        if known.len() >= Self::MOST && !known.contains_key(key) {
            known.clear();
        }
        known.insert(key.to_owned(), (lane, Instant::now()));
    }
}

/// How long ago something was last solved.
#[derive(Debug)]
pub(crate) struct Idle {
    start: Instant,
    /// Milliseconds after the start, plus one; 0 for never.
    last: AtomicU64,
}

impl Default for Idle {
    fn default() -> Self {
        Self { start: Instant::now(), last: AtomicU64::new(0) }
    }
}

impl Idle {
    pub(crate) fn touch(&self) {
        let now = u64::try_from(self.start.elapsed().as_millis()).unwrap_or(u64::MAX - 1);
        self.last.store(now + 1, Ordering::Relaxed);
    }

    /// The seconds since the last solve, if there was one.
    pub(crate) fn seconds(&self) -> Option<u64> {
        let last = self.last.load(Ordering::Relaxed).checked_sub(1)?;
        let since = self.start.elapsed().saturating_sub(Duration::from_millis(last));
        Some(since.as_secs())
    }

    pub(crate) fn uptime(&self) -> Duration {
        self.start.elapsed()
    }
}
