//! What all requests share.

use std::collections::HashMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use katydid_component::{Origin, Trust};
use katydid_compute::{Compute, HopsSettings, RequestLimits, Settings, WebSettings};

use super::Config;
use super::body::Room;
use super::cors::Origins;
use super::health::Trial;
use super::jobs::Jobs;
use super::key::Lock;
use super::memory::Memory;
use super::metrics::Metrics;
use super::pool::{Lane, Pool, SLICE};
use crate::lock::held;

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
}

impl Service {
    pub(crate) fn new(mut config: Config) -> Self {
        let memory = Memory::new(config.total_bytes, Pool::most(config.places()));
        // What can never be had is no matter of trying again.
        config.limits = config.limits.with_bytes(config.limits.bytes.min(memory.most()));
        let settings = Settings {
            files: Trust::shared(Vec::new()).files(Origin::Sent),
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
            config,
        }
    }
}

/// Which definitions took long the last time, and which did not.
#[derive(Debug, Default)]
pub(crate) struct Pace(Mutex<HashMap<String, Lane>>);

impl Pace {
    /// Beyond so many it begins anew: at worst each is new once more.
    const MOST: usize = 4096;

    /// Where the next solve of a definition waits.
    pub(crate) fn lane(&self, key: &str) -> Lane {
        held(&self.0).get(key).copied().unwrap_or(Lane::New)
    }

    pub(crate) fn took(&self, key: &str, time: Duration) {
        let mut known = held(&self.0);
        if known.len() >= Self::MOST && !known.contains_key(key) {
            known.clear();
        }
        known.insert(key.to_owned(), if time < SLICE { Lane::Quick } else { Lane::Slow });
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
