//! Every constructor gives sound breps or says why not, over random and degenerate inputs of all sizes.
//!
//! `KATYDID_CASES=1000 cargo test --release -p katydid-geometry --test solid_constructors -- --nocapture` runs a thousand
//! seeds of each; `KATYDID_CASE="variable pipe,join"` those of some constructors, with the reasons of refusals;
//! `KATYDID_SEED=831` one seed alone.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

mod solid_cases;

use std::collections::BTreeMap;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::{Duration, Instant};

use katydid_geometry::{Brep, Error, Result};
use solid_cases::random::Random;
use solid_cases::{Case, TOLERANCE, cases, count};

/// How long the area of a face is looked for.
const LOOK: Duration = Duration::from_millis(200);

/// What is wrong with a brep that a constructor gave.
fn wrong(brep: &Brep) -> Vec<String> {
    let mut wrong: Vec<String> = brep.faults().iter().map(|fault| fault.to_string()).collect();
    for edge in 0..brep.edges().len() {
        let Some(apart) = brep.edge_deviation(edge) else { continue };
        if apart.is_nan() || apart > 2.0 * TOLERANCE.absolute {
            wrong.push(format!("edge {edge} is {apart} off"));
        }
    }
    for face in 0..brep.faces().len() {
        let begun = Instant::now();
        let area =
            brep.sub_brep(&[face]).and_then(|face| face.area_properties(1e-2, || begun.elapsed() < LOOK));
        match area {
            Ok(area) if area.amount > 0.0 && area.amount.is_finite() => {}
            Ok(area) => wrong.push(format!("face {face} has an area of {}", area.amount)),
            // A sliver may take more work than it is worth.
            Err(Error::Stopped | Error::Invalid { what: "integral", .. }) => {}
            Err(error) => wrong.push(format!("face {face} has no area: {error}")),
        }
    }
    wrong
}

/// What came of the seeds of one constructor.
#[derive(Default)]
struct Tally {
    good: usize,
    solid: usize,
    /// How often each reason was given, and for which seed first.
    refused: BTreeMap<String, (usize, u64)>,
    wrong: Vec<String>,
    slowest: (Duration, u64),
}

impl Tally {
    fn add(&mut self, seed: u64, made: Result<Vec<Brep>>) {
        match made {
            Ok(breps) => {
                for brep in breps {
                    self.wrong.extend(wrong(&brep).into_iter().map(|why| format!("seed {seed}: {why}")));
                    self.good += 1;
                    self.solid += usize::from(brep.is_solid());
                }
            }
            Err(error) => self.refused.entry(reason(&error)).or_insert((0, seed)).0 += 1,
        }
    }
}

/// An error without its numbers.
fn reason(error: &Error) -> String {
    error.to_string().chars().filter(|c| !c.is_ascii_digit()).take(90).collect()
}

fn tally((_, make): &Case, seeds: Range<u64>) -> Tally {
    let mut tally = Tally::default();
    for seed in seeds {
        let begun = Instant::now();
        let made = catch_unwind(AssertUnwindSafe(|| make(&mut Random::of(seed))));
        tally.slowest = tally.slowest.max((begun.elapsed(), seed));
        match made {
            Ok(made) => tally.add(seed, made),
            Err(_) => tally.wrong.push(format!("seed {seed}: it panicked")),
        }
    }
    tally
}

#[test]
fn results_are_valid_or_refused() {
    let only = std::env::var("KATYDID_CASE").ok();
    let one: Option<u64> = std::env::var("KATYDID_SEED").ok().and_then(|seed| seed.parse().ok());
    let seeds = one.map_or(0..count(12), |seed| seed..seed + 1);
    let mut wrong = Vec::new();
    for case in cases() {
        let name = case.0;
        if only.as_ref().is_some_and(|only| only.split(',').all(|wanted| wanted != name)) {
            continue;
        }
        let tally = tally(&case, seeds.clone());
        let refused: usize = tally.refused.values().map(|(times, _)| times).sum();
        println!(
            "{name}: {} breps, {} of them solid, {refused} inputs refused, {} wrong, slowest seed {} with {:?}",
            tally.good,
            tally.solid,
            tally.wrong.len(),
            tally.slowest.1,
            tally.slowest.0
        );
        for (text, (times, seed)) in
            tally.refused.iter().filter(|_| only.is_some() || seeds.end - seeds.start > 100)
        {
            println!("    {times} × {text} (seed {seed})");
        }
        for why in tally.wrong.iter().take(12) {
            println!("    {why}");
        }
        wrong.extend(tally.wrong.into_iter().map(|why| format!("{name}, {why}")));
        if tally.good == 0 && one.is_none() {
            wrong.push(format!("{name} never gave anything"));
        }
    }
    assert!(wrong.is_empty(), "{} wrong: {:#?}", wrong.len(), wrong.iter().take(20).collect::<Vec<_>>());
}
