//! Work that is given up when nobody waits for it any more.
//!
//! Functions whose work is long by nature take a `go_on` of their own. All the others may be long too, on input that
//! is large or wild: an intersection, an offset, a loft. They ask here. Whoever starts work says once, for the thread
//! that does it, how long it may go on; what is called from there finds that out by itself, down to the
//! search for a nearest point, and ends with [`Error::Stopped`].
//!
//! ```
//! use katydid_geometry::{CancellationToken, Error, NurbsCurve, Point3};
//! let points: Vec<Point3> = (0..9).map(|i| Point3::new(f64::from(i), 0.0, 0.0)).collect();
//! let none = CancellationToken::new(|| false);
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
    static NOW: RefCell<CancellationToken> = const { RefCell::new(CancellationToken(None)) };
    static ASKED: Cell<u32> = const { Cell::new(0) };
    /// Whether the answer was no: it stays that.
    static OVER: Cell<bool> = const { Cell::new(false) };
}

/// Somebody who waits for work, and who may count what it takes.
pub trait Waiting: Send + Sync {
    /// Whether the work shall go on. It is asked often, from whichever thread does the work.
    fn go_on(&self) -> bool;

    /// Whether the work may take so many bytes more. It is asked before large tables are made.
    fn has_room(&self, bytes: u64) -> bool {
        let _ = bytes;
        true
    }

    /// The work begins on this thread, or goes on there after other work.
    fn begin(&self) {}

    /// The work ends on this thread, or other work comes between.
    fn end(&self) {}
}

impl<F: Fn() -> bool + Send + Sync> Waiting for F {
    fn go_on(&self) -> bool {
        self()
    }
}

/// Waits as somebody else does, but without end.
struct Endless(CancellationToken);

impl Waiting for Endless {
    fn go_on(&self) -> bool {
        true
    }

    fn has_room(&self, bytes: u64) -> bool {
        self.0.0.as_ref().is_none_or(|waiting| waiting.has_room(bytes))
    }

    fn begin(&self) {
        self.0.begin();
    }

    fn end(&self) {
        self.0.end();
    }
}

/// Says whether anybody still waits for work; without end by default.
#[derive(Clone, Default)]
pub struct CancellationToken(Option<Arc<dyn Waiting>>);

impl std::fmt::Debug for CancellationToken {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(if self.0.is_some() { "CancellationToken(while)" } else { "CancellationToken(endless)" })
    }
}

/// Puts back what was there before, also when the work panics.
struct Before {
    now: CancellationToken,
    over: bool,
}

impl Drop for Before {
    fn drop(&mut self) {
        let before = std::mem::take(&mut self.now);
        NOW.replace(before.clone()).end();
        before.begin();
        OVER.set(self.over);
    }
}

impl CancellationToken {
    /// A token by which work goes on as long as `go_on` says yes. It is asked often, from whichever thread does the work.
    pub fn new(go_on: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(go_on)))
    }

    /// The token of somebody who waits.
    pub fn of(waiting: Arc<dyn Waiting>) -> Self {
        Self(Some(waiting))
    }

    /// Does work on this thread under this token, instead of the one that was there before.
    ///
    /// Loops of the kernel that run on several threads carry it along.
    pub fn during<T>(&self, work: impl FnOnce() -> T) -> T {
        let before = Before { now: NOW.replace(self.clone()), over: OVER.replace(false) };
        before.now.end();
        self.begin();
        let done = work();
        drop(before);
        done
    }

    /// Waits on this thread for work that others do, and that carries its own token along.
    ///
    /// A thread that waits may be given anybody's work. It does not end when who waits here gives up; what it
    /// takes is counted by whom it is for, and what nobody counts is counted here.
    pub fn waiting<T>(work: impl FnOnce() -> T) -> T {
        match Self::now() {
            Self(None) => work(),
            own => Self(Some(Arc::new(Endless(own)))).during(work),
        }
    }

    fn begin(&self) {
        if let Some(waiting) = &self.0 {
            waiting.begin();
        }
    }

    fn end(&self) {
        if let Some(waiting) = &self.0 {
            waiting.end();
        }
    }

    /// Whether nobody waits any more for what this thread does, or there is no memory for it: asked now and then in long
    /// loops outside the kernel.
    pub fn is_over() -> bool {
        check().is_err()
    }

    /// Whether what this thread does may take so many bytes more. When it may not, it is over.
    pub fn has_room(bytes: usize) -> bool {
        room::<u8>(bytes).is_ok()
    }

    /// The token of what this thread does now.
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
        #[cfg(test)]
        work::asked();
        // The question is asked with nothing borrowed: it is somebody else's code.
        OVER.set(CancellationToken::now().0.is_some_and(|waiting| !waiting.go_on()));
    }
    if OVER.get() { Err(Error::Stopped) } else { Ok(()) }
}

/// Work that tests count, in evaluations of a point or what takes about as long: so many of it lie between two questions.
/// Other programs count nothing.
#[inline]
pub(crate) fn worked(units: usize) {
    #[cfg(test)]
    work::add(units);
    #[cfg(not(test))]
    let _ = units;
}

/// How much work there was at most between two questions, on this thread.
#[cfg(test)]
pub(crate) mod work {
    use std::cell::Cell;

    thread_local! {
        static SINCE: Cell<usize> = const { Cell::new(0) };
        static MOST: Cell<usize> = const { Cell::new(0) };
    }

    pub(super) fn add(units: usize) {
        SINCE.set(SINCE.get() + units);
    }

    pub(super) fn asked() {
        MOST.set(MOST.get().max(SINCE.replace(0)));
    }

    /// The most until now, that before the end among it; counting begins anew.
    pub(crate) fn most() -> usize {
        asked();
        MOST.replace(0)
    }
}

/// Whether the answer was no for what this thread does now; nobody is asked again.
pub(crate) fn was_given_up() -> bool {
    OVER.get()
}

/// The same before a step that may take milliseconds: the question is passed on each time.
///
/// # Errors
/// As [`check`].
pub(crate) fn check_now() -> Result<()> {
    ASKED.set(EVERY.wrapping_sub(1));
    check()
}

/// Smaller tables are counted once they are there.
const SMALL: u64 = 1 << 16;

/// Whether to go on with a table of so many entries of a type, before it is made.
///
/// # Errors
/// As [`check`], and when there is no memory for it.
pub(crate) fn room<T>(count: usize) -> Result<()> {
    let bytes = u64::try_from(count.saturating_mul(size_of::<T>())).unwrap_or(u64::MAX);
    if bytes <= SMALL {
        return check();
    }
    if CancellationToken::now().0.is_some_and(|waiting| !waiting.has_room(bytes)) {
        OVER.set(true);
    }
    check_now()
}

impl Error {
    /// [`Error::Degenerate`] in one call. Where work was given up, what is wrong with a part of it is no fault of the
    /// input: it was stopped.
    pub(crate) fn degenerate(what: &'static str, why: &'static str) -> Self {
        if was_given_up() { Self::Stopped } else { Self::Degenerate { what, why } }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU32, Ordering};

    use super::*;

    fn runs(most: u32) -> u32 {
        (0..most).find(|_| check().is_err()).unwrap_or(most)
    }

    struct Megabyte;

    impl Waiting for Megabyte {
        fn go_on(&self) -> bool {
            true
        }

        fn has_room(&self, bytes: u64) -> bool {
            bytes <= 1 << 20
        }
    }

    #[test]
    fn tables_are_asked_for() {
        assert!(room::<u64>(usize::MAX).is_ok());
        let some = CancellationToken::of(Arc::new(Megabyte));
        some.during(|| {
            assert!(room::<u64>(1 << 17).is_ok() && runs(1000) == 1000);
            CancellationToken::waiting(|| assert!(room::<u64>(1 << 18).is_err()));
            assert_eq!(room::<u64>(1 << 18), Err(Error::Stopped));
            assert!(check_now().is_err() && runs(1000) == 0);
        });
        let asked = Arc::new(AtomicU32::new(0));
        let own = asked.clone();
        CancellationToken::new(move || own.fetch_add(1, Ordering::Relaxed) < 9).during(|| {
            assert_eq!((0..100).take_while(|_| check_now().is_ok()).count(), 9);
        });
    }

    /// Writes down when work begins and ends.
    struct Diary(&'static str, Arc<std::sync::Mutex<String>>);

    impl Waiting for Diary {
        fn go_on(&self) -> bool {
            false
        }

        fn begin(&self) {
            self.1.lock().unwrap().push_str(&format!("+{}", self.0));
        }

        fn end(&self) {
            self.1.lock().unwrap().push_str(&format!("-{}", self.0));
        }
    }

    #[test]
    fn one_work_runs_at_a_time() {
        let diary = Arc::new(std::sync::Mutex::new(String::new()));
        let [a, b] = ["a", "b"].map(|name| CancellationToken::of(Arc::new(Diary(name, diary.clone()))));
        a.during(|| {
            b.during(|| ());
            CancellationToken::default().during(|| ());
            assert!(runs(1000) < 1000);
            // Counted for the same work, but without its end.
            CancellationToken::waiting(|| {
                assert_eq!(runs(1000), 1000);
                b.during(|| ());
            });
            assert!(runs(1000) < 1000);
        });
        assert_eq!(*diary.lock().unwrap(), "+a-a+b-b+a-a+a-a+a-a+b-b+a-a+a-a");
    }

    #[test]
    fn patience_ends_and_comes_back() {
        assert_eq!(runs(1000), 1000);
        let left = Arc::new(AtomicU32::new(3));
        let own = left.clone();
        let some = CancellationToken::new(move || own.fetch_sub(1, Ordering::Relaxed) > 1);
        let ran = some.during(|| runs(1000));
        assert!((2 * EVERY..=3 * EVERY).contains(&ran), "{ran}");
        assert_eq!(runs(1000), 1000);
        // Within other work, and out of a panic.
        let none = CancellationToken::new(|| false);
        none.during(|| {
            assert_eq!(CancellationToken::default().during(|| runs(1000)), 1000);
            assert!(runs(1000) < EVERY);
        });
        let panics = std::panic::AssertUnwindSafe(|| none.during(|| std::panic::resume_unwind(Box::new(()))));
        assert!(std::panic::catch_unwind(panics).is_err());
        assert_eq!(runs(1000), 1000);
    }
}
