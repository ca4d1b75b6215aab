//! Points that somebody else hands out, solved one after another: what a process on another machine does.

use katydid_component::Cancel;
use katydid_definition::document::Document;
use katydid_solver::Options;
use rayon::ThreadPool;

use crate::record::{Kept, Name, framed};
use crate::sweep::Names;
use crate::{Cell, Plan, Prepared, Status, StudyError, Thing, Things, Worker, pool};

/// A definition that is prepared once and solves points on a thread of its own.
#[derive(Debug)]
pub struct PointSolver {
    prepared: Prepared,
    names: Names,
    things: Things,
    thread: ThreadPool,
    cancel: Cancel,
}

/// What a batch of points gave.
#[derive(Debug, Clone, Default)]
pub struct Batch {
    /// A record for each point, for [`Dispatcher::keep`](crate::Dispatcher::keep).
    pub records: Vec<u8>,
    /// The pictures and geometry of the points.
    pub things: Vec<Thing>,
}

impl PointSolver {
    /// Prepares a definition for points of a plan. `cancel` stops it from outside.
    ///
    /// # Errors
    /// The plan wants geometry of a format that is not written, or no thread can be started.
    pub fn new(
        document: Document,
        options: Options,
        plan: &Plan,
        cancel: Cancel,
    ) -> Result<Self, StudyError> {
        let things = Things::new(plan.pictures, plan.geometry.as_deref())?;
        let options = options_of(plan, options, &cancel);
        let thread = pool::thread()?;
        let prepared = thread
            .install(|| Prepared::new(document, options, plan.variables().to_vec(), plan.outputs().to_vec()));
        Ok(Self { prepared, names: Names::of(plan), things, thread, cancel })
    }

    /// Solves points, one after another.
    ///
    /// # Errors
    /// Somebody asked to stop.
    pub fn solve(&self, points: &[Vec<Cell>]) -> Result<Batch, StudyError> {
        self.thread.install(|| {
            let mut worker = self.prepared.worker();
            let mut batch = Batch::default();
            for point in points {
                let (kept, made) = solved(&mut worker, &self.things, self.names.name(point), point);
                if self.cancel.is_cancelled() {
                    return Err(StudyError::Stopped);
                }
                batch.records.extend(framed(&kept));
                batch.things.extend(made.into_iter().flatten());
            }
            Ok(batch)
        })
    }
}

/// The options with which the points of a plan are solved.
pub(crate) fn options_of(plan: &Plan, options: Options, cancel: &Cancel) -> Options {
    let skip_unread = !plan.pictures && plan.geometry.is_none();
    Options { cancel: cancel.clone(), skip_unread, ..options }
}

/// Solves a point and makes its files, which are still to be written.
pub(crate) fn solved(
    worker: &mut Worker<'_>,
    things: &Things,
    name: Name,
    point: &[Cell],
) -> (Kept, [Option<Thing>; 2]) {
    let mut outcome = worker.solve(point);
    let mut made = [None, None];
    if outcome.status.is_good() {
        match things.make(worker.engine()) {
            Ok(files) => made = files,
            Err(why) => (outcome.status, outcome.reason) = (Status::NoFile, why.to_string()),
        }
    }
    let files = made.each_ref().map(|thing| thing.as_ref().map_or(String::new(), |thing| thing.name.clone()));
    (Kept { name, outcome, files }, made)
}
