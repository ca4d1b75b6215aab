//! Clients of every sort for a time.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::Outcome;
use crate::cases::Chance;
use crate::client::Client;
use crate::misuse::{Came, DEEDS, Site, judged};
use crate::share::milliseconds;

/// What came of one sort of turns.
#[derive(Debug, Default)]
struct Tally {
    right: usize,
    wrong: usize,
    refused: usize,
    /// Those that were not answered.
    broken: usize,
    /// The first thing that was not as it should be.
    first: Option<String>,
}

impl Tally {
    fn add(&mut self, came: Outcome<Came>) {
        let fault = match came {
            Ok(Came::Right) => return self.right += 1,
            Ok(Came::Refused) => return self.refused += 1,
            Ok(Came::Wrong(status)) => {
                self.wrong += 1;
                format!("status {status}")
            }
            Err(error) => {
                self.broken += 1;
                error.to_string()
            }
        };
        self.first.get_or_insert(fault);
    }

    fn merge(&mut self, other: Self) {
        self.right += other.right;
        self.wrong += other.wrong;
        self.refused += other.refused;
        self.broken += other.broken;
        self.first = self.first.take().or(other.first);
    }

    fn told(&self) -> Value {
        let Self { right, wrong, refused, broken, first } = self;
        json!({"right": right, "wrong": wrong, "refused": refused, "broken": broken, "first": first})
    }
}

/// What one client saw.
#[derive(Default)]
struct Seen {
    tallies: BTreeMap<&'static str, Tally>,
    /// How long answers took to those who only asked and waited.
    times: Vec<Duration>,
}

/// The name of the turns of those who ask and wait.
const SOLVES: &str = "solves";

pub(crate) fn soak(site: &Site<'_>, clients: usize, time: Duration) -> Value {
    let start = Instant::now();
    let mut all = Seen::default();
    std::thread::scope(|scope| {
        let threads: Vec<_> =
            (0..clients).map(|own| scope.spawn(move || client(site, own, start, time))).collect();
        for thread in threads {
            let Ok(seen) = thread.join() else {
                all.tallies.entry(SOLVES).or_default().add(Err("a client failed".into()));
                continue;
            };
            all.times.extend(seen.times);
            for (name, tally) in seen.tallies {
                all.tallies.entry(name).or_default().merge(tally);
            }
        }
    });
    let seconds = start.elapsed().as_secs_f64();
    all.times.sort();
    let percentiles: Vec<f64> =
        [0.5, 0.95, 0.99, 0.999, 1.0].iter().map(|part| milliseconds(&all.times, *part)).collect();
    let tallies: BTreeMap<_, _> = all.tallies.iter().map(|(name, tally)| (*name, tally.told())).collect();
    json!({
        "seconds": seconds, "solves": all.times.len(), "rate": all.times.len() as f64 / seconds,
        "p50_p95_p99_p999_most_ms": percentiles, "turns": tallies,
    })
}

/// One client, until the time is over.
fn client(site: &Site<'_>, own: usize, start: Instant, time: Duration) -> Seen {
    let mut seen = Seen::default();
    let mut chance = Chance::new(7919 * (own + 1));
    let mut connection = None;
    while start.elapsed() < time {
        let mut turn = chance.below(1000);
        let deed = DEEDS.iter().find(|deed| {
            let is_now = turn < deed.turns;
            turn = turn.wrapping_sub(deed.turns);
            is_now
        });
        match deed {
            Some(deed) => seen.tallies.entry(deed.name).or_default().add((deed.run)(site, &mut chance)),
            None => {
                let from = Instant::now();
                let came = asked(site, &mut connection, &mut chance);
                if came.is_ok() {
                    seen.times.push(from.elapsed());
                }
                seen.tallies.entry(SOLVES).or_default().add(came);
            }
        }
    }
    seen
}

/// Asks over a connection that stays; a new one when the last answer did not come.
fn asked(site: &Site<'_>, connection: &mut Option<Client>, chance: &mut Chance) -> Outcome<Came> {
    let case = site.case(chance)?;
    let mut client = match connection.take() {
        Some(client) => client,
        None => Client::new(site.host)?,
    };
    let answer = client.ask(&case.request)?;
    *connection = Some(client);
    Ok(judged(case, &answer))
}
