//! The memory that all requests together take.
//!
//! Half of it is divided among as many requests as can be worked on at a time: each has such a share, whatever the others
//! take. The other half is for those that take more, first come, first served. So the whole is never exceeded, and a small
//! request is answered beside large ones.

use std::sync::Arc;

use katydid_component::Account;
use katydid_geometry::{Patience, Waiting};

use super::pool::Step;
use super::refusal::Refusal;

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

    /// The account of a request.
    pub(crate) fn account(&self) -> Arc<Account> {
        Arc::new(Account::beside(Arc::clone(&self.common), self.share))
    }

    /// The bytes that are taken beyond shares.
    pub(crate) fn taken(&self) -> u64 {
        self.common.bytes()
    }
}

/// Counts what a thread takes for a request.
struct Counted(Arc<Account>);

impl Waiting for Counted {
    fn go_on(&self) -> bool {
        self.has_room(0)
    }

    fn has_room(&self, bytes: u64) -> bool {
        self.0.settle();
        self.0.without_room(bytes).is_none()
    }

    fn begin(&self) {
        self.0.begin();
    }

    fn end(&self) {
        self.0.end();
    }
}

/// Works for a request, and counts on its account what that takes.
///
/// # Errors
/// There was no memory for it beside what else is done.
pub(crate) fn counted<T: Send + 'static>(
    account: Arc<Account>,
    work: impl FnOnce() -> Step<Result<T, Refusal>> + Send + 'static,
) -> Step<Result<T, Refusal>> {
    match Patience::of(Arc::new(Counted(Arc::clone(&account)))).during(work) {
        // What was given up on the way is no answer.
        Step::Done(_) if account.was_refused() || account.is_over() => {
            Step::Done(Err(katydid_compute::Fault::busy().into()))
        }
        Step::Done(done) => Step::Done(done),
        Step::Later(lane, rest) => Step::Later(lane, Box::new(move || counted(account, rest))),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

    use super::*;

    #[global_allocator]
    static ALLOCATOR: katydid_memory::Counting = katydid_memory::Counting;

    const MEGA: u64 = 1 << 20;

    /// A request that is answered with so many megabytes.
    fn ask(memory: &Memory, megas: u64) -> Result<(Vec<u8>, Arc<Account>), Refusal> {
        let account = memory.account();
        let work = move || Step::Done(Ok(vec![1_u8; (megas * MEGA) as usize]));
        match counted(Arc::clone(&account), work) {
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
}
