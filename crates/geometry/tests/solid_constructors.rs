//! Every constructor gives sound breps or says why not, over random and degenerate inputs.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a failing assertion is how a test reports")]

mod solid_cases;

use std::panic::{AssertUnwindSafe, catch_unwind};

use solid_cases::random::Random;
use solid_cases::{TOLERANCE, cases};

/// Inputs for each constructor; 1,000 when the whole set is asked for.
fn count() -> u64 {
    std::env::var("SOLID_CASES").ok().and_then(|n| n.parse().ok()).unwrap_or(100)
}

#[test]
fn results_are_valid_or_refused() {
    let only = std::env::var("SOLID_CASE").ok();
    for (name, make) in cases() {
        if only.as_ref().is_some_and(|only| only != name) {
            continue;
        }
        let (mut good, mut refused, mut solid) = (0, 0, 0);
        let begun = std::time::Instant::now();
        let mut why = std::collections::BTreeMap::<String, usize>::new();
        for seed in 0..count() {
            if std::env::var("SOLID_WHY").is_ok_and(|x| x == "2") {
                println!("    seed {seed}, {:?}", begun.elapsed());
            }
            let made = catch_unwind(AssertUnwindSafe(|| make(&mut Random(seed))));
            let Ok(made) = made else { panic!("{name}, seed {seed}: panicked") };
            match made {
                Ok(breps) => {
                    for brep in breps {
                        let faults = brep.faults();
                        assert!(faults.is_empty(), "{name}, seed {seed}: {faults:?}");
                        for edge in 0..brep.edges().len() {
                            let apart = brep.edge_deviation(edge).unwrap();
                            assert!(
                                apart <= 2.0 * TOLERANCE.absolute,
                                "{name}, seed {seed}: edge {edge} is {apart} off"
                            );
                        }
                        good += 1;
                        solid += usize::from(brep.is_solid());
                    }
                }
                Err(error) => {
                    refused += 1;
                    let text: String =
                        error.to_string().chars().filter(|c| !c.is_ascii_digit()).take(90).collect();
                    if std::env::var("SOLID_WHY").is_ok_and(|x| !x.is_empty()) {
                        println!("    {seed}: {error}");
                    }
                    *why.entry(text).or_default() += 1;
                }
            }
        }
        println!("{name}: {good} breps, {solid} of them solid, {refused} refused, {:?}", begun.elapsed());
        for (text, times) in why {
            println!("    {times} × {text}");
        }
        assert!(good > 0, "{name} never gave anything");
    }
}
