//! Solving and drawing, when they are due.

use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use katydid_definition::document::Object;
use katydid_session::protocol::Event;
use katydid_session::result_view;
use katydid_solver::{Finished, ObjectReport};
use uuid::Uuid;
use web_time::Instant;

use super::Document;

/// The client is told how far a solve has come after so long, and no oftener.
const APART: Duration = Duration::from_millis(100);

/// What is to be done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Work {
    /// Only drawing.
    Draw,
    /// Solving and drawing.
    Solve,
}

/// How a solve ended.
#[derive(Debug, Clone, Copy)]
pub(super) struct End {
    pub(super) cancelled: bool,
    pub(super) took: Duration,
}

/// The objects that were solved, with what they gave.
type Done = Vec<(Object, ObjectReport)>;

/// Told how far a solve has come while it is running: an event as JSON. It is called from within the solve, so it may
/// only hand the text on.
pub type Progress = fn(&str);

impl Document {
    /// Asks for work; where edits wait for somebody to say so, for drawing alone.
    pub(super) fn want(&mut self, work: Work) {
        let work = if self.editor.about().locked { Work::Draw } else { work };
        self.wanted = self.wanted.max(Some(work));
    }

    /// Whether there is something to be done.
    pub fn is_due(&self) -> bool {
        self.wanted.is_some() || self.study.is_some()
    }

    /// Does what is due: solves, draws, looks, which takes as long as it takes; where nothing of it is, a slice of a study.
    pub fn work(&mut self, progress: Progress) {
        let Some(work) = self.wanted.take() else { return self.study_on() };
        self.number += 1;
        let solved = (work == Work::Solve).then(|| self.solve(progress));
        self.draw();
        if let Some((done, end)) = solved {
            self.publish_results(&done, end);
        }
        self.show_model();
        self.look();
    }

    /// Solves what has changed. What comes of it is told after what it looks like.
    fn solve(&mut self, progress: Progress) -> (Done, End) {
        let due: Vec<Uuid> = {
            let objects = &self.engine.document().objects;
            self.engine.dirty().iter().filter_map(|at| objects.get(*at)).map(|object| object.id).collect()
        };
        self.drafts.touch(due.iter().copied());
        self.analyses.touch(&due);
        let (number, total) = (self.number, u32::try_from(due.len()).unwrap_or(u32::MAX));
        let begin = Instant::now();
        let all = Arc::new(Mutex::new((Done::new(), begin)));
        let own = Arc::clone(&all);
        self.engine.options_mut().finished = Some(Arc::new(move |finished: &Finished<'_>| {
            let mut own = own.lock().unwrap_or_else(PoisonError::into_inner);
            own.0.push((finished.object.clone(), finished.report.clone()));
            if own.1.elapsed() >= APART {
                own.1 = Instant::now();
                let done = u32::try_from(own.0.len()).unwrap_or(u32::MAX);
                let name = finished.object.title().to_owned();
                let event = Event::Solving { solution: number, done, total, name };
                if let Ok(text) = serde_json::to_string(&event) {
                    progress(&text);
                }
            }
        }));
        let summary = self.engine.solve();
        self.engine.options_mut().finished = None;
        let end = End { cancelled: summary.unfinished > 0, took: begin.elapsed() };
        let done = std::mem::take(&mut all.lock().unwrap_or_else(PoisonError::into_inner).0);
        let lookup = Arc::clone(self.editor.lookup());
        for (object, report) in &done {
            if lookup.object(object.id).is_some() {
                self.reports.insert(object.id, report.clone());
            }
        }
        self.end = Some(end);
        (done, end)
    }

    fn publish_results(&mut self, done: &Done, end: End) {
        let style = self.style();
        let results = match self.within.first() {
            None => done.iter().map(|(object, report)| result_view(object, report, &style)).collect(),
            Some(cluster) if done.iter().any(|(object, _)| object.id == *cluster) => self.views(&self.within),
            Some(_) => Vec::new(),
        };
        self.out.say(&Event::Results {
            solution: self.number,
            within: self.within.clone(),
            results,
            finished: true,
            cancelled: end.cancelled,
            milliseconds: end.took.as_secs_f64() * 1e3,
        });
    }
}
