//! Work that is given up when nobody waits for it any more.
//!
//! Functions whose work is long by nature take a `go_on` of their own. All the others may be long too, on input that
//! is large or wild: an intersection, an offset, a loft. They ask here. Whoever starts work says once, for the thread
//! that does it, how long there is patience for it; what is called from there finds that out by itself, down to the
//! search for a nearest point, and ends with [`Error::Stopped`].
//!
//! ```
//! use katydid_geometry::{Error, NurbsCurve, Patience, Point3};
//! let points: Vec<Point3> = (0..9).map(|i| Point3::new(f64::from(i), 0.0, 0.0)).collect();
//! let none = Patience::new(|| false);
//! let made = none.during(|| (0..100).try_for_each(|_| NurbsCurve::clamped_uniform(3, &points).map(|_| ())));
//! assert_eq!(made, Err(Error::Stopped));
//! assert!(NurbsCurve::clamped_uniform(3, &points).is_ok());
//! ```

use std::cell::{Cell, RefCell};
use std::sync::Arc;

use crate::{Error, Result};

/// Of so many times that the work asks, one is passed on: the answer may cost the look at a clock.
const EVERY: u32 = 16;

thread_local! {
    static NOW: RefCell<Patience> = const { RefCell::new(Patience(None)) };
    static ASKED: Cell<u32> = const { Cell::new(0) };
    /// Whether the answer was no: it stays that.
    static OVER: Cell<bool> = const { Cell::new(false) };
}

/// How long somebody waits for work; without end by default.
#[derive(Clone, Default)]
pub struct Patience(Option<Arc<dyn Fn() -> bool + Send + Sync>>);

impl std::fmt::Debug for Patience {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(if self.0.is_some() { "Patience(while)" } else { "Patience(endless)" })
    }
}

/// Puts back what was there before, also when the work panics.
struct Before {
    now: Patience,
    over: bool,
}

impl Drop for Before {
    fn drop(&mut self) {
        NOW.set(std::mem::take(&mut self.now));
        OVER.set(self.over);
    }
}

impl Patience {
    /// Patience for as long as `go_on` says yes. It is asked often, from whichever thread does the work.
    pub fn new(go_on: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(go_on)))
    }

    /// Does work on this thread with this patience, instead of that which was there before.
    ///
    /// Loops of the kernel that run on several threads carry it along.
    pub fn during<T>(&self, work: impl FnOnce() -> T) -> T {
        let _before = Before { now: NOW.replace(self.clone()), over: OVER.replace(false) };
        work()
    }

    /// The patience for what this thread does now.
    pub(crate) fn now() -> Self {
        NOW.with_borrow(Clone::clone)
    }
}

/// Whether to go on: asked in loops, now and then, by all that may take long.
///
/// # Errors
/// [`Error::Stopped`] when nobody waits any more.
pub(crate) fn check() -> Result<()> {
    let asked = ASKED.get().wrapping_add(1);
    ASKED.set(asked);
    if asked.is_multiple_of(EVERY) && !OVER.get() {
        // The question is asked with nothing borrowed: it is somebody else's code.
        OVER.set(Patience::now().0.is_some_and(|go_on| !go_on()));
    }
    if OVER.get() { Err(Error::Stopped) } else { Ok(()) }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU32, Ordering};

    use super::*;

    fn runs(most: u32) -> u32 {
        (0..most).find(|_| check().is_err()).unwrap_or(most)
    }

    #[test]
    fn patience_ends_and_comes_back() {
        assert_eq!(runs(1000), 1000);
        let left = Arc::new(AtomicU32::new(3));
        let own = left.clone();
        let some = Patience::new(move || own.fetch_sub(1, Ordering::Relaxed) > 1);
        let ran = some.during(|| runs(1000));
        assert!((2 * EVERY..=3 * EVERY).contains(&ran), "{ran}");
        assert_eq!(runs(1000), 1000);
        // Within other work, and out of a panic.
        let none = Patience::new(|| false);
        none.during(|| {
            assert_eq!(Patience::default().during(|| runs(1000)), 1000);
            assert!(runs(1000) < EVERY);
        });
        let panics = std::panic::AssertUnwindSafe(|| none.during(|| std::panic::resume_unwind(Box::new(()))));
        assert!(std::panic::catch_unwind(panics).is_err());
        assert_eq!(runs(1000), 1000);
    }
}
