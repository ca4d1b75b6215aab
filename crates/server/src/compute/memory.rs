//! The memory that all requests together take.
//!
//! Half of it is divided among as many requests as can be worked on at a time: each has such a share, whatever the others
//! take. The other half is for those that take more, first come, first served. So the whole is never exceeded, and a small
//! request is answered beside large ones.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use katydid_component::Account;
use katydid_compute::{Cause, Fault};
use katydid_geometry::{CancellationToken, Waiting};

use super::pool::Step;
use super::refusal::Refusal;
use super::work::Reins;

/// What is left of it.
#[derive(Debug)]
pub(crate) struct Memory {
    common: Arc<Account>,
    share: u64,
}

impl Memory {
    /// So many bytes, for so many requests at a time.
    pub(crate) fn new(bytes: u64, requests: usize) -> Self {
        let requests = u64::try_from(requests).unwrap_or(u64::MAX).max(1);
        let share = bytes / 2 / requests;
        Self { common: Arc::new(Account::new(bytes - share * requests)), share }
    }

    /// The most that one request may ever take.
    pub(crate) fn most(&self) -> u64 {
        self.common.limit().saturating_add(self.share)
    }

    /// The account of a request that may take so many bytes.
    pub(crate) fn account(&self, limit: u64) -> Arc<Account> {
        Arc::new(Account::beside(Arc::clone(&self.common), self.share, limit))
    }

    /// The bytes that are taken beyond shares.
    pub(crate) fn taken(&self) -> u64 {
        self.common.bytes()
    }
}

/// Counts what a thread takes for a request, and ends what it does for it: what is on the way to a solve and from there to
/// the answer.
struct Counted {
    reins: Reins,
    /// Whether something was given up: an answer would not be whole.
    gave_up: AtomicBool,
}

impl Counted {
    fn says(&self, yes: bool) -> bool {
        self.gave_up.fetch_or(!yes, Ordering::Relaxed);
        yes
    }

    /// Why there is no answer, if something was given up on the way to it.
    fn refusal(&self) -> Option<Refusal> {
        let account = &self.reins.memory;
        let no_room = account.is_over();
        if !no_room && !self.gave_up.load(Ordering::Relaxed) {
            return None;
        }
        Some(if account.was_refused() {
            Fault::busy().into()
        } else if self.reins.cancel.is_cancelled() {
            Fault::new(Cause::Cancelled, "the request was cancelled").into()
        } else if self.reins.is_late() {
            self.reins.late()
        } else {
            Refusal::too_large(format!("this takes more than {} bytes", account.limit()))
        })
    }
}

impl Waiting for Counted {
    fn go_on(&self) -> bool {
        self.says(!self.reins.cancel.is_cancelled() && !self.reins.is_late()) && self.has_room(0)
    }

    fn has_room(&self, bytes: u64) -> bool {
        self.reins.memory.settle();
        self.says(self.reins.memory.without_room(bytes).is_none())
    }

    fn begin(&self) {
        self.reins.memory.begin();
    }

    fn end(&self) {
        self.reins.memory.end();
    }
}

/// Works for a request within its time, and counts on its account what that takes.
///
/// # Errors
/// Something was given up, and so there is no answer: for lack of memory or time, or because nobody waits.
pub(crate) fn counted<T: Send + 'static>(
    reins: Reins,
    work: impl FnOnce() -> Step<Result<T, Refusal>> + Send + 'static,
) -> Step<Result<T, Refusal>> {
    let counted = Arc::new(Counted { reins: reins.clone(), gave_up: AtomicBool::new(false) });
    match CancellationToken::of(counted.clone()).during(work) {
        Step::Done(Ok(done)) => Step::Done(counted.refusal().map_or(Ok(done), Err)),
        // Whatever was said where it was given up, this is why.
        Step::Done(Err(_)) if reins.memory.was_refused() || counted.gave_up.load(Ordering::Relaxed) => {
            Step::Done(Err(counted.refusal().unwrap_or_else(|| Fault::busy().into())))
        }
        Step::Done(refused) => Step::Done(refused),
        Step::Later(lane, rest) => Step::Later(lane, Box::new(move || self::counted(reins, rest))),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

    use std::time::{Duration, Instant};

    use katydid_component::Cancel;
    use katydid_compute::CacheControl;

    use super::super::work::Allowance;
    use super::*;

    #[global_allocator]
    static ALLOCATOR: katydid_memory::Counting = katydid_memory::Counting;

    const MEGA: u64 = 1 << 20;

    fn reins(account: &Arc<Account>, time: Duration) -> Reins {
        let allowance = Allowance { time, items: 1, bytes: account.limit() };
        let end = Instant::now().checked_add(time);
        let (cancel, cache, memory) = (Cancel::default(), CacheControl::Allowed, Arc::clone(account));
        Reins { cancel, progress: None, allowance, cache, memory, end }
    }

    /// A request that is answered with so many megabytes.
    fn ask(memory: &Memory, megas: u64) -> Result<(Vec<u8>, Arc<Account>), Refusal> {
        let account = memory.account(u64::MAX);
        let work = move || Step::Done(Ok(vec![1_u8; (megas * MEGA) as usize]));
        match counted(reins(&account, Duration::from_secs(100)), work) {
            Step::Done(done) => done.map(|bytes| (bytes, account)),
            Step::Later(..) => panic!("it is done"),
        }
    }

    #[test]
    fn requests_together_take_no_more_than_there_is() {
        // Eight for all, and two for each of four.
        let memory = Memory::new(16 * MEGA, 4);
        assert_eq!((memory.most(), memory.taken()), (10 * MEGA, 0));
        let first = ask(&memory, 9).unwrap();
        let refusal = ask(&memory, 9).unwrap_err();
        assert_eq!((refusal.status.as_u16(), refusal.cause, refusal.retry), (503, "busy", Some(5)));
        let small = [1, 1, 1].map(|megas| ask(&memory, megas).unwrap());
        assert!(memory.taken() >= 7 * MEGA && memory.taken() < 8 * MEGA);
        drop(first);
        assert_eq!(memory.taken(), 0);
        assert!(ask(&memory, 9).is_ok());
        drop(small);
    }

    /// What a request that writes a megabyte at a time, for as long as it may, is told.
    fn endless(limit: u64, time: Duration, cancelled: bool) -> Refusal {
        let reins = reins(&Memory::new(1 << 40, 4).account(limit), time);
        if cancelled {
            reins.cancel.cancel();
        }
        let work = || {
            let mut written = Vec::new();
            while !CancellationToken::is_over() {
                written.push(vec![1_u8; MEGA as usize]);
                written.truncate(20);
            }
            Step::Done(Ok(written))
        };
        match counted(reins, work) {
            Step::Done(done) => done.unwrap_err(),
            Step::Later(..) => panic!("it is done"),
        }
    }

    #[test]
    fn an_answer_that_is_not_whole_is_none() {
        let long = Duration::from_secs(100);
        let told = endless(8 * MEGA, long, false);
        assert_eq!((told.status.as_u16(), told.cause), (413, "too-large"));
        let told = endless(u64::MAX, Duration::from_millis(20), false);
        assert_eq!((told.status.as_u16(), told.cause), (408, "timed-out"));
        assert_eq!(endless(u64::MAX, long, true).cause, "cancelled");
    }
}
