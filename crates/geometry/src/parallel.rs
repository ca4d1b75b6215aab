//! Loops over many things, on several threads where the kernel runs so.
//!
//! While a thread waits for others it may be given work of somebody else's from the same pool. So it waits without its
//! [`CancellationToken`](crate::CancellationToken), and its own work carries that along.

#[cfg(feature = "parallel")]
use crate::cancellation::CancellationToken;

/// An answer for each item, in order.
pub(crate) fn each<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    #[cfg(feature = "parallel")]
    if items.len() > 1 {
        use rayon::prelude::*;
        let own = CancellationToken::now();
        return waiting(|| items.par_iter().map(|item| own.during(|| work(item))).collect());
    }
    items.iter().map(work).collect()
}

/// Waits for a loop on several threads that asks no token.
#[cfg(feature = "parallel")]
pub(crate) fn waiting<T>(threads: impl FnOnce() -> T) -> T {
    CancellationToken::waiting(threads)
}

#[cfg(all(test, feature = "parallel"))]
mod tests {
    use super::*;
    use crate::cancellation::check;

    #[test]
    fn patience_goes_along_and_is_nobody_elses() {
        let items: Vec<u32> = (0..2000).collect();
        let asked = |_: &u32| (0..100).try_for_each(|_| check()).is_err();
        let none = CancellationToken::new(|| false);
        assert!(none.during(|| each(&items, asked)).into_iter().all(|stopped| stopped));
        // What others give to the pool while this thread waits, which it may be the one to do.
        let others = none.during(|| waiting(|| rayon::join(|| each(&items, asked), || each(&items, asked))));
        assert!(!others.0.into_iter().chain(others.1).any(|stopped| stopped));
        assert!(!each(&items, asked).into_iter().any(|stopped| stopped));
    }
}
