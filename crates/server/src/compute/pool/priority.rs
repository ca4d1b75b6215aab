//! Priorities of threads.

/// How many steps of niceness solves in the back are behind the rest of the program. Of a processor that both want they
/// get about a thirtieth.
#[cfg(target_os = "linux")]
const BEHIND: i32 = 15;

/// Lowers the priority of this thread, for good. Where the system has none for threads, all have the same.
pub(crate) fn lower() {
    // Niceness is of a thread on Linux, and "this process" there is the calling thread.
    #[cfg(target_os = "linux")]
    if let Ok(now) = rustix::process::getpriority_process(None) {
        let _ = rustix::process::setpriority_process(None, now.saturating_add(BEHIND));
    }
}

#[cfg(all(test, target_os = "linux"))]
mod tests {
    #[test]
    fn only_this_thread_is_behind() {
        let now = || rustix::process::getpriority_process(None).unwrap_or_default();
        let before = now();
        let lowered = std::thread::spawn(move || {
            super::lower();
            now()
        });
        let lowered = lowered.join().unwrap_or_default();
        assert!(lowered > before || before >= 19, "{before} {lowered}");
        assert_eq!(now(), before);
    }
}
