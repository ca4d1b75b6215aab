//! So many solves by so many clients, each of which asks again as soon as it is answered.

use std::time::{Duration, Instant};

use serde_json::{Value, json};

use crate::Outcome;
use crate::cases::{Case, Chance};
use crate::client::Client;
use crate::share::{at, milliseconds};

/// What one client saw.
#[derive(Default)]
struct Seen {
    /// How long each answer took.
    times: Vec<Duration>,
    /// What of it was not the solve, in milliseconds.
    beyond: Vec<f64>,
    /// How many answers were not those of `katydid run`.
    wrong: usize,
}

pub(crate) fn measure(host: &str, cases: &[Case], clients: usize, solves: usize) -> Outcome<Value> {
    let start = Instant::now();
    let done: Vec<Outcome<Seen>> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..clients)
            .map(|own| {
                scope.spawn(move || -> Outcome<Seen> {
                    let mut client = Client::new(host)?;
                    let mut seen = Seen::default();
                    for turn in (own..solves).step_by(clients) {
                        let Some(case) = cases.get(Chance::new(turn + 1).below(cases.len())) else {
                            continue;
                        };
                        let from = Instant::now();
                        let answer = client.ask(&case.request)?;
                        let took = from.elapsed();
                        seen.times.push(took);
                        seen.beyond.push(took.as_secs_f64() * 1e3 - answer.solve);
                        seen.wrong += usize::from(!case.is_right(&answer.body));
                    }
                    Ok(seen)
                })
            })
            .collect();
        threads
            .into_iter()
            .map(|thread| thread.join().unwrap_or_else(|_| Err("a client failed".into())))
            .collect()
    });
    let seconds = start.elapsed().as_secs_f64();
    let Seen { mut times, mut beyond, mut wrong } = Seen::default();
    for one in done {
        let own = one?;
        times.extend(own.times);
        beyond.extend(own.beyond);
        wrong += own.wrong;
    }
    times.sort();
    beyond.sort_by(f64::total_cmp);
    let extra = |part: f64| at(&beyond, part).copied().unwrap_or(0.0);
    Ok(json!({
        "solves": times.len(), "wrong": wrong, "seconds": seconds, "rate": times.len() as f64 / seconds,
        "median_ms": milliseconds(&times, 0.5), "p99_ms": milliseconds(&times, 0.99),
        "beyond_median_ms": extra(0.5), "beyond_p95_ms": extra(0.95),
    }))
}
