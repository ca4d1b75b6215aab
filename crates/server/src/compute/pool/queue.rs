//! Who is solved next.
//!
//! There are three lanes: for what is known to be quick, for what is new, and for what is known to be slow. Work that has
//! run longer than [`SLICE`] counts as slow from then on, wherever it came from, and its place is free again. New work
//! never has all threads: so a hundred solves that never end hold up each other, and not who asks for a small thing.
//!
//! Within a lane the clients take turns, however many requests each of them has sent, and no client has all places.

use std::collections::{HashMap, VecDeque};
use std::time::{Duration, Instant};

/// Work that takes longer is slow.
pub(crate) const SLICE: Duration = Duration::from_millis(200);

/// Where a thread stands that takes work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Row {
    /// It has the priority of the program, and takes quick work.
    Front,
    /// It has a lower priority, and takes any work.
    Back,
}

/// Where work waits and runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Lane {
    /// Requests are read here, and what was quick the last time is solved here.
    Quick,
    /// What was never solved before.
    New,
    /// What took long the last time.
    Slow,
}

/// Who asks. All that is known of them here is whether it is somebody else.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Client(pub(crate) u64);

/// The number of a piece of work.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Ticket(u64);

/// How much runs and waits at a time.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Places {
    /// How much quick work runs.
    pub(crate) quick: usize,
    /// How much new work runs.
    pub(crate) new: usize,
    /// How much that is known to be slow is begun.
    pub(crate) slow: usize,
    /// How much more may turn out to be slow.
    pub(crate) spare: usize,
    /// How much may wait.
    pub(crate) waiting: usize,
}

impl Places {
    /// How much runs at most.
    pub(crate) fn all(self) -> usize {
        self.quick + self.new + self.slow + self.spare
    }

    /// How much of one client runs at most: a place is left for others.
    fn share(self) -> usize {
        self.all().saturating_sub(1).max(1)
    }
}

/// No more may wait.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Full;

#[derive(Debug)]
struct Running {
    client: Client,
    lane: Lane,
    row: Row,
    since: Instant,
}

impl Running {
    /// The lane that it counts in.
    fn lane(&self, now: Instant) -> Lane {
        if now.saturating_duration_since(self.since) >= SLICE { Lane::Slow } else { self.lane }
    }
}

/// One lane's work that waits: a line for each client, and whose turn it is.
#[derive(Debug)]
struct Lines<T> {
    turns: VecDeque<Client>,
    of: HashMap<Client, VecDeque<(Ticket, T)>>,
}

impl<T> Lines<T> {
    fn put(&mut self, client: Client, ticket: Ticket, work: T) {
        let line = self.of.entry(client).or_insert_with(|| {
            self.turns.push_back(client);
            VecDeque::new()
        });
        line.push_back((ticket, work));
    }

    /// The first piece of work of the next client in turn that may have one more place.
    fn take(&mut self, may: impl Fn(Client) -> bool) -> Option<(Client, Ticket, T)> {
        for _ in 0..self.turns.len() {
            let client = self.turns.pop_front()?;
            if !may(client) {
                self.turns.push_back(client);
                continue;
            }
            let line = self.of.get_mut(&client)?;
            let (ticket, work) = line.pop_front()?;
            if line.is_empty() {
                self.of.remove(&client);
            } else {
                self.turns.push_back(client);
            }
            return Some((client, ticket, work));
        }
        None
    }

    fn remove(&mut self, client: Client, ticket: Ticket) -> Option<T> {
        let line = self.of.get_mut(&client)?;
        let at = line.iter().position(|(waiting, _)| *waiting == ticket)?;
        let (_, work) = line.remove(at)?;
        if line.is_empty() {
            self.of.remove(&client);
            self.turns.retain(|other| *other != client);
        }
        Some(work)
    }
}

impl<T> Default for Lines<T> {
    fn default() -> Self {
        Self { turns: VecDeque::new(), of: HashMap::new() }
    }
}

/// All work that waits, and what is known of what runs.
#[derive(Debug)]
pub(super) struct Queue<T> {
    places: Places,
    quick: Lines<T>,
    new: Lines<T>,
    slow: Lines<T>,
    waiting: usize,
    running: HashMap<Ticket, Running>,
    next: u64,
}

impl<T> Queue<T> {
    pub(super) fn new(places: Places) -> Self {
        Self {
            places,
            quick: Lines::default(),
            new: Lines::default(),
            slow: Lines::default(),
            waiting: 0,
            running: HashMap::new(),
            next: 0,
        }
    }

    pub(super) fn waiting(&self) -> usize {
        self.waiting
    }

    pub(super) fn running(&self) -> usize {
        self.running.len()
    }

    /// Puts work in line.
    pub(super) fn put(&mut self, client: Client, work: impl FnOnce(Ticket) -> T) -> Result<Ticket, Full> {
        if self.waiting >= self.places.waiting {
            return Err(Full);
        }
        let ticket = Ticket(self.next);
        self.next = self.next.wrapping_add(1);
        self.quick.put(client, ticket, work(ticket));
        self.waiting += 1;
        Ok(ticket)
    }

    /// What a thread of a row shall run now, if there is a place for it. `leaves_quick` leaves quick work to others.
    pub(super) fn take(&mut self, now: Instant, row: Row, leaves_quick: bool) -> Option<(Ticket, T)> {
        let count = |lane: Lane| self.running.values().filter(|running| running.lane(now) == lane).count();
        let (quick, new, slow) = (count(Lane::Quick), count(Lane::New), count(Lane::Slow));
        let mut of: HashMap<Client, usize> = HashMap::new();
        self.running.values().for_each(|running| *of.entry(running.client).or_default() += 1);
        let Places { quick: most_quick, new: most_new, slow: most_slow, .. } = self.places;
        let all = self.places.all();
        let share = self.places.share();
        let may = |client: Client| of.get(&client).copied().unwrap_or(0) < share;
        let mut taken = None;
        if quick < most_quick && !leaves_quick {
            taken = self.quick.take(may).map(|found| (Lane::Quick, found));
        }
        // Places for quick work are left free, even where everything new turned out to be slow.
        let takes_all = row == Row::Back;
        if taken.is_none() && takes_all && new < most_new && new + slow + most_quick < all {
            taken = self.new.take(may).map(|found| (Lane::New, found));
        }
        if taken.is_none() && takes_all && slow < most_slow {
            taken = self.slow.take(may).map(|found| (Lane::Slow, found));
        }
        let (lane, (client, ticket, work)) = taken?;
        self.waiting -= 1;
        self.running.insert(ticket, Running { client, lane, row, since: now });
        Some((ticket, work))
    }

    /// Sets work that runs back: the rest of it waits in another lane.
    pub(super) fn set_back(&mut self, ticket: Ticket, lane: Lane, work: T) {
        if let Some(running) = self.running.remove(&ticket) {
            let lines = match lane {
                Lane::Quick => &mut self.quick,
                Lane::New => &mut self.new,
                Lane::Slow => &mut self.slow,
            };
            lines.put(running.client, ticket, work);
            self.waiting += 1;
        }
    }

    /// Work that ran runs no more. Tells where it ran, if it was known to run.
    pub(super) fn end(&mut self, ticket: Ticket) -> Option<Row> {
        self.running.remove(&ticket).map(|running| running.row)
    }

    /// Takes out work that waits.
    pub(super) fn remove(&mut self, client: Client, ticket: Ticket) -> Option<T> {
        let lines = [&mut self.quick, &mut self.new, &mut self.slow];
        let work = lines.into_iter().find_map(|lines| lines.remove(client, ticket))?;
        self.waiting -= 1;
        Some(work)
    }

    /// When the next work that runs will count as slow: a place is free then, though nothing has ended.
    pub(super) fn next_slow(&self, now: Instant) -> Option<Duration> {
        let left = |running: &Running| SLICE.saturating_sub(now.saturating_duration_since(running.since));
        self.running.values().filter(|running| running.lane(now) != Lane::Slow).map(left).min()
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "a test may fail")]

    use super::*;

    const A: Client = Client(1);
    const B: Client = Client(2);

    fn queue(quick: usize, slow: usize) -> Queue<&'static str> {
        Queue::new(Places { quick, new: 1, slow, spare: 0, waiting: 100 })
    }

    fn names(queue: &mut Queue<&'static str>, now: Instant) -> Vec<&'static str> {
        std::iter::from_fn(|| queue.take(now, Row::Back, false).map(|(_, work)| work)).collect()
    }

    #[test]
    fn clients_take_turns() {
        let mut queue = queue(1, 0);
        let now = Instant::now();
        for _ in 0..3 {
            queue.put(A, |_| "a").unwrap();
        }
        queue.put(B, |_| "b").unwrap();
        let mut order = Vec::new();
        while let Some((ticket, work)) = queue.take(now, Row::Back, false) {
            order.push(work);
            assert!(queue.end(ticket).is_some());
        }
        assert_eq!(order, ["a", "b", "a", "a"]);
        assert_eq!((queue.waiting(), queue.running()), (0, 0));
    }

    #[test]
    fn no_client_has_all_places() {
        let mut queue = queue(3, 0);
        let now = Instant::now();
        // Four places in all: three of one client.
        for _ in 0..9 {
            queue.put(A, |_| "a").unwrap();
        }
        assert_eq!(names(&mut queue, now), ["a", "a", "a"]);
        queue.put(B, |_| "b").unwrap();
        assert_eq!(names(&mut queue, now + SLICE), ["b"]);
    }

    #[test]
    fn what_turns_out_slow_gives_its_place_back() {
        let mut queue = queue(1, 1);
        let now = Instant::now();
        queue.put(A, |_| "endless").unwrap();
        queue.put(B, |_| "small").unwrap();
        assert_eq!(names(&mut queue, now), ["endless"]);
        assert_eq!(queue.next_slow(now), Some(SLICE));
        assert_eq!(names(&mut queue, now + SLICE), ["small"]);
    }

    #[test]
    fn what_is_known_to_be_slow_waits_in_its_own_lane() {
        let mut queue = queue(2, 1);
        let now = Instant::now();
        let mut tickets = Vec::new();
        for client in 10..20 {
            queue.put(Client(client), |_| "slow").unwrap();
            let (ticket, work) = queue.take(now, Row::Back, false).unwrap();
            queue.set_back(ticket, Lane::Slow, work);
            tickets.push((Client(client), ticket));
        }
        assert_eq!(names(&mut queue, now), ["slow"], "one place");
        queue.put(B, |_| "small").unwrap();
        assert_eq!(names(&mut queue, now), ["small"]);
        assert_eq!(queue.waiting(), 9);
        let (client, ticket) = tickets[5];
        assert!(queue.remove(client, ticket).is_some() && queue.remove(client, ticket).is_none());
        assert_eq!(queue.waiting(), 8);
        assert!(queue.end(tickets[0].1).is_some());
        assert_eq!(names(&mut queue, now), ["slow"]);
    }

    #[test]
    fn what_is_new_never_has_all_places() {
        let mut queue: Queue<&'static str> =
            Queue::new(Places { quick: 1, new: 2, slow: 1, spare: 1, waiting: 100 });
        let mut now = Instant::now();
        for client in 0..20 {
            queue.put(Client(client), |_| "new").unwrap();
            let (ticket, work) = queue.take(now, Row::Back, false).unwrap();
            queue.set_back(ticket, Lane::New, work);
        }
        // All of it turns out to be slow, two at a time: four of five places are taken in the end.
        assert_eq!(names(&mut queue, now), ["new", "new"]);
        now += SLICE;
        assert_eq!(names(&mut queue, now), ["new", "new"]);
        now += SLICE;
        assert!(names(&mut queue, now).is_empty());
        queue.put(Client(99), |_| "small").unwrap();
        assert_eq!(names(&mut queue, now), ["small"]);
    }

    #[test]
    fn only_so_much_waits() {
        let mut queue: Queue<()> = Queue::new(Places { quick: 1, new: 1, slow: 1, spare: 0, waiting: 2 });
        queue.put(A, |_| ()).unwrap();
        queue.put(A, |_| ()).unwrap();
        assert_eq!(queue.put(B, |_| ()), Err(Full));
    }

    #[test]
    fn in_front_only_quick_work_is_done() {
        let mut queue = queue(1, 1);
        let now = Instant::now();
        queue.put(A, |_| "slow").unwrap();
        let (ticket, work) = queue.take(now, Row::Front, false).unwrap();
        queue.set_back(ticket, Lane::Slow, work);
        queue.put(B, |_| "quick").unwrap();
        let (slow, _) = queue.take(now, Row::Back, true).unwrap();
        assert_eq!(slow, ticket);
        assert!(queue.take(now, Row::Back, true).is_none(), "somebody in front is free");
        let (quick, work) = queue.take(now, Row::Front, false).unwrap();
        assert_eq!(work, "quick");
        assert_eq!(
            (queue.end(slow), queue.end(quick), queue.end(quick)),
            (Some(Row::Back), Some(Row::Front), None)
        );
        queue.put(B, |_| "quick").unwrap();
        assert!(queue.take(now, Row::Back, false).is_some(), "nobody in front is free");
    }
}
