//! A method of optimisation on the workers and the table of a study.

use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Sender, channel};
use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use katydid_definition::document::Document;
use katydid_solver::Options;

use super::cma::Cma;
use super::goals::{Constraint, Objective, scored};
use super::nsga2::{Nsga2, dominates};
use super::search::{Scored, Search, order};
use crate::effects::sample::Space;
use crate::folder::Log;
use crate::record::{Kept, Name};
use crate::store::Store;
use crate::sweep::{Names, open_store};
use crate::thresholds::{MOST_EVALUATIONS, REPEATS};
use crate::{
    About, Cell, Outcome, Output, Plan, Prepared, Progress, Settings, StudyError, Variable, pool, table,
};

/// How the best is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// CMA-ES, for one goal.
    Cma,
    /// NSGA-II with a population of so many, for several goals.
    Nsga2(usize),
}

/// What is to be found, and how.
#[derive(Debug, Clone)]
pub struct OptimiseSettings {
    /// What is to be small or large; at least one.
    pub objectives: Vec<Objective>,
    /// What must hold.
    pub constraints: Vec<Constraint>,
    /// The method.
    pub method: Method,
    /// How many different points are solved at most.
    pub evaluations: usize,
    /// After how many points without a better one the search ends.
    pub patience: Option<usize>,
    /// What random numbers begin with.
    pub seed: u64,
    /// The workers, what the results hang on, and what stops the search.
    pub study: Settings,
}

/// A point that no other is better than.
#[derive(Debug, Clone, PartialEq)]
pub struct Best {
    /// Its row in the table.
    pub point: usize,
    /// The inputs.
    pub inputs: Vec<Cell>,
    /// The outputs.
    pub outputs: Vec<Cell>,
    /// Whether all constraints hold.
    pub holds: bool,
}

/// What a search came to.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Optimum {
    /// For one goal the best point; for several the front, in the order of the first goal.
    pub best: Vec<Best>,
    /// The counts at the end.
    pub progress: Progress,
    /// Why it ended.
    pub ended: String,
    /// The files that were written.
    pub files: Vec<PathBuf>,
}

/// Looks for the inputs that are best for the objectives, and writes all points that were solved as a study's table, in the order
/// in which they were asked for. What the folder has of the study is not solved again, so that a search that was stopped goes on.
/// The points are the same for any number of workers.
///
/// # Errors
/// An input has no range, the objectives do not fit the method, a file cannot be read or written, or somebody asked to stop.
pub fn optimise(
    document: Document,
    options: Options,
    variables: Vec<Variable>,
    outputs: Vec<Output>,
    folder: &Path,
    settings: &OptimiseSettings,
    mut tell: impl FnMut(&Progress),
) -> Result<Optimum, StudyError> {
    let start = Instant::now();
    check(settings, &variables)?;
    let space = Space::of(&variables)?;
    let begin = space.unit();
    let search: Box<dyn Search> = match settings.method {
        Method::Cma => Box::new(Cma::new(begin, settings.seed)),
        Method::Nsga2(size) => Box::new(Nsga2::new(begin, size, settings.seed)),
    };
    let plan = Plan::listed(variables.clone(), outputs.clone(), Vec::new());
    let store = open_store(&plan, folder, &settings.study)?;
    let most = settings.evaluations as u64;
    let about = About::new(settings.study.definition.as_ref(), &variables, &outputs, most);
    let log = Log::begin(folder, &about.searching(&settings.objectives, &settings.constraints))?;
    let options = Options { cancel: settings.study.cancel.clone(), skip_unread: true, ..options };
    let prepared = Prepared::new(document, options, variables.clone(), outputs.clone());
    let store = Mutex::new(store);
    let (send, receive) = channel::<Asked>();
    let mut turn = Turn {
        settings,
        space,
        names: Names::of(&plan),
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
        log,
    };
    turn.go_on(&store)?;
    let mut progress = Progress { points: settings.evaluations as u64, ..Progress::default() };
    let swept = pool::each(
        &prepared,
        settings.study.workers,
        receive.into_iter().map(Ok),
        |worker, (number, name, point): Asked| {
            let kept = Kept { name, outcome: worker.solve(&point), files: Default::default() };
            (number, point, kept)
        },
        |(number, point, kept)| {
            let mut take = || {
                if settings.study.cancel.is_cancelled() {
                    return Err(StudyError::Stopped);
                }
                store.lock().unwrap_or_else(PoisonError::into_inner).keep(&kept)?;
                turn.log.row(number, &point, &kept)?;
                progress.solved += 1;
                progress.failed += u64::from(!kept.outcome.status.is_good());
                turn.known.insert(kept.name, kept.outcome.clone());
                turn.waiting -= 1;
                turn.go_on(&store)?;
                (progress.had, progress.elapsed) = (turn.had, start.elapsed());
                tell(&progress);
                Ok(())
            };
            let taken = take();
            if taken.is_err() {
                // Workers that wait for more are let go.
                turn.send = None;
            }
            taken
        },
    );
    let mut store = store.into_inner().unwrap_or_else(PoisonError::into_inner);
    let synced = store.sync();
    swept.and(synced)?;
    (progress.had, progress.elapsed) = (turn.had, start.elapsed());
    progress.points = turn.points.len() as u64;
    let names = Names::of(&plan);
    let plan = Plan::listed(variables, outputs, turn.points.clone());
    let (files, _) = table::write(&plan, folder, &mut |point| store.get(&names.name(point)))?;
    let best = turn.front();
    turn.log.finish()?;
    Ok(Optimum { best, progress, ended: turn.ended, files })
}

fn check(settings: &OptimiseSettings, variables: &[Variable]) -> Result<(), StudyError> {
    let unfit = |why: String| Err(StudyError::Unfit(why));
    if variables.is_empty() {
        return unfit("there is no input to move".to_owned());
    }
    match (settings.objectives.len(), settings.method) {
        (0, _) => return unfit("nothing is to be small or large".to_owned()),
        (n, Method::Cma) if n > 1 => return unfit(format!("CMA-ES has one goal, not {n}: use NSGA-II")),
        _ => {}
    }
    if settings.evaluations == 0 || settings.evaluations > MOST_EVALUATIONS {
        return unfit(format!("a search solves 1 to {MOST_EVALUATIONS} points"));
    }
    Ok(())
}

/// A point that is to be solved: its row in the table, its name and its inputs.
type Asked = (u64, Name, Vec<Cell>);

/// Where a search is.
struct Turn<'a> {
    settings: &'a OptimiseSettings,
    space: Space,
    names: Names,
    search: Box<dyn Search>,
    /// Where points to be solved go; `None` when there are no more.
    send: Option<Sender<Asked>>,
    /// All different points, in the order in which they were asked for.
    points: Vec<Vec<Cell>>,
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
    had: u64,
    ended: String,
    log: Log,
}

impl Turn<'_> {
    /// Tells the method what its points are worth and asks for the next, until there are some to be solved or it is over.
    fn go_on(&mut self, store: &Mutex<Store>) -> Result<(), StudyError> {
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
            self.ask(store)?;
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

    fn ask(&mut self, store: &Mutex<Store>) -> Result<(), StudyError> {
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
                let mut store = store.lock().unwrap_or_else(PoisonError::into_inner);
                match store.get(&name)? {
                    Some(kept) => {
                        self.had += 1;
                        self.log.row(number, &point, &kept)?;
                        self.known.insert(name, kept.outcome);
                    }
                    None => {
                        store.take(&name);
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
    fn front(&self) -> Vec<Best> {
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
