//! What one piece of work takes.

use std::cell::Cell;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicI64, AtomicU64, Ordering};

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
    /// For work beside other work: the bytes that the whole does not count, and whether it had no room for the rest.
    share: Option<(u64, AtomicBool)>,
}

impl Account {
    /// An empty account with a limit in bytes.
    pub fn new(limit: u64) -> Self {
        Self::with(limit, None, None)
    }

    fn with(limit: u64, whole: Option<Arc<Self>>, share: Option<(u64, AtomicBool)>) -> Self {
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        Self { number, bytes: AtomicI64::new(0), limit, whole, share }
    }

    /// An empty account for a part of other work, with a limit of its own.
    pub fn part_of(whole: Arc<Self>, limit: u64) -> Self {
        Self::with(limit, Some(whole), None)
    }

    /// An empty account, with a limit of its own, for work beside other work: a request of a server. What it takes beyond
    /// its share, and only that, counts for the whole, which gets it back when the account is dropped. So the whole never
    /// has room for more than its limit, and each has its share whatever the others take.
    pub fn beside(whole: Arc<Self>, share: u64, limit: u64) -> Self {
        Self::with(limit, Some(whole), Some((share, AtomicBool::new(false))))
    }

    /// What the whole counts of so many bytes of this work.
    fn passed_on(&self, bytes: i64) -> i64 {
        match &self.share {
            Some((share, _)) => bytes.max(0).saturating_sub_unsigned(*share).max(0),
            None => bytes,
        }
    }

    /// Counts `more` bytes, which may be below 0, here and in the whole.
    fn add(&self, mut more: i64) {
        let mut account = Some(self);
        while let Some(here) = account.filter(|_| more != 0) {
            let before = here.bytes.fetch_add(more, Ordering::Relaxed);
            more = here.passed_on(before.wrapping_add(more)).wrapping_sub(here.passed_on(before));
            account = here.whole.as_deref();
        }
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
        self.add(since);
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
        let (mut more, mut account, mut beside) = (i64::try_from(more).unwrap_or(i64::MAX), self, None);
        loop {
            let now = account.bytes.load(Ordering::Relaxed).max(0);
            let then = now.saturating_add(more);
            if then.unsigned_abs() > account.limit {
                if let Some(refused) = beside {
                    AtomicBool::store(refused, true, Ordering::Relaxed);
                }
                return Some(account);
            }
            if let Some((share, refused)) = &account.share {
                if then.unsigned_abs() <= *share {
                    return None;
                }
                beside = Some(refused);
            }
            more = account.passed_on(then) - account.passed_on(now);
            account = account.whole.as_deref()?;
        }
    }

    /// Whether more is counted than this work, or a whole that it is a part of, may take.
    pub fn is_over(&self) -> bool {
        self.without_room(0).is_some()
    }

    /// Whether work [`beside`](Self::beside) other work, or a part of it, was told that the whole has no room.
    pub fn was_refused(&self) -> bool {
        let mut chain = std::iter::successors(Some(self), |account| account.whole.as_deref());
        chain
            .any(|account| account.share.as_ref().is_some_and(|(_, refused)| refused.load(Ordering::Relaxed)))
    }
}

impl Drop for Account {
    fn drop(&mut self) {
        if let (Some(_), Some(whole)) = (&self.share, &self.whole) {
            whole.add(-self.passed_on(self.bytes.load(Ordering::Relaxed)));
        }
    }
}
