//! What one piece of work takes.

use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicI64, AtomicU64, Ordering};

use crate::counting::held;

thread_local! {
    /// What the thread held when it was looked at last: what came since then belongs to nobody yet.
    static MARK: Cell<i64> = const { Cell::new(0) };
    /// The number of the account whose work the thread does; 0 for none.
    static CURRENT: Cell<u64> = const { Cell::new(0) };
}

/// The number of the next account.
static NEXT: AtomicU64 = AtomicU64::new(1);

/// What one piece of work has taken and not given back, and how much it may take. Work on several threads, or work that
/// is part of other work, has one account: what a part takes counts for the whole.
///
/// Nothing is counted unless [`Counting`](crate::Counting) is the allocator of the program.
#[derive(Debug)]
pub struct Account {
    number: u64,
    bytes: AtomicI64,
    limit: u64,
    whole: Option<Arc<Account>>,
}

impl Account {
    /// An empty account with a limit in bytes.
    pub fn new(limit: u64) -> Self {
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        Self { number, bytes: AtomicI64::new(0), limit, whole: None }
    }

    /// An empty account for a part of other work, with a limit of its own.
    pub fn part_of(whole: Arc<Self>, limit: u64) -> Self {
        Self { whole: Some(whole), ..Self::new(limit) }
    }

    /// This account and those that it is a part of.
    fn chain(&self) -> impl Iterator<Item = &Self> {
        std::iter::successors(Some(self), |account| account.whole.as_deref())
    }

    /// From here on what this thread takes is this work's. What it took before and nobody settled is nobody's.
    pub fn begin(&self) {
        CURRENT.set(self.number);
        MARK.set(held());
    }

    /// Counts what this thread has taken since it began or settled last; nothing on a thread that does other work.
    pub fn settle(&self) {
        if CURRENT.get() != self.number {
            return;
        }
        let now = held();
        let since = now.wrapping_sub(MARK.replace(now));
        if since != 0 {
            for account in self.chain() {
                account.bytes.fetch_add(since, Ordering::Relaxed);
            }
        }
    }

    /// How much this thread has taken or given back for this work since it settled last.
    #[inline]
    pub fn unsettled(&self) -> u64 {
        if CURRENT.get() == self.number { held().wrapping_sub(MARK.get()).unsigned_abs() } else { 0 }
    }

    /// Settles; what this thread takes after that is not this work's.
    pub fn end(&self) {
        self.settle();
        if CURRENT.get() == self.number {
            CURRENT.set(0);
        }
    }

    /// What is counted, in bytes; what was given back for others is not counted below 0.
    pub fn bytes(&self) -> u64 {
        u64::try_from(self.bytes.load(Ordering::Relaxed)).unwrap_or(0)
    }

    /// The limit in bytes.
    pub fn limit(&self) -> u64 {
        self.limit
    }

    /// The account in whose limit `more` bytes do not fit: this one, or one that it is a part of.
    pub fn without_room(&self, more: u64) -> Option<&Self> {
        self.chain().find(|account| account.bytes().saturating_add(more) > account.limit)
    }

    /// Whether more is counted than this work, or a whole that it is a part of, may take.
    pub fn is_over(&self) -> bool {
        self.without_room(0).is_some()
    }
}
