use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, OnceLock};
use std::time::Duration;

use katydid_geometry::CancellationToken;
use katydid_memory::Account;
use web_time::Instant;

use crate::Message;

/// How much one solve may use. The defaults stop a definition that has run away, not one that is large.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The most items that one object may put out.
    pub items: u64,
    /// The most bytes that one object may take: its results, and what it needs on the way.
    ///
    /// Bytes are counted where the program's allocator is [`katydid_memory::Counting`]. Elsewhere only those are that
    /// components ask for: of texts and files above all.
    pub bytes: u64,
    /// The most bytes that the whole solve may take.
    pub solve_bytes: u64,
    /// How long the whole solve may take; `None` for as long as it needs.
    pub time: Option<Duration>,
}

impl Limits {
    /// The same with a limit of memory: for the whole solve, and so for each of its objects.
    #[must_use]
    pub fn with_bytes(self, bytes: u64) -> Self {
        Self { bytes, solve_bytes: bytes, ..self }
    }
}

impl Default for Limits {
    fn default() -> Self {
        Self { items: 20_000_000, bytes: 1 << 30, solve_bytes: 4 << 30, time: None }
    }
}

/// A flag that stops a solve from outside. Clones are the same flag.
#[derive(Debug, Clone, Default)]
pub struct Cancel(Arc<AtomicBool>);

impl Cancel {
    /// Asks the solve to stop.
    pub fn cancel(&self) {
        self.0.store(true, Ordering::Relaxed);
    }

    /// Whether somebody asked.
    pub fn is_cancelled(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// What a thread may take before a loop looks at the whole: each look costs as much as a small item.
const UNSETTLED: u64 = 1 << 18;

/// What is left for one object of what a solve may use: items, bytes, time, and whether somebody still waits. All that
/// may be long or large asks here.
#[derive(Debug)]
pub struct Budget {
    items: AtomicU64,
    /// The bytes that were asked for, where nobody counts.
    asked: AtomicU64,
    waiting: Arc<Waiting>,
}

/// The part that every thread asks which works for the object.
#[derive(Debug)]
struct Waiting {
    limits: Limits,
    cancel: Cancel,
    deadline: Deadline,
    account: Account,
    /// Why there was no memory: what was given up for that may have been given back since.
    refused: OnceLock<Message>,
}

impl katydid_geometry::Waiting for Waiting {
    fn go_on(&self) -> bool {
        !self.cancel.is_cancelled() && !self.deadline.is_over() && self.has_room(0)
    }

    fn has_room(&self, bytes: u64) -> bool {
        let refused = self.room(bytes).map_err(|message| self.refused.get_or_init(|| message));
        refused.is_ok()
    }

    fn begin(&self) {
        self.account.begin();
    }

    fn end(&self) {
        self.account.end();
    }
}

impl Waiting {
    /// The message to show when `more` bytes do not fit.
    fn room(&self, more: u64) -> Result<(), Message> {
        self.account.settle();
        match self.account.without_room(more) {
            None => Ok(()),
            Some(over) if std::ptr::eq(over, &self.account) => Err(too_large("", over.limit())),
            Some(_) if self.account.was_refused() => Err(Message::error(
                "No memory is left for this beside what else is solved now: try again later",
            )),
            Some(whole) => Err(too_large(" in the whole solution", whole.limit())),
        }
    }
}

fn too_large(place: &str, limit: u64) -> Message {
    Message::error(format!("More than {limit} bytes{place}: raise the memory limit if that much is wanted"))
}

impl Budget {
    /// A budget for one object. `deadline` is when the whole solve must be done, `solve` counts what it takes.
    pub fn new(limits: Limits, cancel: Cancel, deadline: Deadline, solve: Arc<Account>) -> Self {
        let account = Account::part_of(solve, limits.bytes);
        let waiting = Arc::new(Waiting { limits, cancel, deadline, account, refused: OnceLock::new() });
        Self { items: AtomicU64::new(0), asked: AtomicU64::new(0), waiting }
    }

    /// Whether work may go on.
    ///
    /// # Errors
    /// The message to show when somebody cancelled, the time is over, or more memory is taken than may be.
    pub fn check(&self) -> Result<(), Message> {
        let waiting = &*self.waiting;
        if waiting.cancel.is_cancelled() {
            return Err(Message::error("The solution was cancelled"));
        }
        if waiting.deadline.is_over() {
            let seconds = waiting.limits.time.unwrap_or_default().as_secs_f64();
            return Err(Message::error(format!("The time limit of {seconds} seconds is over")));
        }
        waiting.refused.get().map_or_else(|| waiting.room(0), |message| Err(message.clone()))
    }

    /// The same where it is asked at every step of a loop: it looks only when this thread has taken much since it looked
    /// last.
    ///
    /// # Errors
    /// As [`Budget::check`].
    pub fn check_memory(&self) -> Result<(), Message> {
        if self.waiting.account.unsettled() < UNSETTLED { Ok(()) } else { self.waiting.room(0) }
    }

    /// The same for all that is done on one thread: what it takes meanwhile is counted for the object.
    pub fn token(&self) -> CancellationToken {
        CancellationToken::of(self.waiting.clone())
    }

    /// Takes `n` items, before they are made.
    ///
    /// # Errors
    /// The message to show when the object would put out more than it may.
    pub fn items(&self, n: usize) -> Result<(), Message> {
        let limit = self.waiting.limits.items;
        if take(&self.items, n, limit) {
            return Ok(());
        }
        Err(Self::too_many(limit))
    }

    /// Whether `n` more items could be taken. Takes none: they are counted when they are put out.
    ///
    /// # Errors
    /// The message to show when they could not.
    pub fn fits(&self, n: usize) -> Result<(), Message> {
        let limit = self.waiting.limits.items;
        if self.items.load(Ordering::Relaxed).checked_add(n as u64).is_some_and(|total| total <= limit) {
            return Ok(());
        }
        Err(Self::too_many(limit))
    }

    fn too_many(limit: u64) -> Message {
        Message::error(format!("More than {limit} items: raise the item limit if that many are wanted"))
    }

    /// Whether there is room for `n` bytes where memory is counted; `false` where it is not. Takes none.
    pub fn has_room(&self, n: usize) -> bool {
        katydid_memory::is_counting() && self.waiting.room(n as u64).is_ok()
    }

    /// Asks for `n` bytes where memory is counted, and takes none where it is not.
    ///
    /// # Errors
    /// As [`Budget::bytes`].
    pub fn asked(&self, n: usize) -> Result<(), Message> {
        if n > 0 && katydid_memory::is_counting() { self.waiting.room(n as u64) } else { Ok(()) }
    }

    /// Asks for `n` bytes, before they are made.
    ///
    /// # Errors
    /// The message to show when the object, or the whole solve, would take more than it may.
    pub fn bytes(&self, n: usize) -> Result<(), Message> {
        if katydid_memory::is_counting() {
            return self.waiting.room(n as u64);
        }
        let limit = self.waiting.limits.bytes;
        if take(&self.asked, n, limit) { Ok(()) } else { Err(too_large("", limit)) }
    }
}

/// Adds `n` to what was taken unless that passes the limit; a refusal takes nothing.
fn take(taken: &AtomicU64, n: usize, limit: u64) -> bool {
    let add = |now: u64| now.checked_add(n as u64).filter(|&total| total <= limit);
    taken.fetch_update(Ordering::Relaxed, Ordering::Relaxed, add).is_ok()
}

impl Default for Budget {
    fn default() -> Self {
        let limits = Limits::default();
        let solve = Arc::new(Account::new(limits.solve_bytes));
        Self::new(limits, Cancel::default(), Deadline::never(), solve)
    }
}

/// A moment after which a solve stops.
#[derive(Debug, Clone, Copy, Default)]
pub struct Deadline(Option<Instant>);

impl Deadline {
    /// No deadline.
    pub fn never() -> Self {
        Self::default()
    }

    /// The moment `time` from now.
    pub fn after(time: Option<Duration>) -> Self {
        Self(time.and_then(|t| Instant::now().checked_add(t)))
    }

    /// The time until then, if there is such a moment.
    pub fn left(self) -> Option<Duration> {
        self.0.map(|at| at.saturating_duration_since(Instant::now()))
    }

    fn is_over(self) -> bool {
        self.0.is_some_and(|at| Instant::now() >= at)
    }
}
