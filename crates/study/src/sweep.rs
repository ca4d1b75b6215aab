//! A definition solved at all points of a plan, into a folder that can be gone on with.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use katydid_component::Cancel;
use katydid_definition::document::Document;
use katydid_solver::Options;

use crate::folder::Log;
use crate::lock::locked;
use crate::pool::Pool;
use crate::record::{Kept, Name, name_of};
use crate::solver::{options_of, solved};
use crate::store::Store;
use crate::{About, Cell, DefinitionFile, Plan, Prepared, Status, StudyError, Things, table};

/// How a sweep is made.
#[derive(Debug, Clone, Default)]
pub struct Settings {
    /// How many points are solved side by side.
    pub workers: usize,
    /// Whether points that failed before are solved again.
    pub retry: bool,
    /// What the results hang on besides the plan: the bytes of the definition and of its model, what else was set. Points
    /// of the same study are not solved twice.
    pub identity: Vec<u8>,
    /// The file of the definition, for whoever looks at the study later.
    pub definition: Option<DefinitionFile>,
    /// How long an answer is waited for beyond one and a half of a point's time limit, before the point is lost; half a minute
    /// when not given.
    pub grace: Option<Duration>,
    /// Stops the sweep from outside.
    pub cancel: Cancel,
}

/// How far a sweep has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Progress {
    /// Points of the plan.
    pub points: u64,
    /// Points that were solved before, or are the same as another.
    pub had: u64,
    /// Points that were solved now.
    pub solved: u64,
    /// Of those, how many gave no usable result.
    pub failed: u64,
    /// How long it has taken.
    pub elapsed: Duration,
}

/// What a sweep came to.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Summary {
    /// The counts at the end.
    pub progress: Progress,
    /// Rows of the table without a usable result, with those that failed in earlier runs.
    pub failed_rows: u64,
    /// The files that were written.
    pub files: Vec<PathBuf>,
}

/// Solves all points of a plan that the folder does not have, and writes its tables: `table.parquet`; `data.csv` as Design
/// Explorer reads it; `failed.csv` with the points that gave no result and why; `times.csv` with the milliseconds.
///
/// The tables have the same bytes for any number of workers and any number of interruptions. Before, while points are solved,
/// [`StudyFolder`](crate::StudyFolder) reads them from `points.jsonl`.
///
/// # Errors
/// A file cannot be read or written, or somebody asked to stop; what was solved by then is kept.
pub fn sweep(
    document: Document,
    options: Options,
    plan: &Plan,
    folder: &Path,
    settings: &Settings,
    mut tell: impl FnMut(&Progress),
) -> Result<Summary, StudyError> {
    let start = Instant::now();
    let store = Arc::new(Mutex::new(open_store(plan, folder, settings)?));
    let about = About::new(settings.definition.as_ref(), plan.variables(), plan.outputs(), plan.count());
    let log = Arc::new(Mutex::new(Log::begin(folder, &about)?));
    let things = Things::new(plan.pictures, plan.geometry.as_deref())?;
    things.make_folders(folder)?;
    let options = options_of(plan, options, &settings.cancel);
    let prepared = Prepared::new(document, options, plan.variables().to_vec(), plan.outputs().to_vec());

    let had = Arc::new(AtomicU64::new(0));
    let mut progress = Progress { points: plan.count(), ..Progress::default() };
    let unsolved = Unsolved {
        points: (0_u64..).zip(plan.points()?),
        names: Names::of(plan),
        store: store.clone(),
        log: log.clone(),
        had: had.clone(),
        cancel: settings.cancel.clone(),
    };
    let into = folder.to_path_buf();
    let work = move |worker: &mut crate::Worker<'_>, Task { number, name, point }: Task| -> Solved {
        let (kept, made) = solved(worker, &things, name, &point);
        // A disk that is full is no property of the point.
        made.iter().flatten().try_for_each(|thing| thing.write(&into))?;
        Ok((number, point, kept))
    };
    let lost = |Task { number, name, point }: Task, outcome| -> Solved {
        Ok((number, point, Kept { name, outcome, files: Default::default() }))
    };
    let pool = Pool::new(prepared, settings.workers, settings.grace);
    let swept = pool.each(unsolved, work, lost, |solved: Solved| {
        let (number, point, kept) = solved?;
        // What was cancelled half-way is no result.
        if settings.cancel.is_cancelled() {
            return Err(StudyError::Stopped);
        }
        locked(&store).keep(&kept)?;
        locked(&log).row(number, &point, &kept)?;
        progress.solved += 1;
        progress.failed += u64::from(!kept.outcome.status.is_good());
        progress.had = had.load(Ordering::Relaxed);
        progress.elapsed = start.elapsed();
        tell(&progress);
        Ok(())
    });
    let mut store = locked(&store);
    let synced = store.sync();
    swept.and(synced)?;
    progress.had = had.load(Ordering::Relaxed);
    progress.elapsed = start.elapsed();
    tell(&progress);
    let names = Names::of(plan);
    let (files, failed_rows) = table::write(plan, folder, &mut |point| store.get(&names.name(point)))?;
    locked(&log).finish()?;
    Ok(Summary { progress, failed_rows, files })
}

/// A point that is to be solved: its number in the plan, its name, its values.
#[derive(Debug, Clone)]
struct Task {
    number: u64,
    name: Name,
    point: Vec<Cell>,
}

/// A point that was solved, with its number in the plan.
type Solved = Result<(u64, Vec<Cell>, Kept), StudyError>;

/// The points of a plan that are not solved; those that are go to the log as they are met.
struct Unsolved<P> {
    points: P,
    names: Names,
    store: Arc<Mutex<Store>>,
    log: Arc<Mutex<Log>>,
    /// How many points were solved already, or are the same as another.
    had: Arc<AtomicU64>,
    cancel: Cancel,
}

impl<P: Iterator<Item = (u64, Result<Vec<Cell>, StudyError>)>> Iterator for Unsolved<P> {
    type Item = Result<Task, StudyError>;

    fn next(&mut self) -> Option<Self::Item> {
        loop {
            let (number, point) = self.points.next()?;
            if self.cancel.is_cancelled() {
                return Some(Err(StudyError::Stopped));
            }
            match point.and_then(|point| self.looked_at(number, point)) {
                Ok(None) => {}
                Ok(Some(task)) => return Some(Ok(task)),
                Err(error) => return Some(Err(error)),
            }
        }
    }
}

impl<P> Unsolved<P> {
    /// The task that a point is, or `None` where it is solved or being solved.
    fn looked_at(&self, number: u64, point: Vec<Cell>) -> Result<Option<Task>, StudyError> {
        let name = self.names.name(&point);
        let mut store = locked(&self.store);
        if store.take(&name)? {
            return Ok(Some(Task { number, name, point }));
        }
        self.had.fetch_add(1, Ordering::Relaxed);
        // One that is being solved under another number has no results yet.
        if let Some(kept) = store.get(&name)? {
            locked(&self.log).row(number, &point, &kept)?;
        }
        Ok(None)
    }
}

/// The store of a plan's study in a folder; both are made where they are not there.
///
/// # Errors
/// A file cannot be read or written.
pub(crate) fn open_store(plan: &Plan, folder: &Path, settings: &Settings) -> Result<Store, StudyError> {
    let study = study_name(plan, settings);
    let cache = folder.join("cache");
    fs::create_dir_all(&cache).map_err(|error| StudyError::file(&cache, error))?;
    let hex: String = study.iter().map(|byte| format!("{byte:02x}")).collect();
    let forget = |status: Status| settings.retry && !status.is_good();
    Store::open(&cache.join(format!("{hex}.kdstudy")), &study, forget)
}

/// What names points: their values behind the names of the inputs.
#[derive(Debug)]
pub(crate) struct Names(blake3::Hasher);

impl Names {
    pub(crate) fn of(plan: &Plan) -> Self {
        let mut hasher = blake3::Hasher::new();
        for variable in plan.variables() {
            named(&mut hasher, variable.name.as_bytes());
        }
        Self(hasher)
    }

    pub(crate) fn name(&self, point: &[Cell]) -> Name {
        let mut hasher = self.0.clone();
        hasher.update(&Cell::to_bytes(point));
        name_of(&hasher)
    }
}

/// The name of a study: what all its points have in common.
fn study_name(plan: &Plan, settings: &Settings) -> Name {
    let mut hasher = blake3::Hasher::new();
    named(&mut hasher, env!("CARGO_PKG_VERSION").as_bytes());
    named(&mut hasher, &settings.identity);
    for output in plan.outputs() {
        named(&mut hasher, output.name.as_bytes());
    }
    named(&mut hasher, format!("{} {:?}", plan.pictures, plan.geometry).as_bytes());
    name_of(&hasher)
}

/// Adds bytes with their length, so that two lists of them never look the same.
fn named(hasher: &mut blake3::Hasher, bytes: &[u8]) {
    hasher.update(&(bytes.len() as u64).to_le_bytes());
    hasher.update(bytes);
}
