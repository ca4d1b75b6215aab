//! Points solved side by side: a thread a worker, each with an engine of its own that solves on that thread alone.

use std::sync::Mutex;
use std::sync::mpsc::sync_channel;

use crate::{Prepared, StudyError, Worker};

/// The stack of a worker: nested clusters and formulas go deep.
const STACK: usize = 16 << 20;
/// How many results may wait for whoever takes them.
const WAITING: usize = 256;

/// A thread on which all that is inside of a point runs.
///
/// # Errors
/// It cannot be started.
pub(crate) fn thread() -> Result<rayon::ThreadPool, StudyError> {
    let built = rayon::ThreadPoolBuilder::new().num_threads(1).stack_size(STACK).build();
    built.map_err(|error| StudyError::Unfit(format!("no thread could be started: {error}")))
}

/// Works through `tasks` on so many threads; `take` gets each result on the caller's thread, in the order in which they come.
/// When `take` fails, no further task is begun.
///
/// # Errors
/// What `take` or the tasks fail with, or that no thread could be started.
pub(crate) fn each<T: Send, R: Send>(
    prepared: &Prepared,
    workers: usize,
    tasks: impl Iterator<Item = Result<T, StudyError>> + Send,
    work: impl Fn(&mut Worker<'_>, T) -> R + Sync,
    mut take: impl FnMut(R) -> Result<(), StudyError>,
) -> Result<(), StudyError> {
    let workers = workers.max(1);
    // Points are what is done side by side: inside of one, everything runs on its own thread.
    let pools: Vec<_> = (0..workers).map(|_| thread()).collect::<Result<_, _>>()?;
    let tasks = Mutex::new(Some(tasks));
    let failed = Mutex::new(None);
    let next = || {
        let mut tasks = tasks.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        match tasks.as_mut()?.next()? {
            Ok(task) => Some(task),
            Err(error) => {
                *tasks = None;
                failed.lock().unwrap_or_else(std::sync::PoisonError::into_inner).get_or_insert(error);
                None
            }
        }
    };
    let (send, receive) = sync_channel(WAITING);
    let taken = std::thread::scope(|scope| {
        for pool in &pools {
            let (send, next, work) = (send.clone(), &next, &work);
            scope.spawn(move || {
                pool.install(|| {
                    let mut worker = prepared.worker();
                    while let Some(task) = next() {
                        if send.send(work(&mut worker, task)).is_err() {
                            break;
                        }
                    }
                });
            });
        }
        drop(send);
        let taken = receive.iter().try_for_each(&mut take);
        // Whoever waits to hand a result over is let go.
        drop(receive);
        taken
    });
    taken?;
    failed.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner).map_or(Ok(()), Err)
}
