//! Niceness and turns of Linux.

use std::time::Duration;

/// How many steps of niceness a thread is lowered by. Of a processor that both want it gets about a thirtieth of what
/// the others get.
const BEHIND: i32 = 15;

/// The shortest turn that the scheduler takes: a tenth of a millisecond (`sched_setattr` clamps to 0.1 to 100 ms).
pub(super) const SHORT: Duration = Duration::from_micros(100);

pub(super) fn lower() {
    // Niceness is of a thread on Linux, and "this process" there is the calling thread.
    if let Ok(now) = rustix::process::getpriority_process(None) {
        let _ = rustix::process::setpriority_process(None, now.saturating_add(BEHIND));
    }
}

/// Sets the length of the turns of the calling thread; `None` for the usual one.
///
/// The scheduler runs first whose turn would end first, of those that have not had more than their share: a short turn
/// ends sooner (Linux 6.12, `sched_setattr(2)`; Stoica and Abdel-Wahab, *Earliest eligible virtual deadline first*,
/// 1995).
pub(super) fn set_turns(length: Option<Duration>) {
    // The call sets the niceness too.
    let Ok(nice) = rustix::process::getpriority_process(None) else { return };
    let turn = length.map_or(0, |length| u64::try_from(length.as_nanos()).unwrap_or(0));
    let mut wish = Wish { size: size_of::<Wish>() as u32, nice, runtime: turn, ..Wish::default() };
    ask(&mut wish);
}

/// `struct sched_attr` of Linux in its first form of 48 bytes.
#[repr(C)]
#[derive(Default)]
struct Wish {
    size: u32,
    /// 0: the usual one.
    policy: u32,
    flags: u64,
    nice: i32,
    priority: u32,
    /// Nanoseconds; 0 for the usual length.
    runtime: u64,
    deadline: u64,
    period: u64,
}

#[expect(unsafe_code, reason = "no library has a safe call for the length of turns")]
fn ask(wish: &mut Wish) {
    const THIS_THREAD: libc::c_long = 0;
    const NO_FLAGS: libc::c_long = 0;
    // SAFETY: the kernel reads `size` bytes from the address, which is that of a `Wish` of that size that nobody else
    // uses until the call is over, and writes nothing there but another size when it does not take this one (`E2BIG`).
    // Any bytes that it could write are a `Wish`. The answer is not needed.
    unsafe {
        libc::syscall(libc::SYS_sched_setattr, THIS_THREAD, std::ptr::from_mut(wish), NO_FLAGS);
    }
}

#[cfg(test)]
mod tests {
    fn niceness() -> i32 {
        rustix::process::getpriority_process(None).unwrap_or_default()
    }

    /// The length of the calling thread's turns in nanoseconds, as the kernel tells it; nothing where it does not, or
    /// where all threads have the same.
    fn turns() -> Option<f64> {
        let release = std::fs::read_to_string("/proc/sys/kernel/osrelease").ok()?;
        let mut numbers = release.split(['.', '-']).map_while(|part| part.parse::<u32>().ok());
        if (numbers.next()?, numbers.next()?) < (6, 12) {
            return None;
        }
        let told = std::fs::read_to_string("/proc/thread-self/sched").ok()?;
        let line = told.lines().find(|line| line.starts_with("se.slice"))?;
        line.rsplit(':').next()?.trim().parse().ok()
    }

    #[test]
    fn only_this_thread_is_behind() {
        let before = niceness();
        let lowered = std::thread::spawn(|| {
            super::lower();
            niceness()
        });
        let lowered = lowered.join().unwrap_or_default();
        assert!(lowered > before || before >= 19, "{before} {lowered}");
        assert_eq!(niceness(), before);
    }

    #[test]
    fn turns_leave_the_niceness_as_it_is() {
        let both = std::thread::spawn(|| {
            super::lower();
            let lowered = niceness();
            super::set_turns(Some(super::SHORT));
            let short = (niceness(), turns());
            super::set_turns(None);
            (lowered, short, niceness(), turns())
        });
        let (lowered, (with_short, short), with_usual, usual) = both.join().unwrap_or_default();
        assert_eq!((with_short, with_usual), (lowered, lowered));
        if let (Some(short), Some(usual)) = (short, usual) {
            assert!(short < usual, "{short} {usual}");
        }
    }
}
