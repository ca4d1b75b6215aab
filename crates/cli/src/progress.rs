//! A line on a terminal that says how far a long solve has come.

use std::io::{IsTerminal, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use katydid_solver::{Listener, Progress};

/// Solves shorter than this show nothing.
const WAIT: Duration = Duration::from_millis(500);
/// The line changes at most this often.
const PAUSE: u64 = 100;

/// A listener that draws the line; nothing when standard error is no terminal.
pub(crate) fn listener() -> Option<Listener> {
    if !std::io::stderr().is_terminal() {
        return None;
    }
    let start = Instant::now();
    let shown = AtomicU64::new(0);
    Some(Arc::new(move |progress: &Progress| {
        let elapsed = start.elapsed();
        let now = u64::try_from(elapsed.as_millis()).unwrap_or(u64::MAX);
        let last = shown.load(Ordering::Relaxed);
        if elapsed < WAIT || now < last + PAUSE {
            return;
        }
        if shown.compare_exchange(last, now, Ordering::Relaxed, Ordering::Relaxed).is_ok() {
            let name: String = progress.name.chars().filter(|c| !c.is_control()).take(40).collect();
            let _ =
                write!(std::io::stderr(), "\r\x1b[K{} of {} objects, {name}", progress.done, progress.total);
        }
    }))
}

/// Takes the line away.
pub(crate) fn clear() {
    if std::io::stderr().is_terminal() {
        let _ = write!(std::io::stderr(), "\r\x1b[K");
    }
}
