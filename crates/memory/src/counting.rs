//! The allocator.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::sync::OnceLock;

use crate::pages;

thread_local! {
    /// What this thread has taken less what it has given back. It may be below 0: a thread may give back what another
    /// one took.
    static HELD: Cell<i64> = const { Cell::new(0) };
}

/// The system's allocator, which counts what each thread takes and gives back.
#[derive(Debug, Clone, Copy, Default)]
pub struct Counting;

/// What an allocation takes with the allocator's own words around it, as glibc has them: eight bytes more, in steps of
/// sixteen, 32 at least. Small things take up to a half more than their size.
fn footprint(size: usize) -> i64 {
    let whole = size.saturating_add(8 + 15) & !15;
    i64::try_from(whole.max(32)).unwrap_or(i64::MAX)
}

fn add(bytes: i64) {
    HELD.set(HELD.get().wrapping_add(bytes));
}

/// What this thread has taken less what it has given back since it began.
pub(crate) fn held() -> i64 {
    HELD.get()
}

// SAFETY: every call is handed to the system's allocator as it came, and its answer is given back as it is. Counting
// touches a cell of the thread that is made without allocation and has no destructor, and does not panic.
#[expect(unsafe_code, reason = "an allocator has no other form")]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller keeps to the contract of `alloc`, which is the system's.
        let place = unsafe { System.alloc(layout) };
        if !place.is_null() {
            add(footprint(layout.size()));
            // SAFETY: it has just been allocated.
            unsafe { pages::ask(place, layout.size()) };
        }
        place
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: as in `alloc`.
        let place = unsafe { System.alloc_zeroed(layout) };
        if !place.is_null() {
            add(footprint(layout.size()));
            // SAFETY: it has just been allocated.
            unsafe { pages::ask(place, layout.size()) };
        }
        place
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        // SAFETY: `place` came from the system's allocator with this layout: the caller says so.
        unsafe { System.dealloc(place, layout) };
        add(-footprint(layout.size()));
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: as in `dealloc`, and `size` is one that the caller may ask for.
        let moved = unsafe { System.realloc(place, layout, size) };
        if !moved.is_null() {
            add(footprint(size) - footprint(layout.size()));
            // SAFETY: it is what the allocation has become.
            unsafe { pages::ask(moved, size) };
        }
        moved
    }
}

/// Whether [`Counting`] is the allocator of this program.
pub fn is_counting() -> bool {
    static COUNTING: OnceLock<bool> = OnceLock::new();
    *COUNTING.get_or_init(|| {
        let before = held();
        let probe = std::hint::black_box(Box::new(0_u64));
        let counted = held() != before;
        drop(probe);
        counted
    })
}

#[cfg(test)]
mod tests {
    use super::footprint;

    /// What glibc 2.36 takes for these sizes: malloc_usable_size and eight bytes more.
    #[test]
    fn small_allocations_take_more_than_their_size() {
        for (size, taken) in [(0, 32), (1, 32), (24, 32), (25, 48), (40, 48), (41, 64), (1000, 1008)] {
            assert_eq!(footprint(size), taken, "{size}");
        }
        assert_eq!(footprint(usize::MAX), i64::MAX);
    }
}
