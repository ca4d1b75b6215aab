//! A solve that goes on while other calls are answered.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use katydid_component::Cancel;
use serde_json::{Value, json};

/// How a job stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum State {
    /// It waits for the one before it to end, or solves.
    Running,
    /// All that was due is solved.
    Done,
    /// Somebody cancelled it: what was solved until then is kept.
    Cancelled,
    /// It failed in a way that it must not.
    Failed,
}

impl State {
    fn word(self) -> &'static str {
        match self {
            Self::Running => "running",
            Self::Done => "done",
            Self::Cancelled => "cancelled",
            Self::Failed => "failed",
        }
    }
}

/// A solve of one state of a definition.
#[derive(Debug)]
pub(crate) struct Job {
    /// Its number, from 1.
    pub(crate) number: u64,
    /// The definition's id.
    pub(crate) document: String,
    /// The number of the state that is solved.
    pub(crate) revision: u64,
    /// Stops it.
    pub(crate) cancel: Cancel,
    began: Instant,
    done: AtomicUsize,
    total: AtomicUsize,
    inner: Mutex<Inner>,
}

#[derive(Debug)]
struct Inner {
    state: State,
    last: String,
    took: Duration,
    solved: usize,
    unfinished: usize,
}

impl Job {
    pub(crate) fn new(number: u64, document: String, revision: u64) -> Arc<Self> {
        let inner = Inner {
            state: State::Running,
            last: String::new(),
            took: Duration::ZERO,
            solved: 0,
            unfinished: 0,
        };
        Arc::new(Self {
            number,
            document,
            revision,
            cancel: Cancel::default(),
            began: Instant::now(),
            done: AtomicUsize::new(0),
            total: AtomicUsize::new(0),
            inner: Mutex::new(inner),
        })
    }

    fn inner(&self) -> std::sync::MutexGuard<'_, Inner> {
        self.inner.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes note that one more object is done.
    pub(crate) fn progress(&self, done: usize, total: usize, name: &str) {
        self.done.fetch_max(done, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
        name.clone_into(&mut self.inner().last);
    }

    /// Takes note of the end.
    pub(crate) fn end(&self, state: State, solved: usize, unfinished: usize) {
        let mut inner = self.inner();
        (inner.state, inner.solved, inner.unfinished) = (state, solved, unfinished);
        inner.took = self.began.elapsed();
    }

    pub(crate) fn state(&self) -> State {
        self.inner().state
    }

    pub(crate) fn is_running(&self) -> bool {
        self.state() == State::Running
    }

    /// How many objects are done, of how many, and the one that was done last.
    pub(crate) fn so_far(&self) -> (usize, usize, String) {
        (self.done.load(Ordering::Relaxed), self.total.load(Ordering::Relaxed), self.inner().last.clone())
    }

    /// As an answer has it.
    pub(crate) fn told(&self) -> Value {
        let (done, total, last) = self.so_far();
        let inner = self.inner();
        let took = if inner.state == State::Running { self.began.elapsed() } else { inner.took };
        let mut told = json!({
            "job": self.number,
            "document": self.document,
            "state": inner.state.word(),
            "revision": self.revision,
            "milliseconds": (took.as_secs_f64() * 1e4).round() / 10.0,
        });
        match inner.state {
            State::Running => told["progress"] = json!({ "done": done, "of": total, "last": last }),
            _ => told["solved"] = json!(inner.solved),
        }
        if inner.unfinished > 0 {
            told["unfinished"] = json!(inner.unfinished);
        }
        told
    }
}
