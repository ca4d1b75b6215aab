//! A method of optimisation on the workers and the table of a study.

use std::path::{Path, PathBuf};
use std::sync::mpsc::channel;
use std::time::Instant;

use katydid_definition::document::Document;
use katydid_solver::Options;

use super::cma::Cma;
use super::goals::{Constraint, Objective};
use super::nsga2::Nsga2;
use super::search::Search;
use super::turn::{Asked, Turn};
use crate::effects::sample::Space;
use crate::folder::Log;
use crate::pool::Pool;
use crate::record::Kept;
use crate::sweep::{Names, open_store};
use crate::thresholds::MOST_EVALUATIONS;
use crate::{About, Cell, Output, Plan, Prepared, Progress, Settings, StudyError, Variable, table};

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
    let (send, receive) = channel::<Asked>();
    let mut turn = Turn::new(settings, space, Names::of(&plan), search, send, store, log);
    turn.go_on()?;
    let mut progress = Progress { points: settings.evaluations as u64, ..Progress::default() };
    let result = |(number, name, point): Asked, outcome| {
        (number, point, Kept { name, outcome, files: Default::default() })
    };
    let swept = Pool::new(prepared, settings.study.workers, settings.study.grace).each(
        receive.into_iter().map(Ok),
        move |worker, asked: Asked| {
            let outcome = worker.solve(&asked.2);
            result(asked, outcome)
        },
        result,
        |(number, point, kept)| {
            let mut take = || {
                if settings.study.cancel.is_cancelled() {
                    return Err(StudyError::Stopped);
                }
                turn.take(number, &point, &kept)?;
                progress.solved += 1;
                progress.failed += u64::from(!kept.outcome.status.is_good());
                (progress.had, progress.elapsed) = (turn.had, start.elapsed());
                tell(&progress);
                Ok(())
            };
            let taken = take();
            if taken.is_err() {
                // Workers that wait for more are let go.
                turn.end();
            }
            taken
        },
    );
    let synced = turn.store.sync();
    swept.and(synced)?;
    (progress.had, progress.elapsed) = (turn.had, start.elapsed());
    progress.points = turn.points.len() as u64;
    let plan = Plan::listed(variables, outputs, turn.points.clone());
    let best = turn.front();
    let Turn { names, mut store, log, ended, .. } = turn;
    let (files, _) = table::write(&plan, folder, &mut |point| store.get(&names.name(point)))?;
    log.finish()?;
    Ok(Optimum { best, progress, ended, files })
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
