//! Work that Ctrl+C ends.
//!
//! Python tells of a signal only on its own thread, and only when somebody asks there. So work that may be long is
//! done by another thread, without the interpreter's lock, while the caller's thread asks every few milliseconds.

use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use katydid_component::{Account, Budget, Cancel, Deadline, Limits};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;

/// How long a signal waits before it is seen.
const SIGNAL: Duration = Duration::from_millis(20);
/// How many threads that have nothing to do are kept for the next call.
const MOST_IDLE: usize = 8;

type Job = Box<dyn FnOnce() + Send>;

/// Threads that wait for work. Starting one anew would cost as much as a small solve.
static IDLE: Mutex<Vec<Sender<Job>>> = Mutex::new(Vec::new());
/// The process in which threads were started first.
static PROCESS: AtomicU32 = AtomicU32::new(0);

/// What a thread says while it works.
pub(crate) enum Said<M, T> {
    /// Something on the way.
    News(M),
    /// The result.
    Done(T),
}

/// Does work on another thread and waits for it without the interpreter's lock. `listen` gets, on this thread, what the
/// work says meanwhile. A signal whose handler raises (Ctrl+C), or an error of `listen`, cancels the work.
pub(crate) fn listening<M: Send + 'static, T: Send + 'static>(
    py: Python<'_>,
    cancel: &Cancel,
    work: impl FnOnce(&Sender<Said<M, T>>) -> T + Send + 'static,
    mut listen: impl FnMut(Python<'_>, M) -> PyResult<()>,
) -> PyResult<T> {
    check_process()?;
    let (say, hear) = channel();
    let hear = Mutex::new(hear);
    start(Box::new(move || {
        let done = work(&say);
        // Only fails when nobody waits any more.
        let _ = say.send(Said::Done(done));
    }))?;
    let mut stopped: Option<PyErr> = None;
    loop {
        match next(py, &hear)? {
            Some(Said::Done(done)) => return stopped.map_or(Ok(done), Err),
            Some(Said::News(news)) if stopped.is_none() => stopped = listen(py, news).err(),
            Some(Said::News(_)) => {}
            None if stopped.is_none() => stopped = py.check_signals().err(),
            None => {}
        }
        if stopped.is_some() {
            cancel.cancel();
        }
    }
}

/// Long work of the kernel, which Ctrl+C ends.
pub(crate) fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce() -> katydid_geometry::Result<T> + Send + 'static,
) -> PyResult<T> {
    let cancel = Cancel::default();
    let flag = cancel.clone();
    let patient = move |_: &Sender<Said<(), katydid_geometry::Result<T>>>| {
        let limits = Limits { items: u64::MAX, bytes: u64::MAX, solve_bytes: u64::MAX, time: None };
        let budget = Budget::new(limits, flag, Deadline::after(None), Arc::new(Account::new(u64::MAX)));
        budget.token().during(work)
    };
    listening(py, &cancel, patient, |_, ()| Ok(()))?.map_err(crate::errors::kernel)
}

/// What the thread says next; none when it said nothing for a while.
fn next<M: Send, T: Send>(
    py: Python<'_>,
    hear: &Mutex<Receiver<Said<M, T>>>,
) -> PyResult<Option<Said<M, T>>> {
    let said = py.detach(|| hear.lock().unwrap_or_else(PoisonError::into_inner).recv_timeout(SIGNAL));
    match said {
        Ok(said) => Ok(Some(said)),
        Err(RecvTimeoutError::Timeout) => Ok(None),
        Err(RecvTimeoutError::Disconnected) => {
            Err(PyRuntimeError::new_err("a fault inside Katydid ended the work; please report it"))
        }
    }
}

/// Hands a job to a thread that waits, or to a new one.
fn start(mut job: Job) -> PyResult<()> {
    loop {
        let idle = IDLE.lock().unwrap_or_else(PoisonError::into_inner).pop();
        let Some(thread) = idle else { break };
        match thread.send(job) {
            Ok(()) => return Ok(()),
            Err(refused) => job = refused.0,
        }
    }
    std::thread::Builder::new()
        .name("katydid".to_owned())
        // As deep as the threads of the solver's pool may go.
        .stack_size(16 << 20)
        .spawn(move || {
            job();
            loop {
                let (send, next) = channel::<Job>();
                {
                    let mut idle = IDLE.lock().unwrap_or_else(PoisonError::into_inner);
                    if idle.len() >= MOST_IDLE {
                        return;
                    }
                    idle.push(send);
                }
                let Ok(job) = next.recv() else { return };
                job();
            }
        })
        .map_err(|error| PyRuntimeError::new_err(format!("no thread can be started: {error}")))?;
    Ok(())
}

/// Threads do not live on in a process that was forked: work given to them would never be done.
fn check_process() -> PyResult<()> {
    let this = std::process::id();
    match PROCESS.compare_exchange(0, this, Ordering::Relaxed, Ordering::Relaxed) {
        Ok(_) => Ok(()),
        Err(first) if first == this => Ok(()),
        Err(_) => Err(PyRuntimeError::new_err(
            "this process was forked after Katydid had started its threads, which it does not have: \
             use multiprocessing's method \"spawn\" or \"forkserver\"",
        )),
    }
}
