//! Points solved side by side: a thread a worker, each with an engine of its own that solves on that thread alone.
//!
//! A thread cannot be ended from outside. One whose point takes much longer than points may is left behind: its point is lost,
//! another thread takes its place, and what it gives after all is thrown away.

use std::sync::mpsc::{RecvTimeoutError, SyncSender, sync_channel};
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use crate::lock::locked;
use crate::thresholds::{HANG_GRACE, MOST_HUNG};
use crate::{Cell, Outcome, Prepared, Status, StudyError, Worker};

/// The stack of a worker: nested clusters and formulas go deep.
const STACK: usize = 16 << 20;
/// How many results may wait for whoever takes them.
const WAITING: usize = 256;
/// How often one looks for threads that hang.
const LOOK: Duration = Duration::from_millis(200);

/// A thread on which all that is inside of a point runs.
///
/// # Errors
/// It cannot be started.
pub(crate) fn thread() -> Result<rayon::ThreadPool, StudyError> {
    let built = rayon::ThreadPoolBuilder::new().num_threads(1).stack_size(STACK).build();
    built.map_err(no_thread)
}

fn no_thread(error: impl std::fmt::Display) -> StudyError {
    StudyError::Unfit(format!("no thread could be started: {error}"))
}

fn too_many_hang() -> StudyError {
    StudyError::Unfit(format!(
        "more than {MOST_HUNG} points hang and cannot be ended: what is solved is kept, and the same command goes on"
    ))
}

/// Many points on so many threads.
#[derive(Debug)]
pub(crate) struct Pool {
    prepared: Arc<Prepared>,
    workers: usize,
    /// After how long a point is lost; `None` where points have no limit of time.
    patience: Option<Duration>,
}

impl Pool {
    /// For points of a prepared definition. A point is lost when it gives no answer within one and a half of its time limit and
    /// `grace`; half a minute when not given.
    pub(crate) fn new(prepared: Prepared, workers: usize, grace: Option<Duration>) -> Self {
        let limit = prepared.engine().options().limits.time;
        let patience = limit.map(|limit| limit.mul_f64(1.5).saturating_add(grace.unwrap_or(HANG_GRACE)));
        Self { prepared: Arc::new(prepared), workers: workers.max(1), patience }
    }

    /// Works through `tasks`; `take` gets each result on the caller's thread, in the order in which they come. `lost` makes a
    /// result of a task that hangs. When `take` fails, no further task is begun.
    ///
    /// # Errors
    /// What `take` or the tasks fail with, that no thread could be started, or that more hang than can be left behind.
    pub(crate) fn each<T: Clone + Send + 'static, R: Send + 'static>(
        &self,
        tasks: impl Iterator<Item = Result<T, StudyError>> + Send + 'static,
        work: impl Fn(&mut Worker<'_>, T) -> R + Send + Sync + 'static,
        lost: impl Fn(T, Outcome) -> R,
        mut take: impl FnMut(R) -> Result<(), StudyError>,
    ) -> Result<(), StudyError> {
        let tasks = Arc::new(Tasks::new(tasks));
        let mut crew = Crew {
            pool: self,
            tasks: tasks.clone(),
            work: Arc::new(work),
            threads: Vec::new(),
            started: 0,
            hung: 0,
        };
        let (send, receive) = sync_channel(WAITING);
        let mut looked = Instant::now();
        let mut run = || {
            for _ in 0..self.workers {
                match crew.start(&send) {
                    // Fewer threads do it too.
                    Err(error) if crew.threads.is_empty() => return Err(error),
                    Err(_) => break,
                    Ok(()) => {}
                }
            }
            while !crew.threads.is_empty() {
                match receive.recv_timeout(LOOK) {
                    Ok(Said::Result(result)) => take(result)?,
                    Ok(Said::Ended(number)) => crew.threads.retain(|thread| thread.number != number),
                    Err(RecvTimeoutError::Timeout) => {}
                    Err(RecvTimeoutError::Disconnected) => break,
                }
                if looked.elapsed() >= LOOK {
                    looked = Instant::now();
                    crew.leave_hung(&send, |task, outcome| take(lost(task, outcome)))?;
                }
            }
            // What came while the last thread was given up.
            for said in receive.try_iter() {
                if let Said::Result(result) = said {
                    take(result)?;
                }
            }
            if tasks.is_left() { Err(too_many_hang()) } else { Ok(()) }
        };
        let taken = run();
        tasks.end();
        // Whoever waits to hand a result over is let go.
        drop(receive);
        crew.wait();
        taken?;
        tasks.failed()
    }
}

/// What a thread tells.
enum Said<R> {
    Result(R),
    /// The thread of this number has nothing more to do.
    Ended(usize),
}

type Rest<T> = Box<dyn Iterator<Item = Result<T, StudyError>> + Send>;

/// The tasks that nobody has begun.
struct Tasks<T> {
    rest: Mutex<Option<Rest<T>>>,
    failed: Mutex<Option<StudyError>>,
}

impl<T> Tasks<T> {
    fn new(tasks: impl Iterator<Item = Result<T, StudyError>> + Send + 'static) -> Self {
        Self { rest: Mutex::new(Some(Box::new(tasks))), failed: Mutex::default() }
    }

    fn next(&self) -> Option<T> {
        let mut rest = locked(&self.rest);
        match rest.as_mut()?.next() {
            Some(Ok(task)) => return Some(task),
            Some(Err(error)) => {
                locked(&self.failed).get_or_insert(error);
            }
            None => {}
        }
        *rest = None;
        None
    }

    /// Whether there are some that nobody has asked for.
    fn is_left(&self) -> bool {
        locked(&self.rest).is_some()
    }

    /// No further task is begun. What the tasks hold is let go, though threads that hang may know them.
    fn end(&self) {
        *locked(&self.rest) = None;
    }

    fn failed(&self) -> Result<(), StudyError> {
        locked(&self.failed).take().map_or(Ok(()), Err)
    }
}

/// A task that a thread is at, and since when; nothing when it was taken away from the thread.
type Slot<T> = Mutex<Option<(Instant, T)>>;

/// A thread and what it is at.
struct Thread<T> {
    number: usize,
    handle: JoinHandle<()>,
    slot: Arc<Slot<T>>,
}

/// The threads that work through the tasks of a pool.
struct Crew<'a, T, W> {
    pool: &'a Pool,
    tasks: Arc<Tasks<T>>,
    work: Arc<W>,
    threads: Vec<Thread<T>>,
    /// How many threads were started.
    started: usize,
    /// How many of them were left behind.
    hung: usize,
}

impl<T: Clone + Send + 'static, W> Crew<'_, T, W> {
    fn start<R: Send + 'static>(&mut self, send: &SyncSender<Said<R>>) -> Result<(), StudyError>
    where
        W: Fn(&mut Worker<'_>, T) -> R + Send + Sync + 'static,
    {
        // Points are what is done side by side: inside of one, everything runs on its own thread.
        let inner = thread()?;
        let slot: Arc<Slot<T>> = Arc::default();
        let (prepared, tasks, work) = (self.pool.prepared.clone(), self.tasks.clone(), self.work.clone());
        let (own, send) = (slot.clone(), send.clone());
        let number = self.started;
        let run = move || {
            inner.install(|| {
                let mut worker = prepared.worker();
                while let Some(task) = tasks.next() {
                    *locked(&own) = Some((Instant::now(), task.clone()));
                    let result = work(&mut worker, task);
                    let is_own = locked(&own).take().is_some();
                    // A task that was given up has its result.
                    if !is_own || send.send(Said::Result(result)).is_err() {
                        return;
                    }
                }
            });
            // Nobody waits for it any more when this fails.
            let _ = send.send(Said::Ended(number));
        };
        let handle = std::thread::Builder::new().name("points".to_owned()).spawn(run).map_err(no_thread)?;
        self.started += 1;
        self.threads.push(Thread { number, handle, slot });
        Ok(())
    }

    /// Gives up the tasks of threads that hang or have ended in the middle of one; others take the places of the threads.
    fn leave_hung<R: Send + 'static>(
        &mut self,
        send: &SyncSender<Said<R>>,
        mut give_up: impl FnMut(T, Outcome) -> Result<(), StudyError>,
    ) -> Result<(), StudyError>
    where
        W: Fn(&mut Worker<'_>, T) -> R + Send + Sync + 'static,
    {
        // One that ended between two tasks has said so, or never will.
        self.threads.retain(|thread| !thread.handle.is_finished() || locked(&thread.slot).is_some());
        for at in (0..self.threads.len()).rev() {
            let Some((time, reason, task)) = self.threads.get(at).and_then(|thread| self.hangs(thread))
            else {
                continue;
            };
            self.threads.swap_remove(at);
            let cells = vec![Cell::Null; self.pool.prepared.outputs().len()];
            give_up(task, Outcome { status: Status::Lost, reason, cells, time })?;
            self.hung += 1;
            if self.hung <= MOST_HUNG {
                // Where no thread can be started, those that are left go on.
                let _ = self.start(send);
            }
        }
        Ok(())
    }

    /// How long a thread has been at a task that it will not end, why, and the task, which is taken from it.
    fn hangs(&self, thread: &Thread<T>) -> Option<(Duration, String, T)> {
        let mut slot = locked(&thread.slot);
        let time = slot.as_ref()?.0.elapsed();
        let is_over = self.pool.patience.is_some_and(|patience| time >= patience);
        let reason = if is_over {
            format!("it gave no answer for {:.0} s, and its thread could not be ended", time.as_secs_f64())
        } else if thread.handle.is_finished() {
            "its thread ended".to_owned()
        } else {
            return None;
        };
        slot.take().map(|(_, task)| (time, reason, task))
    }

    /// Waits for all threads that do not hang.
    fn wait(self) {
        for Thread { handle, slot, .. } in self.threads {
            let is_over = || {
                let since = locked(&slot).as_ref().map(|(since, _)| since.elapsed());
                self.pool.patience.zip(since).is_some_and(|(patience, time)| time >= patience)
            };
            while !handle.is_finished() && !is_over() {
                std::thread::sleep(Duration::from_millis(1));
            }
        }
    }
}
