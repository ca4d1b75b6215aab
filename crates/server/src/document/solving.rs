//! When a document is solved, and when a solve is given up for a newer one.
//!
//! A newer edit gives up the solve that is running, but not at once: a solve that takes no longer than the ones before it
//! is let through, so that dragging a slider shows something all the way. Edits in between do not wait in line: the next
//! solve has them all.

use std::sync::mpsc::Sender;
use std::time::{Duration, Instant};

use katydid_component::Cancel;

use super::worker::{Ended, Job};

/// A solve may go on for so long at least although there are newer edits.
const LEAST_WAIT: Duration = Duration::from_millis(250);
/// And for so long at most.
const MOST_WAIT: Duration = Duration::from_secs(2);

/// What is to be done.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Work {
    /// Only drawing.
    Draw,
    /// Solving and drawing.
    Solve,
}

/// The state of the worker as its document knows it.
#[derive(Debug)]
pub(super) struct Solving {
    /// The number of the solve that was begun last.
    number: u64,
    running: Option<Running>,
    /// What is to be done when the worker is idle.
    wanted: Option<Work>,
    token: Duration,
}

#[derive(Debug)]
struct Running {
    cancel: Cancel,
    began: Instant,
}

impl Default for Solving {
    fn default() -> Self {
        Self { number: 0, running: None, wanted: None, token: LEAST_WAIT }
    }
}

impl Solving {
    /// Whether nothing is being done and nothing waits to be.
    pub(super) fn is_idle(&self) -> bool {
        self.running.is_none() && self.wanted.is_none()
    }

    /// Asks for work: now, or as soon as the worker is idle.
    pub(super) fn want(&mut self, work: Work, jobs: &Sender<Job>) {
        self.wanted = self.wanted.max(Some(work));
        if self.running.is_none() {
            self.start(jobs);
        }
    }

    fn start(&mut self, jobs: &Sender<Job>) {
        let Some(work) = self.wanted.take() else { return };
        let cancel = Cancel::default();
        self.number += 1;
        let job = match work {
            Work::Draw => Job::Draw(self.number, cancel.clone()),
            Work::Solve => Job::Solve(self.number, cancel.clone()),
        };
        let sent = jobs.send(job).is_ok();
        self.running = sent.then(|| Running { cancel, began: Instant::now() });
    }

    /// Somebody wants the solve to stop, and no other instead.
    pub(super) fn cancel(&mut self) {
        self.wanted = None;
        if let Some(running) = &self.running {
            running.cancel.cancel();
        }
    }

    /// When the solve that is running is to be given up for a newer one. What is only to be drawn waits for it: nobody
    /// would begin the solve again.
    pub(super) fn gives_up(&self) -> Option<Instant> {
        let running = self.running.as_ref().filter(|running| !running.cancel.is_cancelled())?;
        (self.wanted == Some(Work::Solve)).then(|| running.began + self.token)
    }

    /// Gives the solve up when its time is over.
    pub(super) fn tick(&self) {
        if let (Some(at), Some(running)) = (self.gives_up(), &self.running)
            && Instant::now() >= at
        {
            running.cancel.cancel();
        }
    }

    /// A solve has ended: the next may take a little longer, and longer still when this one was given up.
    pub(super) fn ended(&mut self, ended: &Ended) {
        let next = if ended.cancelled { 2 * self.token } else { ended.took + ended.took / 2 };
        self.token = next.clamp(LEAST_WAIT, MOST_WAIT);
    }

    /// The worker has nothing to do.
    pub(super) fn idle(&mut self, jobs: &Sender<Job>) {
        self.running = None;
        self.start(jobs);
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "a test may fail")]

    use std::sync::mpsc::{Receiver, channel};

    use super::*;

    fn solve(jobs: &Receiver<Job>) -> (u64, Cancel) {
        match jobs.try_recv().unwrap() {
            Job::Solve(number, cancel) => (number, cancel),
            _ => panic!("no solve"),
        }
    }

    #[test]
    fn many_edits_are_one_solve_more() {
        let (sender, jobs) = channel();
        let mut solving = Solving::default();
        (0..100).for_each(|_| solving.want(Work::Solve, &sender));
        let (first, cancel) = solve(&jobs);
        assert!(jobs.try_recv().is_err() && !cancel.is_cancelled());
        solving.idle(&sender);
        let (second, _) = solve(&jobs);
        assert_eq!((first, second), (1, 2));
        solving.idle(&sender);
        assert!(jobs.try_recv().is_err());
    }

    #[test]
    fn a_long_solve_gives_way_and_the_next_may_take_longer() {
        let (sender, jobs) = channel();
        let mut solving = Solving::default();
        solving.want(Work::Solve, &sender);
        let (_, cancel) = solve(&jobs);
        assert!(solving.gives_up().is_none());
        solving.want(Work::Solve, &sender);
        assert!(solving.gives_up().unwrap() <= Instant::now() + LEAST_WAIT);
        solving.running.as_mut().unwrap().began -= LEAST_WAIT;
        solving.tick();
        assert!(cancel.is_cancelled());
        for (cancelled, took, token) in [
            (true, 250, 500),
            (true, 500, 1000),
            (false, 600, 900),
            (true, 9000, 1800),
            (true, 1, 2000),
            (false, 1, 250),
        ] {
            let took = Duration::from_millis(took);
            solving.ended(&Ended { cancelled, took, unfinished: 0 });
            assert_eq!(solving.token, Duration::from_millis(token));
        }
    }

    #[test]
    fn no_solve_is_given_up_for_a_drawing() {
        let (sender, jobs) = channel();
        let mut solving = Solving::default();
        solving.want(Work::Solve, &sender);
        let (_, cancel) = solve(&jobs);
        solving.want(Work::Draw, &sender);
        solving.running.as_mut().unwrap().began -= MOST_WAIT;
        solving.tick();
        assert!(solving.gives_up().is_none() && !cancel.is_cancelled());
        solving.idle(&sender);
        assert!(matches!(jobs.try_recv(), Ok(Job::Draw(..))));
    }

    #[test]
    fn who_cancels_wants_no_other_solve() {
        let (sender, jobs) = channel();
        let mut solving = Solving::default();
        solving.want(Work::Solve, &sender);
        solving.want(Work::Solve, &sender);
        let (_, cancel) = solve(&jobs);
        solving.cancel();
        solving.idle(&sender);
        assert!(cancel.is_cancelled() && jobs.try_recv().is_err());
    }
}
