//! Cuts solids of archives by each other, and asks the laws of volumes and points inside of every answer:
//! `cut_solids ARCHIVE…`
//!
//! Each archive holds two solids, as `benches/boolean_real.py` writes them with `--pairs FOLDER`. Their common part, both
//! differences and their union are asked for, within the tolerance of the archive. Said of every refusal and of every answer
//! that breaks a law; at the end how many of each kind there are. The exit status is 1 when a law is broken.

#![allow(clippy::print_stdout, reason = "an example speaks")]

use std::collections::BTreeMap;
use std::process::ExitCode;
use std::time::Instant;

use katydid_3dm::{Limits, Model, Object};
use katydid_geometry::{Brep, Error};

use laws::{Answers, broken};

mod laws;

#[derive(Default)]
struct Counts {
    pairs: usize,
    /// Answers of the common part and of the first difference: what the race with another kernel counts.
    answered: usize,
    refused: BTreeMap<&'static str, usize>,
    /// Pairs of which any of the four operations is refused.
    refused_pairs: usize,
    broken: usize,
    seconds: f64,
}

fn main() -> ExitCode {
    let mut counts = Counts::default();
    for path in std::env::args().skip(1) {
        match pair(&path) {
            Ok((first, second, tolerance)) => judge(&path, [&first, &second], tolerance, &mut counts),
            Err(why) => println!("{path}: {why}"),
        }
    }
    let Counts { pairs, answered, refused, refused_pairs, broken, seconds } = counts;
    println!("{pairs} pairs in {seconds:.1} s: {answered} of {} operations answered", 2 * pairs);
    println!("{refused_pairs} pairs with a refusal, {broken} broken laws");
    for (class, count) in refused {
        println!("{count:6} {class}");
    }
    if broken == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The two solids of an archive, and its tolerance.
fn pair(path: &str) -> Result<(Brep, Brep, f64), String> {
    let bytes = std::fs::read(path).map_err(|e| e.to_string())?;
    let model = Model::read(&bytes, &Limits::default()).map_err(|e| e.to_string())?;
    let tolerance = model.tolerance.absolute;
    let mut solids = model.objects.into_iter().filter_map(|object| match object.geometry {
        Object::Brep(b) => Some(b.brep),
        Object::Extrusion(e) => Some(e.to_brep()?.brep),
        _ => None,
    });
    match (solids.next(), solids.next(), solids.next()) {
        (Some(first), Some(second), None) => Ok((first, second, tolerance)),
        _ => Err("it does not hold two solids".into()),
    }
}

fn judge(path: &str, solids: [&Brep; 2], tolerance: f64, counts: &mut Counts) {
    let start = Instant::now();
    let answers = Answers::of(solids, tolerance);
    let seconds = start.elapsed().as_secs_f64();
    counts.pairs += 1;
    counts.seconds += seconds;
    let mut any = false;
    for (k, (name, answer)) in answers.named().into_iter().enumerate() {
        match answer {
            Ok(_) => counts.answered += usize::from(k < 2),
            Err(why) => {
                any = true;
                let class = match why {
                    Error::Refused(refusal) => refusal.class.words(),
                    _ => "another error",
                };
                *counts.refused.entry(class).or_default() += usize::from(k < 2);
                println!("{path}: {name}: {why}");
            }
        }
    }
    counts.refused_pairs += usize::from(any);
    for law in broken(solids, &answers, tolerance) {
        counts.broken += 1;
        println!("{path}: BROKEN {law}");
    }
    if seconds > 20.0 {
        println!("{path}: {seconds:.1} s");
    }
}
