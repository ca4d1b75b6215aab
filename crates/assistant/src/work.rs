//! Work that may be long, done within a limit of time.

use std::time::Instant;

use katydid_geometry::CancellationToken;

use crate::fault::Fault;
use crate::thresholds::LONGEST_WORK;

/// Does work of the kernel, which stops when its time is over.
///
/// # Errors
/// Its time was over.
pub(crate) fn within<T>(what: &str, work: impl FnOnce() -> T) -> Result<T, Fault> {
    let end = Instant::now() + LONGEST_WORK;
    let done = CancellationToken::new(move || Instant::now() < end).during(work);
    if Instant::now() < end {
        return Ok(done);
    }
    let why = format!("it took more than {} seconds, and was given up", LONGEST_WORK.as_secs());
    Err(Fault::new(what, "", why))
}
