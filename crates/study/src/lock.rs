//! What several threads share.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// The guard of a mutex: what a thread that panicked left is looked at all the same.
pub(crate) fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
