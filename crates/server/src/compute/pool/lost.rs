//! Threads that were given up: they were told to stop, and work on.

use std::collections::HashMap;
use std::time::{Duration, Instant};

use super::queue::Ticket;

/// What was given up and is not back yet.
#[derive(Debug, Default)]
pub(super) struct Lost(HashMap<Ticket, Instant>);

impl Lost {
    /// So many threads may be given up at a time.
    pub(super) const MOST: usize = 16;
    /// What was given up may be back soon: a step of a computation that cannot be interrupted has an end. After so long it
    /// counts as stuck.
    const SOON: Duration = Duration::from_millis(500);

    pub(super) fn has_room(&self) -> bool {
        self.0.len() < Self::MOST
    }

    pub(super) fn add(&mut self, ticket: Ticket, now: Instant) {
        self.0.insert(ticket, now);
    }

    /// Whether it had been given up; it is back now.
    pub(super) fn is_back(&mut self, ticket: Ticket) -> bool {
        self.0.remove(&ticket).is_some()
    }

    pub(super) fn count(&self) -> usize {
        self.0.len()
    }

    /// How many do not stop.
    pub(super) fn stuck(&self, now: Instant) -> usize {
        self.0.values().filter(|since| now.saturating_duration_since(**since) >= Self::SOON).count()
    }
}

#[cfg(test)]
mod tests {
    use super::super::queue::{Client, Places, Queue};
    use super::*;

    #[test]
    fn what_does_not_come_back_soon_is_stuck() {
        let mut queue = Queue::new(Places { quick: 1, new: 0, slow: 0, spare: 0, waiting: 2 });
        let tickets = [0, 1].map(|n| queue.put(Client(0), |_| n).unwrap_or_else(|_| panic!("there is room")));
        let (mut lost, now) = (Lost::default(), Instant::now());
        lost.add(tickets[0], now);
        lost.add(tickets[1], now + Lost::SOON);
        assert_eq!((lost.count(), lost.stuck(now)), (2, 0));
        assert_eq!(lost.stuck(now + Lost::SOON), 1);
        assert!(lost.is_back(tickets[0]) && !lost.is_back(tickets[0]));
        assert_eq!((lost.count(), lost.stuck(now + Lost::SOON)), (1, 0));
        assert_eq!(lost.stuck(now + 2 * Lost::SOON), 1);
        assert!(lost.has_room());
    }
}
