//! Times of several contenders, taken in turns so that a busy machine is busy for all of them.

use std::time::{Duration, Instant};

/// One way to do an operation.
pub struct Contender<'a> {
    /// Whose it is.
    pub name: &'static str,
    /// Does it once for a whole batch.
    pub run: Box<dyn FnMut() + 'a>,
    /// How many items a batch has.
    pub items: usize,
    times: Vec<f64>,
    repeats: u32,
}

impl<'a> Contender<'a> {
    /// A contender that does `items` at a time.
    pub fn new(name: &'static str, items: usize, run: impl FnMut() + 'a) -> Self {
        Self { name, run: Box::new(run), items: items.max(1), times: Vec::new(), repeats: 1 }
    }

    fn time(&mut self) -> Duration {
        let start = Instant::now();
        for _ in 0..self.repeats {
            (self.run)();
        }
        start.elapsed()
    }

    /// The time of an item in nanoseconds: the lower quartile of all turns, which a machine that is busy now and then
    /// moves less than the median.
    pub fn typical(&self) -> f64 {
        let mut times = self.times.clone();
        times.sort_by(f64::total_cmp);
        times.get(times.len() / 4).copied().unwrap_or(f64::NAN)
    }
}

/// Lets the contenders run in turns, `rounds` times each, every turn some `turn` long at least.
pub fn compete(contenders: &mut [Contender<'_>], rounds: usize, turn: Duration) {
    for c in contenders.iter_mut() {
        // The first run warms the caches up, the second says how many fill a turn.
        c.time();
        let once = c.time().max(Duration::from_nanos(50));
        c.repeats = (turn.as_nanos() / once.as_nanos()).clamp(1, 1_000_000) as u32;
    }
    for _ in 0..rounds {
        for c in contenders.iter_mut() {
            let time = c.time();
            c.times.push(time.as_secs_f64() * 1e9 / f64::from(c.repeats) / c.items as f64);
        }
    }
}
