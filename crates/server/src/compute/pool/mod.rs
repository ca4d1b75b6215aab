//! The threads that solve.
//!
//! Nothing is solved on the threads that serve sockets. Each thread here has helpers of its own for what a solve does in
//! parallel, so that one without end holds up no other. A thread whose work does not heed its deadline is given up: it
//! gets a substitute, and goes when it comes back after all.
//!
//! Requests are read, and what is known to be quick is solved, on threads in front. Those in the back do the rest with a
//! lower priority: where there are more solves than processors, who asks for a small thing does not wait for the others.

mod lost;
mod queue;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError, Weak};
use std::time::{Duration, Instant};

use katydid_component::Cancel;
use tokio::sync::oneshot;

use crate::lock::held;
use lost::Lost;
pub(crate) use queue::{Client, Lane, Places, SLICE};
use queue::{Queue, Row, Ticket};

/// What does not heed its deadline for so long is given up.
const HARD: Duration = Duration::from_millis(750);
/// Deep definitions recurse.
const STACK: usize = 16 << 20;
/// More helpers gain little, and each solving thread has its own.
const MOST_HELPERS: usize = 4;

/// What a piece of work comes to.
pub(crate) enum Step<T> {
    /// It is done.
    Done(T),
    /// The rest shall wait in another lane.
    Later(Lane, Box<dyn FnOnce() -> Step<T> + Send>),
}

/// Why there is nothing to show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Undone {
    /// Too much waits already.
    Full,
    /// It waited until its time was over.
    Waited,
    /// It did not end when its time was over.
    Late,
    /// It failed as it must not.
    Failed,
}

/// When the time that work may take begins.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Clock {
    /// When it is asked for: who waits for an answer waits no longer.
    Asked,
    /// When it begins: nobody waits.
    Begun,
}

type Work = Box<dyn FnOnce() -> Option<Again> + Send>;
/// The rest of it, and the lane that it waits in.
struct Again(Lane, Work);

/// All solving threads.
pub(crate) struct Pool {
    shared: Arc<Shared>,
}

struct Shared {
    queue: Mutex<Inner>,
    wake_front: Condvar,
    wake_back: Condvar,
    helpers: usize,
    /// How many have failed as they must not.
    failed: AtomicU64,
}

struct Inner {
    queue: Queue<Work>,
    lost: Lost,
    /// How many threads in front wait for work.
    idle_in_front: usize,
}

/// What the pool is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Load {
    pub(crate) waiting: usize,
    pub(crate) running: usize,
    pub(crate) lost: usize,
    /// Of those that were given up, how many do not stop though they were told to a while ago.
    pub(crate) stuck: usize,
    pub(crate) failed: u64,
}

impl Pool {
    pub(crate) fn new(places: Places) -> Self {
        let processors = std::thread::available_parallelism().map_or(1, usize::from);
        let inner = Inner { queue: Queue::new(places), lost: Lost::default(), idle_in_front: 0 };
        let shared = Arc::new(Shared {
            queue: Mutex::new(inner),
            wake_front: Condvar::new(),
            wake_back: Condvar::new(),
            helpers: processors.min(MOST_HELPERS),
            failed: AtomicU64::new(0),
        });
        for place in 0..places.all().max(2) {
            Shared::hire(&shared, if place < places.quick.max(1) { Row::Front } else { Row::Back });
        }
        Self { shared }
    }

    /// How much may run at a time, what was given up included.
    pub(crate) fn most(places: Places) -> usize {
        places.all().max(2) + Lost::MOST
    }

    pub(crate) fn load(&self) -> Load {
        let inner = held(&self.shared.queue);
        Load {
            waiting: inner.queue.waiting(),
            running: inner.queue.running(),
            lost: inner.lost.count(),
            stuck: inner.lost.stuck(Instant::now()),
            failed: self.shared.failed.load(Ordering::Relaxed),
        }
    }

    /// Has work done, and waits for it.
    ///
    /// `began` is called when it begins, on the solving thread. When whoever waits is dropped, because the client has
    /// left, work that waits is taken out of the line and work that runs is cancelled.
    pub(crate) async fn run<T: Send + 'static>(
        &self,
        client: Client,
        cancel: &Cancel,
        (clock, time): (Clock, Duration),
        work: impl FnOnce() -> Step<T> + Send + 'static,
    ) -> Result<T, Undone> {
        let (tell, mut told) = oneshot::channel();
        let (tell_begun, begun) = oneshot::channel();
        let work = Box::new(move || {
            let _ = tell_begun.send(());
            stepped(work(), tell)
        });
        let ticket = {
            let mut inner = held(&self.shared.queue);
            let ticket = inner.queue.put(client, |_| work as Work).map_err(|_| Undone::Full)?;
            self.shared.wake_for(&inner);
            ticket
        };
        let mut waiting =
            Waiting { shared: Arc::downgrade(&self.shared), client, ticket, cancel, is_over: false };
        let asked = tokio::time::Instant::now();
        if clock == Clock::Begun {
            let _ = begun.await;
        }
        let from = if clock == Clock::Begun { tokio::time::Instant::now() } else { asked };
        let Some(end) = from.checked_add(time).and_then(|end| end.checked_add(HARD)) else {
            let done = told.await;
            waiting.is_over = true;
            return done.map_err(|_| Undone::Failed);
        };
        match tokio::time::timeout_at(end, &mut told).await {
            Ok(done) => {
                waiting.is_over = true;
                done.map_err(|_| Undone::Failed)
            }
            Err(_) => Err(waiting.give_up()),
        }
    }
}

/// Tells what work came to, or gives the rest of it back.
fn stepped<T: Send + 'static>(step: Step<T>, tell: oneshot::Sender<T>) -> Option<Again> {
    match step {
        Step::Done(done) => {
            // Who is gone need not be told.
            let _ = tell.send(done);
            None
        }
        Step::Later(lane, rest) => Some(Again(lane, Box::new(move || stepped(rest(), tell)))),
    }
}

/// Somebody who waits for work. Dropped before it is over, the work is not wanted any more.
struct Waiting<'a> {
    shared: Weak<Shared>,
    client: Client,
    ticket: Ticket,
    cancel: &'a Cancel,
    is_over: bool,
}

impl Waiting<'_> {
    /// The time is over.
    fn give_up(mut self) -> Undone {
        self.is_over = true;
        self.cancel.cancel();
        let Some(shared) = self.shared.upgrade() else { return Undone::Late };
        let mut inner = held(&shared.queue);
        if inner.queue.remove(self.client, self.ticket).is_some() {
            return Undone::Waited;
        }
        Shared::lose(&shared, &mut inner, self.ticket);
        Undone::Late
    }
}

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        if self.is_over {
            return;
        }
        self.cancel.cancel();
        let Some(shared) = self.shared.upgrade() else { return };
        let removed = held(&shared.queue).queue.remove(self.client, self.ticket);
        if removed.is_some() {
            return;
        }
        // It runs, and has been told to stop; if it does not heed that either, it is given up.
        if let Ok(runtime) = tokio::runtime::Handle::try_current() {
            let (shared, ticket) = (Weak::clone(&self.shared), self.ticket);
            runtime.spawn(async move {
                tokio::time::sleep(HARD).await;
                if let Some(shared) = shared.upgrade() {
                    Shared::lose(&shared, &mut held(&shared.queue), ticket);
                }
            });
        }
    }
}

impl Shared {
    /// Gives up a thread that does not stop, if it still runs: another takes its place.
    fn lose(shared: &Arc<Self>, inner: &mut Inner, ticket: Ticket) {
        // Beyond so many their places stay taken.
        if inner.lost.has_room()
            && let Some(row) = inner.queue.end(ticket)
        {
            inner.lost.add(ticket, Instant::now());
            Self::hire(shared, row);
        }
    }

    /// One more thread. Where the system has no more, those that are there go on.
    fn hire(shared: &Arc<Self>, row: Row) {
        let own = Arc::downgrade(shared);
        let builder = std::thread::Builder::new().name("solve".to_owned()).stack_size(STACK);
        let helpers = shared.helpers;
        let _ = builder.spawn(move || with_helpers(helpers, row, || work_on(&own, row)));
    }
}

/// Makes this thread one of a small pool of its own, which takes what a solve does in parallel.
fn with_helpers(helpers: usize, row: Row, work: impl FnOnce()) {
    let place = move || {
        if row == Row::Back {
            katydid_priority::lower();
        }
    };
    place();
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(helpers)
        .use_current_thread()
        .thread_name(|_| "solve-helper".to_owned())
        .start_handler(move |_| place())
        .stack_size(STACK)
        .build();
    // Where no more threads are to be had, all share those that are there.
    let _pool = pool.ok();
    work();
}

/// Works until the pool is gone, or until this thread has been given up.
fn work_on(shared: &Weak<Shared>, row: Row) {
    loop {
        // Not held while it waits longer than this: the pool could not go.
        let Some(shared) = shared.upgrade() else { return };
        let Some((ticket, work)) = shared.next(row) else { continue };
        let done = catch_unwind(AssertUnwindSafe(work));
        if done.is_err() {
            shared.failed.fetch_add(1, Ordering::Relaxed);
        }
        let mut inner = held(&shared.queue);
        if inner.lost.is_back(ticket) {
            // It has a substitute, and nobody waits for what may be left to do.
            return;
        }
        match done {
            Ok(Some(Again(lane, rest))) => inner.queue.set_back(ticket, lane, rest),
            _ => drop(inner.queue.end(ticket)),
        }
        // There is a place now that another thread may be the one to fill.
        shared.wake_front.notify_one();
        shared.wake_back.notify_one();
    }
}

impl Shared {
    /// The next work for a thread of a row, waited for a while.
    fn next(&self, row: Row) -> Option<(Ticket, Work)> {
        const WHILE: Duration = Duration::from_secs(1);
        let mut inner = held(&self.queue);
        let now = Instant::now();
        if let Some(found) = inner.take(now, row) {
            return Some(found);
        }
        let token = match inner.queue.waiting() {
            0 => WHILE,
            _ => inner.queue.next_slow(now).unwrap_or(WHILE).min(WHILE),
        };
        if row == Row::Back {
            let waited = self.wake_back.wait_timeout(inner, token);
            return waited.unwrap_or_else(PoisonError::into_inner).0.take(Instant::now(), row);
        }
        inner.idle_in_front += 1;
        let (mut inner, _) =
            self.wake_front.wait_timeout(inner, token).unwrap_or_else(PoisonError::into_inner);
        inner.idle_in_front -= 1;
        inner.take(Instant::now(), row)
    }

    /// Wakes who shall take what was just put in line.
    fn wake_for(&self, inner: &Inner) {
        self.wake_front.notify_one();
        if inner.queue.waiting() > inner.idle_in_front {
            self.wake_back.notify_one();
        }
    }
}

impl Inner {
    fn take(&mut self, now: Instant, row: Row) -> Option<(Ticket, Work)> {
        let leaves_quick = row == Row::Back && self.idle_in_front > 0;
        self.queue.take(now, row, leaves_quick)
    }
}
