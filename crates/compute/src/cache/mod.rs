//! What is kept for the next request, within a bound of memory: definitions, and replies of requests that allow it.

mod definitions;
mod replies;
pub(crate) mod weigh;

pub(crate) use definitions::Definitions;
pub(crate) use replies::Replies;

use std::sync::{Mutex, MutexGuard, PoisonError};

/// The key of a definition that came as text: `md5_` and the MD5 of the text in capitals, as Rhino.Compute has it. No
/// secret hangs on it: two texts of one hash can only be made by the author of both.
pub fn key(algo: &str) -> String {
    use md5::{Digest, Md5};
    use std::fmt::Write;

    let mut key = String::with_capacity(36);
    key.push_str("md5_");
    for byte in Md5::digest(algo.as_bytes()) {
        // Writing to a string does not fail.
        let _ = write!(key, "{byte:02X}");
    }
    key
}

/// The lock of a store that is sound after each single step: a panic elsewhere does not spoil it.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_those_of_the_standard() {
        // RFC 1321, appendix A.5.
        assert_eq!(key(""), "md5_D41D8CD98F00B204E9800998ECF8427E");
        assert_eq!(key("message digest"), "md5_F96B697D7CB7938D525A2F31AAF161D0");
    }
}
