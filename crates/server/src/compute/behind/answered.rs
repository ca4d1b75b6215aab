//! Whether the process behind answers: what waits for a processor is told from what hangs.

use std::sync::Mutex;
use std::time::{Duration, Instant};

use crate::lock::held;

/// When it last answered, and since when it has not answered who asked how it is.
#[derive(Debug)]
pub(super) struct Answered(Mutex<Times>);

#[derive(Debug)]
struct Times {
    last: Instant,
    missed: Option<Instant>,
}

impl Answered {
    pub(super) fn now() -> Self {
        Self(Mutex::new(Times { last: Instant::now(), missed: None }))
    }

    pub(super) fn touch(&self) {
        *held(&self.0) = Times { last: Instant::now(), missed: None };
    }

    /// How long ago it last answered anybody.
    pub(super) fn since(&self) -> Duration {
        held(&self.0).last.elapsed()
    }

    /// Notes that it has not answered in time; tells how long ago that was noted first.
    pub(super) fn missed(&self) -> Duration {
        held(&self.0).missed.get_or_insert_with(Instant::now).elapsed()
    }
}

/// Whether a thread of a process runs or waits for a processor, where the system tells. One that was stopped, or whose
/// threads all sleep, does not.
pub(super) fn wants_processor(process: u32) -> bool {
    let Ok(threads) = std::fs::read_dir(format!("/proc/{process}/task")) else { return false };
    let runs = |stat: String| {
        // Behind the name of the thread in brackets, which may hold brackets.
        stat.rsplit(')').next().is_some_and(|rest| rest.trim_start().starts_with('R'))
    };
    threads.flatten().any(|thread| std::fs::read_to_string(thread.path().join("stat")).is_ok_and(runs))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_question_that_was_missed_counts_until_it_answers() {
        let answered = Answered::now();
        let first = answered.missed();
        std::thread::sleep(Duration::from_millis(5));
        assert!(answered.missed() >= first + Duration::from_millis(5));
        assert!(answered.since() >= Duration::from_millis(5));
        answered.touch();
        assert!(held(&answered.0).missed.is_none(), "it begins anew");
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn who_works_wants_a_processor() {
        // This thread runs.
        assert!(wants_processor(std::process::id()));
        assert!(!wants_processor(u32::MAX));
    }
}
