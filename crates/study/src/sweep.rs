//! A definition solved at all points of a plan, into a folder that can be gone on with.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use katydid_component::Cancel;
use katydid_definition::document::Document;
use katydid_solver::Options;

use crate::folder::Log;
use crate::record::{Kept, Name, name_of};
use crate::solver::{options_of, solved};
use crate::store::Store;
use crate::{About, Cell, DefinitionFile, Plan, Prepared, Status, StudyError, Things, pool, table};

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
    let store = open_store(plan, folder, settings)?;
    let about = About::new(settings.definition.as_ref(), plan.variables(), plan.outputs(), plan.count());
    let log = Mutex::new(Log::begin(folder, &about)?);
    let things = Things::new(plan.pictures, plan.geometry.as_deref())?;
    things.make_folders(folder)?;
    let options = options_of(plan, options, &settings.cancel);
    let prepared = Prepared::new(document, options, plan.variables().to_vec(), plan.outputs().to_vec());

    let had = AtomicU64::new(0);
    let mut progress = Progress { points: plan.count(), ..Progress::default() };
    let store = Mutex::new(store);
    let names = Names::of(plan);
    let cancelled = || settings.cancel.is_cancelled();
    let tasks = (0..).zip(plan.points()?).filter_map(|(number, point)| {
        let point = match point {
            _ if cancelled() => return Some(Err(StudyError::Stopped)),
            Ok(point) => point,
            Err(error) => return Some(Err(error)),
        };
        let name = names.name(&point);
        let mut store = store.lock().unwrap_or_else(PoisonError::into_inner);
        if store.take(&name) {
            return Some(Ok((number, name, point)));
        }
        had.fetch_add(1, Ordering::Relaxed);
        // One that is being solved under another number has no results yet.
        let kept = store.get(&name).transpose()?;
        let told = |kept: Kept| log.lock().unwrap_or_else(PoisonError::into_inner).row(number, &point, &kept);
        kept.and_then(told).err().map(Err)
    });
    let work = |worker: &mut crate::Worker<'_>,
                (number, name, point): (u64, Name, Vec<Cell>)|
     -> Result<(u64, Vec<Cell>, Kept), StudyError> {
        let (kept, made) = solved(worker, &things, name, &point);
        // A disk that is full is no property of the point.
        made.iter().flatten().try_for_each(|thing| thing.write(folder))?;
        Ok((number, point, kept))
    };
    let swept = pool::each(&prepared, settings.workers, tasks, work, |solved| {
        let (number, point, kept) = solved?;
        // What was cancelled half-way is no result.
        if cancelled() {
            return Err(StudyError::Stopped);
        }
        store.lock().unwrap_or_else(PoisonError::into_inner).keep(&kept)?;
        log.lock().unwrap_or_else(PoisonError::into_inner).row(number, &point, &kept)?;
        progress.solved += 1;
        progress.failed += u64::from(!kept.outcome.status.is_good());
        progress.had = had.load(Ordering::Relaxed);
        progress.elapsed = start.elapsed();
        tell(&progress);
        Ok(())
    });
    let mut store = store.into_inner().unwrap_or_else(PoisonError::into_inner);
    let synced = store.sync();
    swept.and(synced)?;
    progress.had = had.load(Ordering::Relaxed);
    progress.elapsed = start.elapsed();
    tell(&progress);
    let mut get = |point: &[Cell]| store.get(&names.name(point));
    let (files, failed_rows) = table::write(plan, folder, &mut get)?;
    log.into_inner().unwrap_or_else(PoisonError::into_inner).finish()?;
    Ok(Summary { progress, failed_rows, files })
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
