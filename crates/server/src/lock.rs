use std::sync::{Mutex, MutexGuard, PoisonError};

/// Holds what a mutex guards. What a thread left behind that failed is taken as it is: it is put right by what comes
/// next, and one failure must not become many.
pub(crate) fn held<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
