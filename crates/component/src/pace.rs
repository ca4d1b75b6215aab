//! How often a loop looks at the clock.

use std::time::Duration;

use web_time::Instant;

/// The most steps between two looks: a step may be long that comes after short ones.
const MOST: u32 = 64;
/// Looks come closer together when more than this lies between them, and farther apart when less than half of it does.
const APART: Duration = Duration::from_millis(2);

/// Tells a loop at which of its steps to ask whether to go on: at each when steps are long, at every 64th when they are
/// so short that the look at the clock would cost more than they do.
#[derive(Debug)]
pub(crate) struct Pace {
    left: u32,
    every: u32,
    looked: Instant,
}

impl Default for Pace {
    fn default() -> Self {
        Self { left: 1, every: 1, looked: Instant::now() }
    }
}

impl Pace {
    /// Whether to ask before the next step.
    #[inline]
    pub(crate) fn is_due(&mut self) -> bool {
        self.left -= 1;
        if self.left > 0 {
            return false;
        }
        let now = Instant::now();
        self.every = next(self.every, now - self.looked);
        self.looked = now;
        self.left = self.every;
        true
    }
}

/// The number of steps between looks, when so many took so long.
fn next(every: u32, took: Duration) -> u32 {
    if took > APART {
        // As many as would have taken that long.
        let fitting = APART.as_secs_f64() / took.as_secs_f64() * f64::from(every);
        (fitting as u32).max(1)
    } else if took < APART / 2 {
        (2 * every).min(MOST)
    } else {
        every
    }
}

#[cfg(all(test, not(target_family = "wasm")))]
mod tests {
    use super::*;

    #[test]
    fn long_steps_are_looked_at_one_by_one() {
        let millis = Duration::from_millis;
        assert_eq!(next(1, millis(30)), 1);
        assert_eq!(next(64, millis(64)), 2);
        assert_eq!(next(64, millis(64_000)), 1);
        assert_eq!(next(8, Duration::from_micros(1500)), 8);
        assert_eq!(next(8, Duration::ZERO), 16);
        assert_eq!(next(64, Duration::ZERO), 64);
        let mut pace = Pace::default();
        let due = (0..1000).filter(|_| pace.is_due()).count();
        assert!(due >= 1000 / MOST as usize, "{due}");
    }
}
