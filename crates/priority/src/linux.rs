//! Niceness, turns and processors of Linux.

use std::time::Duration;

use rustix::process::Pid;
use rustix::thread::{CpuSet, sched_getaffinity, sched_setaffinity};

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

/// Which of the processors that this process may use.
#[derive(Debug, Clone, Copy)]
pub(super) enum Processors {
    All,
    /// The first one is left out, if there are others.
    AllButOne,
}

/// Says where the threads of a process may run; gives whether it has any.
pub(super) fn place(process: u32, processors: Processors) -> bool {
    let Ok(mut set) = sched_getaffinity(None) else { return false };
    if let Processors::AllButOne = processors
        && set.count() > 1
        && let Some(first) = (0..CpuSet::MAX_CPU).find(|&processor| set.is_set(processor))
    {
        set.unset(first);
    }
    let Ok(threads) = std::fs::read_dir(format!("/proc/{process}/task")) else { return false };
    let mut is_there = false;
    for thread in threads.flatten() {
        let number = thread.file_name().to_str().and_then(|name| name.parse().ok());
        if let Some(thread) = number.and_then(Pid::from_raw) {
            // A thread that has ended meanwhile needs no place.
            is_there |= sched_setaffinity(Some(thread), &set).is_ok();
        }
    }
    is_there
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

    #[test]
    fn another_process_is_kept_off_one_processor_and_let_back() {
        let allowed = |process: u32| {
            let process = rustix::process::Pid::from_raw(i32::try_from(process).ok()?);
            Some(rustix::thread::sched_getaffinity(process).ok()?.count())
        };
        let all = rustix::thread::sched_getaffinity(None).map(|set| set.count()).unwrap_or_default();
        let Ok(mut other) = std::process::Command::new("sleep").arg("60").spawn() else {
            panic!("a process to look at: no program `sleep`")
        };
        let number = other.id();
        let before = allowed(number);
        let is_placed = super::place(number, super::Processors::AllButOne);
        let kept_off = allowed(number);
        super::place(number, super::Processors::All);
        let back = allowed(number);
        let _ = other.kill();
        let _ = other.wait();
        assert!(is_placed);
        assert_eq!((before, kept_off, back), (Some(all), Some(all.max(2) - 1), Some(all)));
        assert!(!super::place(number, super::Processors::All), "it has ended");
    }
}
