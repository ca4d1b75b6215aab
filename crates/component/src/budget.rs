use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

use katydid_geometry::Patience;

use crate::Message;

/// How much one solve may use. The defaults stop a definition that has run away, not one that is large.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// The most items that one object may put out.
    pub items: u64,
    /// The most bytes that the items of one object may take, texts above all.
    pub bytes: u64,
    /// How long the whole solve may take; `None` for as long as it needs.
    pub time: Option<Duration>,
}

impl Default for Limits {
    fn default() -> Self {
        Self { items: 20_000_000, bytes: 1 << 30, time: None }
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

/// What is left for one object of what a solve may use.
#[derive(Debug)]
pub struct Budget {
    limits: Limits,
    cancel: Cancel,
    deadline: Deadline,
    items: AtomicU64,
    bytes: AtomicU64,
}

impl Budget {
    /// A budget for one object. `deadline` is when the whole solve must be done.
    pub fn new(limits: Limits, cancel: Cancel, deadline: Deadline) -> Self {
        Self { limits, cancel, deadline, items: AtomicU64::new(0), bytes: AtomicU64::new(0) }
    }

    /// Whether work may go on.
    ///
    /// # Errors
    /// The message to show when somebody cancelled or the time is over.
    pub fn check(&self) -> Result<(), Message> {
        if self.cancel.is_cancelled() {
            return Err(Message::error("The solution was cancelled"));
        }
        if self.deadline.is_over() {
            let seconds = self.limits.time.unwrap_or_default().as_secs_f64();
            return Err(Message::error(format!("The time limit of {seconds} seconds is over")));
        }
        Ok(())
    }

    /// The same for what the kernel does on this thread.
    pub fn patience(&self) -> Patience {
        let (cancel, deadline) = (self.cancel.clone(), self.deadline);
        Patience::new(move || !cancel.is_cancelled() && !deadline.is_over())
    }

    /// Takes `n` items, before they are made.
    ///
    /// # Errors
    /// The message to show when the object would put out more than it may.
    pub fn items(&self, n: usize) -> Result<(), Message> {
        let limit = self.limits.items;
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
        let limit = self.limits.items;
        if self.items.load(Ordering::Relaxed).checked_add(n as u64).is_some_and(|total| total <= limit) {
            return Ok(());
        }
        Err(Self::too_many(limit))
    }

    fn too_many(limit: u64) -> Message {
        Message::error(format!("More than {limit} items: raise the item limit if that many are wanted"))
    }

    /// Takes `n` bytes, before they are made.
    ///
    /// # Errors
    /// The message to show when the object would put out more than it may.
    pub fn bytes(&self, n: usize) -> Result<(), Message> {
        let limit = self.limits.bytes;
        if take(&self.bytes, n, limit) {
            return Ok(());
        }
        Err(Message::error(format!("More than {limit} bytes: raise the memory limit if that much is wanted")))
    }
}

/// Adds `n` to what was taken unless that passes the limit; a refusal takes nothing.
fn take(taken: &AtomicU64, n: usize, limit: u64) -> bool {
    let add = |now: u64| now.checked_add(n as u64).filter(|&total| total <= limit);
    taken.fetch_update(Ordering::Relaxed, Ordering::Relaxed, add).is_ok()
}

impl Default for Budget {
    fn default() -> Self {
        Self::new(Limits::default(), Cancel::default(), Deadline::never())
    }
}

/// A moment after which a solve stops.
#[derive(Debug, Clone, Copy, Default)]
pub struct Deadline(#[cfg(not(target_family = "wasm"))] Option<std::time::Instant>);

impl Deadline {
    /// No deadline.
    pub fn never() -> Self {
        Self::default()
    }

    /// The moment `time` from now. There is no clock in a bare web page: there it never comes.
    pub fn after(time: Option<Duration>) -> Self {
        #[cfg(not(target_family = "wasm"))]
        return Self(time.and_then(|t| std::time::Instant::now().checked_add(t)));
        #[cfg(target_family = "wasm")]
        {
            let _ = time;
            Self()
        }
    }

    /// The time until then, if there is such a moment.
    pub fn left(self) -> Option<Duration> {
        #[cfg(not(target_family = "wasm"))]
        return self.0.map(|at| at.saturating_duration_since(std::time::Instant::now()));
        #[cfg(target_family = "wasm")]
        None
    }

    fn is_over(self) -> bool {
        #[cfg(not(target_family = "wasm"))]
        return self.0.is_some_and(|at| std::time::Instant::now() >= at);
        #[cfg(target_family = "wasm")]
        false
    }
}
