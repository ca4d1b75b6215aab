//! Where a search is: what its method was told and asked for.

use std::collections::HashMap;
use std::sync::mpsc::Sender;

use super::goals::scored;
use super::nsga2::dominates;
use super::run::{Best, OptimiseSettings};
use super::search::{Scored, Search, order};
use crate::effects::sample::Space;
use crate::folder::Log;
use crate::record::{Kept, Name};
use crate::store::Store;
use crate::sweep::Names;
use crate::thresholds::REPEATS;
use crate::{Cell, Outcome, StudyError};

/// A point that is to be solved: its row in the table, its name and its inputs.
pub(super) type Asked = (u64, Name, Vec<Cell>);

/// Where a search is.
pub(super) struct Turn<'a> {
    settings: &'a OptimiseSettings,
    space: Space,
    pub(super) names: Names,
    search: Box<dyn Search>,
    /// Where points to be solved go; `None` when there are no more.
    send: Option<Sender<Asked>>,
    /// All different points, in the order in which they were asked for.
    pub(super) points: Vec<Vec<Cell>>,
    known: HashMap<Name, Outcome>,
    /// Places of the cube that were asked for, with the names of their points.
    batch: Vec<(Vec<f64>, Name)>,
    /// How many points of the batch are being solved.
    waiting: usize,
    /// How many batches in a row had no new point.
    idle: usize,
    /// How many points there were when the best was found.
    bettered: usize,
    best: Option<Scored>,
    pub(super) had: u64,
    pub(super) ended: String,
    pub(super) store: Store,
    pub(super) log: Log,
}

impl<'a> Turn<'a> {
    /// The beginning of a search; points to be solved go to `send`.
    pub(super) fn new(
        settings: &'a OptimiseSettings,
        space: Space,
        names: Names,
        search: Box<dyn Search>,
        send: Sender<Asked>,
        store: Store,
        log: Log,
    ) -> Self {
        Self {
            settings,
            space,
            names,
            search,
            send: Some(send),
            points: Vec::new(),
            known: HashMap::new(),
            batch: Vec::new(),
            waiting: 0,
            idle: 0,
            bettered: 0,
            best: None,
            had: 0,
            ended: String::new(),
            store,
            log,
        }
    }

    /// Takes what a point gave, and asks for more where it was the last of its batch.
    ///
    /// # Errors
    /// A file cannot be read or written.
    pub(super) fn take(&mut self, number: u64, point: &[Cell], kept: &Kept) -> Result<(), StudyError> {
        self.store.keep(kept)?;
        self.log.row(number, point, kept)?;
        self.known.insert(kept.name, kept.outcome.clone());
        self.waiting -= 1;
        self.go_on()
    }

    /// Has no further points solved: workers that wait for more are let go.
    pub(super) fn end(&mut self) {
        self.send = None;
    }

    /// Tells the method what its points are worth and asks for the next, until there are some to be solved or it is over.
    ///
    /// # Errors
    /// A file cannot be read or written.
    pub(super) fn go_on(&mut self) -> Result<(), StudyError> {
        while self.waiting == 0 && self.send.is_some() {
            let batch = std::mem::take(&mut self.batch);
            if !batch.is_empty() {
                let scored: Vec<Scored> = batch
                    .into_iter()
                    .filter_map(|(place, name)| Some(self.scored(place, self.known.get(&name)?)))
                    .collect();
                for one in &scored {
                    if self.best.as_ref().is_none_or(|best| order(one, best).is_lt()) {
                        (self.best, self.bettered) = (Some(one.clone()), self.points.len());
                    }
                }
                self.search.tell(scored);
            }
            if let Some(why) = self.over() {
                self.ended = why;
                self.send = None;
                break;
            }
            self.ask()?;
        }
        Ok(())
    }

    fn over(&self) -> Option<String> {
        let found = self.points.len();
        if found >= self.settings.evaluations {
            return Some(format!("{found} points are solved"));
        }
        if self.idle >= REPEATS {
            return Some("the search comes back to points that it knows".to_owned());
        }
        let waited = found - self.bettered;
        let patience = self.settings.patience.filter(|patience| found > 0 && waited >= *patience)?;
        Some(format!("{patience} points brought nothing better"))
    }

    fn ask(&mut self) -> Result<(), StudyError> {
        let before = self.points.len();
        for place in self.search.ask() {
            let point = self.space.point(&place);
            let name = self.names.name(&point);
            let is_new =
                !self.known.contains_key(&name) && !self.batch.iter().any(|(_, other)| *other == name);
            if is_new {
                if self.points.len() >= self.settings.evaluations {
                    continue;
                }
                let number = self.points.len() as u64;
                self.points.push(point.clone());
                match self.store.get(&name)? {
                    Some(kept) => {
                        self.had += 1;
                        self.log.row(number, &point, &kept)?;
                        self.known.insert(name, kept.outcome);
                    }
                    None => {
                        self.store.take(&name)?;
                        if let Some(send) = &self.send
                            && send.send((number, name, point)).is_ok()
                        {
                            self.waiting += 1;
                        }
                    }
                }
            }
            self.batch.push((place, name));
        }
        self.idle = if self.points.len() > before { 0 } else { self.idle + 1 };
        Ok(())
    }

    fn scored(&self, place: Vec<f64>, outcome: &Outcome) -> Scored {
        scored(place, outcome, &self.settings.objectives, &self.settings.constraints)
    }

    /// All points that no other is better than; where none has results, none.
    pub(super) fn front(&self) -> Vec<Best> {
        let all = self.points.iter().enumerate().filter_map(|(at, point)| {
            let outcome = self.known.get(&self.names.name(point))?;
            let scored = self.scored(Vec::new(), outcome);
            scored.missed.is_finite().then_some((at, scored, outcome))
        });
        let mut front: Vec<(usize, Scored, &Outcome)> = Vec::new();
        for one in all {
            let same = |other: &Scored| other.goals == one.1.goals && other.missed == one.1.missed;
            if front.iter().any(|(_, other, _)| dominates(other, &one.1) || same(other)) {
                continue;
            }
            front.retain(|(_, other, _)| !dominates(&one.1, other));
            front.push(one);
        }
        front.sort_by(|a, b| order(&a.1, &b.1));
        let best = front.into_iter().map(|(point, scored, outcome)| Best {
            point,
            inputs: self.points.get(point).cloned().unwrap_or_default(),
            outputs: outcome.cells.clone(),
            holds: scored.missed == 0.0,
        });
        best.collect()
    }
}
