//! What a probe has read already.

use std::collections::HashMap;

use web_time::Instant;

use crate::probe::Reading;

/// Between which two numbers of which variable a change is asked for.
type Question = (usize, [u64; 2]);

/// Readings that were made, and when the slice ends in which new ones may be.
#[derive(Debug, Clone, Default)]
pub(crate) struct Known {
    readings: HashMap<Box<[Option<u64>]>, Reading>,
    changes: HashMap<Question, Option<String>>,
    until: Option<Instant>,
    /// Whether the slice has had something new.
    has_new: bool,
    is_over: bool,
    /// Whether what was asked last was known.
    is_replaying: bool,
    /// After how many solves the time of the search was over.
    time_over_at: Option<u64>,
}

impl Known {
    /// What readings are told apart by: the bits of what the variables stand at.
    pub(crate) fn key(at: &[Option<f64>]) -> Box<[Option<u64>]> {
        at.iter().map(|x| x.map(f64::to_bits)).collect()
    }

    pub(crate) fn begin(&mut self, until: Instant) {
        (self.until, self.has_new, self.is_over, self.is_replaying) = (Some(until), false, false, true);
    }

    pub(crate) fn is_over(&self) -> bool {
        self.is_over
    }

    /// Whether the time of the search is over after so many solves.
    pub(crate) fn is_time_over(&mut self, solves: u64, is_over: impl FnOnce() -> bool) -> bool {
        if self.time_over_at.is_none() && !self.is_replaying && is_over() {
            self.time_over_at = Some(solves);
        }
        self.time_over_at.is_some_and(|at| solves >= at)
    }

    /// Whether nothing new may be begun: asked where something would be.
    pub(crate) fn ends(&mut self) -> bool {
        self.is_over |= self.has_new && self.until.is_some_and(|until| Instant::now() >= until);
        self.is_over
    }

    pub(crate) fn reading(&mut self, key: &[Option<u64>]) -> Option<Reading> {
        let found = self.readings.get(key).cloned();
        self.is_replaying = found.is_some();
        found
    }

    pub(crate) fn keep(&mut self, key: Box<[Option<u64>]>, reading: Reading) {
        self.has_new = true;
        self.readings.insert(key, reading);
    }

    pub(crate) fn change(&self, question: &Question) -> Option<Option<String>> {
        self.changes.get(question).cloned()
    }

    pub(crate) fn keep_change(&mut self, question: Question, answer: Option<String>) {
        self.has_new = true;
        self.changes.insert(question, answer);
    }
}
