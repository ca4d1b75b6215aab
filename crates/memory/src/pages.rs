//! Large pages for large allocations.
//!
//! A program that fills a large table for the first time has the system hand out its memory page by page. With pages of
//! 4 kB that takes about as long as filling the table; pages of 2 MB are five hundred times fewer. Linux gives them
//! where a program asks (`madvise(2)`, `MADV_HUGEPAGE`), in the usual setting of `transparent_hugepage`.

/// From this size on large pages are asked for. What the last page has too much is then a small part of it.
#[cfg(target_os = "linux")]
const LARGE: usize = 4 << 20;

/// The size of a page, as most machines have it; where it is larger, the system refuses and nothing changes.
#[cfg(target_os = "linux")]
const PAGE: usize = 4096;

/// Asks for large pages for `size` bytes at `place`, where that pays.
///
/// # Safety
/// The bytes are an allocation of the caller.
#[cfg(target_os = "linux")]
#[expect(unsafe_code, reason = "what is asked for concerns an allocation, which is known by its address")]
pub(crate) unsafe fn ask(place: *mut u8, size: usize) {
    if size < LARGE {
        return;
    }
    // Whole pages, the allocator's own words before the allocation too: a mapping of which a part is different from the
    // rest cannot grow (`mremap(2)`, `EFAULT`).
    let before = place.addr() % PAGE;
    // SAFETY: the first and the last page are mapped, as parts of them are allocated. The wish changes neither what is
    // in them nor who may use it, whoever has the rest of them.
    unsafe {
        let start = place.wrapping_sub(before).cast();
        let _ = rustix::mm::madvise(start, before + size, rustix::mm::Advice::LinuxHugepage);
    }
}

/// Other systems choose by themselves.
///
/// # Safety
/// None is needed.
#[cfg(not(target_os = "linux"))]
#[expect(unsafe_code, reason = "as on Linux")]
pub(crate) unsafe fn ask(_place: *mut u8, _size: usize) {}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    /// How many bytes of the range around `place` are in large pages, as the system tells it.
    fn in_large_pages(place: usize) -> Option<u64> {
        let told = std::fs::read_to_string("/proc/self/smaps").ok()?;
        let mut is_here = false;
        for line in told.lines() {
            let first = line.split_ascii_whitespace().next()?;
            if let Some((from, to)) = first.split_once('-') {
                let bound = |text| usize::from_str_radix(text, 16).ok();
                is_here = bound(from)? <= place && place < bound(to)?;
            } else if is_here && first == "AnonHugePages:" {
                return line.split_ascii_whitespace().nth(1)?.parse::<u64>().ok().map(|kb| kb << 10);
            }
        }
        None
    }

    #[test]
    fn a_large_table_is_in_large_pages_and_keeps_what_is_in_it() {
        use std::alloc::{GlobalAlloc, Layout};
        let setting = std::fs::read_to_string("/sys/kernel/mm/transparent_hugepage/enabled");
        let gives = setting.is_ok_and(|setting| !setting.contains("[never]"));
        let count = 64 << 20;
        let layout = Layout::from_size_align(count, 8).unwrap();
        #[expect(unsafe_code, reason = "an allocator is called")]
        // SAFETY: the size is not 0, what is written lies within it, and it is given back with its layout.
        unsafe {
            let place = crate::Counting.alloc(layout);
            assert!(!place.is_null());
            for at in (0..count).step_by(4096) {
                place.add(at).write(at as u8 ^ 7);
            }
            if gives {
                let large = in_large_pages(place.addr() + count / 2).unwrap();
                assert!(large >= count as u64 / 2, "{large}");
            }
            let longer = crate::Counting.realloc(place, layout, 2 * count);
            assert!(!longer.is_null());
            assert!((0..count).step_by(4096).all(|at| longer.add(at).read() == at as u8 ^ 7));
            crate::Counting.dealloc(longer, Layout::from_size_align(2 * count, 8).unwrap());
        }
    }
}
