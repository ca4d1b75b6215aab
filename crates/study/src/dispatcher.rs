//! A study whose points are solved elsewhere: on other machines, or as a program asks for them.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use katydid_component::Cancel;

use crate::folder::Log;
use crate::pool::Pool;
use crate::record::{Kept, Name, decode, record};
use crate::store::Store;
use crate::sweep::{Names, open_store};
use crate::thresholds::LEAST_HAND_OUT;
use crate::{
    About, Cell, DefinitionFile, Outcome, Plan, PlanPoints, Prepared, Progress, Settings, Status, StudyError,
    Summary, Thing, Things, plan, table,
};

/// Hands out the points of a study that are not solved, takes their results, and writes the tables.
///
/// Nothing is taken twice: of two results of a point the first counts. What is handed out and never comes back is handed out
/// again by the next dispatcher of the study.
pub struct Dispatcher {
    plan: Plan,
    folder: PathBuf,
    store: Store,
    names: Names,
    /// The points of the plan that were not looked at, and how many were.
    rest: PlanPoints,
    looked_at: u64,
    /// The points of the plan that are handed out, with their places in it.
    handed: HashMap<Name, (u64, Vec<Cell>)>,
    /// What is told of the plan's points while they are solved; none before the first is handed out.
    log: Option<Log>,
    definition: Option<DefinitionFile>,
    /// Points that a program asked for, in that order, each once.
    asked: Vec<Vec<Cell>>,
    known: HashSet<Name>,
    start: Instant,
    progress: Progress,
}

impl std::fmt::Debug for Dispatcher {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Dispatcher")
            .field("folder", &self.folder)
            .field("progress", &self.progress)
            .finish_non_exhaustive()
    }
}

impl Dispatcher {
    /// Opens the study of a plan in a folder, which is made where it is not there. Of the settings, the workers do not count.
    ///
    /// # Errors
    /// A file cannot be read or written, or somebody else works on the study.
    pub fn open(plan: Plan, folder: &Path, settings: &Settings) -> Result<Self, StudyError> {
        let store = open_store(&plan, folder, settings)?;
        Things::new(plan.pictures, plan.geometry.as_deref())?.make_folders(folder)?;
        Ok(Self {
            rest: plan.points()?,
            looked_at: 0,
            handed: HashMap::new(),
            log: None,
            definition: settings.definition.clone(),
            names: Names::of(&plan),
            progress: Progress { points: plan.count(), ..Progress::default() },
            plan,
            folder: folder.to_path_buf(),
            store,
            asked: Vec::new(),
            known: HashSet::new(),
            start: Instant::now(),
        })
    }

    /// How far it has come.
    pub fn progress(&self) -> Progress {
        Progress { elapsed: self.start.elapsed(), ..self.progress }
    }

    /// The next points of the plan that are to be solved, at most so many; none when all are handed out.
    ///
    /// # Errors
    /// The file with the points cannot be read, or a file of the study cannot be written.
    pub fn next_points(&mut self, most: usize) -> Result<Vec<Vec<Cell>>, StudyError> {
        if self.log.is_none() {
            self.log = Some(Log::begin(&self.folder, &self.about(&self.plan))?);
        }
        let mut found = Vec::new();
        while found.len() < most {
            let Some(point) = self.rest.next() else { break };
            let (number, point) = (self.looked_at, point?);
            self.looked_at += 1;
            let name = self.names.name(&point);
            if self.store.take(&name)? {
                self.handed.insert(name, (number, point.clone()));
                found.push(point);
                continue;
            }
            self.progress.had += 1;
            // One that is handed out under another number has no results yet.
            if let (Some(kept), Some(log)) = (self.store.get(&name)?, &mut self.log) {
                log.row(number, &point, &kept)?;
            }
        }
        Ok(found)
    }

    fn about(&self, plan: &Plan) -> About {
        About::new(self.definition.as_ref(), plan.variables(), plan.outputs(), plan.count())
    }

    /// Takes records, as [`PointSolver`](crate::PointSolver) makes them, and the files of their points; gives how many points
    /// were new.
    ///
    /// # Errors
    /// A record is damaged or of a point that nobody handed out, or a file cannot be written.
    pub fn keep(&mut self, records: &[u8], things: &[Thing]) -> Result<u64, StudyError> {
        // A row must not name a file that is not there.
        things.iter().try_for_each(|thing| thing.write(&self.folder))?;
        let mut rest = records;
        let mut bytes = Vec::new();
        let mut count = 0;
        while !rest.is_empty() {
            let left = rest.len() as u64;
            let whole = record(&mut rest, left, &mut bytes).is_ok_and(|whole| whole);
            let kept = if whole { decode(&bytes) } else { None };
            let kept =
                kept.ok_or_else(|| StudyError::Unfit("a result that came back is damaged".to_owned()))?;
            count += u64::from(self.keep_one(&kept)?);
        }
        Ok(count)
    }

    /// Records that a point cannot be solved, since what solves it ends or hangs each time.
    ///
    /// # Errors
    /// The store cannot be written, or nobody handed the point out.
    pub fn give_up(&mut self, point: &[Cell], reason: &str, time: Duration) -> Result<(), StudyError> {
        let cells = vec![Cell::Null; self.plan.outputs().len()];
        let outcome = Outcome { status: Status::Lost, reason: reason.to_owned(), cells, time };
        let kept = Kept { name: self.names.name(point), outcome, files: Default::default() };
        self.keep_one(&kept).map(drop)
    }

    fn keep_one(&mut self, kept: &Kept) -> Result<bool, StudyError> {
        if self.store.has(&kept.name)? {
            return Ok(false);
        }
        if !self.store.is_awaited(&kept.name) || kept.outcome.cells.len() != self.plan.outputs().len() {
            return Err(StudyError::Unfit(
                "a result came back of a point that was not handed out".to_owned(),
            ));
        }
        self.store.keep(kept)?;
        if let (Some((number, point)), Some(log)) = (self.handed.remove(&kept.name), &mut self.log) {
            log.row(number, &point, kept)?;
        }
        self.progress.solved += 1;
        self.progress.failed += u64::from(!kept.outcome.status.is_good());
        Ok(true)
    }

    /// Writes the tables of the plan, all of whose points must be solved.
    ///
    /// # Errors
    /// A point is not solved, or a file cannot be read or written.
    pub fn finish(&mut self) -> Result<Summary, StudyError> {
        let summary = self.write(&self.plan.clone())?;
        self.log.take().map_or(Ok(()), |log| log.finish())?;
        Ok(summary)
    }

    /// Writes the tables of the points that were asked for.
    ///
    /// # Errors
    /// A point is not solved, or a file cannot be read or written.
    pub fn finish_asked(&mut self) -> Result<Summary, StudyError> {
        let plan = self.plan.with_points(self.asked.clone());
        self.about(&plan).write(&self.folder)?;
        self.write(&plan)
    }

    fn write(&mut self, plan: &Plan) -> Result<Summary, StudyError> {
        self.store.sync()?;
        let (store, names) = (&mut self.store, &self.names);
        let (files, failed_rows) =
            table::write(plan, &self.folder, &mut |point| store.get(&names.name(point)))?;
        let progress = Progress { points: plan.count(), ..self.progress() };
        Ok(Summary { progress, failed_rows, files })
    }

    /// Takes the points of the study's table, as far as they are solved, for points that were asked for before.
    ///
    /// # Errors
    /// A file cannot be read.
    pub fn ask_as_before(&mut self) -> Result<(), StudyError> {
        let table = self.folder.join("table.parquet");
        let names: Vec<&str> = self.plan.variables().iter().map(|variable| variable.name.as_str()).collect();
        if !table.exists() {
            return Ok(());
        }
        // A table with other inputs is that of another study.
        for point in plan::rows_of(&table, &names).unwrap_or_default() {
            let point = self.fitted(point);
            let name = self.names.name(&point);
            if self.store.has(&name)? && self.known.insert(name) {
                self.asked.push(point);
            }
        }
        Ok(())
    }

    /// A point as the inputs round it.
    pub fn fitted(&self, point: Vec<Cell>) -> Vec<Cell> {
        self.plan.variables().iter().zip(point).map(|(variable, cell)| variable.fitted(cell)).collect()
    }

    /// Asks for points, as [`fitted`](Self::fitted) gives them; gives those that are to be solved.
    ///
    /// # Errors
    /// A file of the study cannot be read or written.
    pub fn ask(&mut self, points: &[Vec<Cell>]) -> Result<Vec<Vec<Cell>>, StudyError> {
        let mut wanted = Vec::new();
        let mut in_batch = HashSet::new();
        for point in points {
            let name = self.names.name(point);
            if self.known.insert(name) {
                self.asked.push(point.clone());
            }
            if self.store.has(&name)? {
                self.progress.had += 1;
            } else if in_batch.insert(name) {
                // What was handed out before and did not come back is handed out again.
                self.store.take(&name)?;
                wanted.push(point.clone());
            }
        }
        Ok(wanted)
    }

    /// The different points that were asked for, in that order.
    pub fn asked_points(&self) -> &[Vec<Cell>] {
        &self.asked
    }

    /// Solves points that were asked for in this process, side by side.
    ///
    /// # Errors
    /// A file cannot be written, or somebody asked to stop.
    pub fn solve_here(
        &mut self,
        prepared: &Prepared,
        points: Vec<Vec<Cell>>,
        workers: usize,
        cancel: &Cancel,
    ) -> Result<(), StudyError> {
        let things = Things::new(self.plan.pictures, self.plan.geometry.as_deref())?;
        // A thread for each few points: more would take longer to start than to solve them.
        let workers = workers.min(points.len().div_ceil(LEAST_HAND_OUT)).max(1);
        let names = Names::of(&self.plan);
        let asked = cancel.clone();
        let tasks = points.into_iter().map(move |point| {
            if asked.is_cancelled() { Err(StudyError::Stopped) } else { Ok((names.name(&point), point)) }
        });
        let folder = self.folder.clone();
        let swept = Pool::new(prepared.clone(), workers, None).each(
            tasks,
            move |worker, (name, point): (Name, Vec<Cell>)| {
                let (kept, made) = crate::solver::solved(worker, &things, name, &point);
                made.iter().flatten().try_for_each(|thing| thing.write(&folder)).map(|()| kept)
            },
            |(name, _), outcome| Ok(Kept { name, outcome, files: Default::default() }),
            |kept: Result<Kept, StudyError>| {
                if cancel.is_cancelled() {
                    return Err(StudyError::Stopped);
                }
                self.keep_one(&kept?).map(drop)
            },
        );
        swept.and(self.store.sync())
    }

    /// What a point gave; `None` where it is not solved.
    ///
    /// # Errors
    /// The store cannot be read.
    pub fn outcome(&mut self, point: &[Cell]) -> Result<Option<Outcome>, StudyError> {
        Ok(self.store.get(&self.names.name(point))?.map(|kept| kept.outcome))
    }
}
