//! Solves that nobody waits for: asked for now, looked after later.

mod events;
mod routes;

use std::collections::HashMap;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use katydid_component::Cancel;
use serde_json::{Value, json};
use tokio::sync::watch;
use uuid::Uuid;

use super::refusal::Refusal;
use super::work::Solved;
use crate::lock::held;

pub(crate) use events::events;
pub(crate) use routes::{about, cancel, result, submit};

/// How far a job is.
#[derive(Debug, Clone)]
enum Stage {
    Waiting,
    Running { done: usize, total: usize, name: String },
    Done(Arc<Solved>),
    Failed(Refusal),
    Cancelled,
}

impl Stage {
    fn is_over(&self) -> bool {
        matches!(self, Self::Done(_) | Self::Failed(_) | Self::Cancelled)
    }

    fn name(&self) -> &'static str {
        match self {
            Self::Waiting => "waiting",
            Self::Running { .. } => "running",
            Self::Done(_) => "done",
            Self::Failed(_) => "failed",
            Self::Cancelled => "cancelled",
        }
    }
}

/// A solve that nobody waits for.
#[derive(Debug)]
pub(crate) struct Job {
    id: String,
    cancel: Cancel,
    since: Instant,
    stage: watch::Sender<Stage>,
    /// When it was over.
    over: Mutex<Option<Instant>>,
}

impl Job {
    /// Goes on to a stage; what is over stays so.
    fn go_on(&self, stage: Stage) {
        let is_over = stage.is_over();
        let changed = self.stage.send_if_modified(|now| {
            let changes = !now.is_over();
            if changes {
                *now = stage;
            }
            changes
        });
        if changed && is_over {
            *held(&self.over) = Some(Instant::now());
        }
    }

    /// Waits until it is cancelled.
    async fn cancelled(&self) {
        let mut stage = self.stage.subscribe();
        let _ = stage.wait_for(|stage| matches!(stage, Stage::Cancelled)).await;
    }

    /// The bytes that its result takes.
    fn weight(&self) -> u64 {
        match &*self.stage.borrow() {
            Stage::Done(solved) => solved.weight(),
            _ => 0,
        }
    }

    fn age(&self) -> Option<Duration> {
        held(&self.over).map(|over| over.elapsed())
    }

    /// What is told of it.
    fn about(&self, stage: &Stage) -> Value {
        let Self { id, .. } = self;
        let seconds = held(&self.over).unwrap_or_else(Instant::now).saturating_duration_since(self.since);
        let mut about = json!({"id": id, "state": stage.name(), "seconds": seconds.as_secs_f64()});
        match stage {
            Stage::Running { done, total, name } => {
                about["progress"] = json!({"done": done, "total": total, "name": name});
            }
            Stage::Done(solved) => {
                about["hasErrors"] = solved.has_errors().into();
                about["result"] = format!("/jobs/{id}/result").into();
            }
            Stage::Failed(refusal) => {
                about["error"] = refusal.message.clone().into();
                about["cause"] = refusal.cause.into();
            }
            Stage::Waiting | Stage::Cancelled => {}
        }
        about
    }
}

/// All jobs that are kept.
#[derive(Debug)]
pub(crate) struct Jobs {
    all: Mutex<HashMap<String, Arc<Job>>>,
    most: usize,
    keep: Duration,
    /// The most bytes that all results together take.
    bytes: u64,
}

impl Jobs {
    pub(crate) fn new(most: usize, keep: Duration, bytes: u64) -> Self {
        Self { all: Mutex::default(), most, keep, bytes }
    }

    /// A new job. The oldest results make room when there is none.
    fn add(&self) -> Result<Arc<Job>, Refusal> {
        let mut all = held(&self.all);
        all.retain(|_, job| job.age().is_none_or(|age| age < self.keep));
        if all.len() >= self.most {
            let ages = all.values().filter_map(|job| Some((job.age()?, job.id.clone())));
            let oldest = ages.max_by_key(|(age, _)| *age).map(|(_, id)| id);
            let busy = || Refusal::busy("too many jobs run already: try again later", 10);
            all.remove(&oldest.ok_or_else(busy)?);
        }
        let id = Uuid::new_v4().simple().to_string();
        let job = Arc::new(Job {
            id: id.clone(),
            cancel: Cancel::default(),
            since: Instant::now(),
            stage: watch::Sender::new(Stage::Waiting),
            over: Mutex::new(None),
        });
        all.insert(id, Arc::clone(&job));
        Ok(job)
    }

    fn get(&self, id: &str) -> Result<Arc<Job>, Refusal> {
        let job = held(&self.all).get(id).cloned();
        let job = job.filter(|job| job.age().is_none_or(|age| age < self.keep));
        job.ok_or_else(|| Refusal::missing("there is no such job, or its result is kept no longer"))
    }

    /// Lets a job go that is over.
    fn forget(&self, id: &str) {
        held(&self.all).remove(id);
    }

    /// How many are in each stage.
    pub(crate) fn counts(&self) -> Vec<(&'static str, usize)> {
        let mut counts = ["waiting", "running", "done", "failed", "cancelled"].map(|name| (name, 0));
        for job in held(&self.all).values() {
            let name = job.stage.borrow().name();
            counts.iter_mut().filter(|(own, _)| *own == name).for_each(|(_, count)| *count += 1);
        }
        counts.to_vec()
    }

    /// Stops all that run.
    pub(crate) fn cancel_all(&self) {
        for job in held(&self.all).values() {
            job.cancel.cancel();
            job.go_on(Stage::Cancelled);
        }
    }

    /// Lets results go that are kept no longer, and the oldest of those that are too much together.
    pub(crate) fn sweep(&self) {
        let mut all = held(&self.all);
        all.retain(|_, job| job.age().is_none_or(|age| age < self.keep));
        let mut results: Vec<_> =
            all.values().filter_map(|job| Some((job.age()?, job.weight(), job.id.clone()))).collect();
        results.sort_by_key(|(age, ..)| *age);
        let mut bytes = 0_u64;
        for (_, weight, id) in results {
            bytes = bytes.saturating_add(weight);
            // The newest stays, however large it is.
            if bytes > self.bytes && bytes > weight {
                all.remove(&id);
            }
        }
    }
}
