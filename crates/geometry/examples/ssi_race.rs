//! Answers for pairs of surfaces, one a line, for `benches/ssi_race.py`, which races another kernel in turns.
//!
//! ```text
//! cargo run --release -p katydid-geometry --example ssi_race -- FILE
//! ```
//!
//! FILE is JSON with a list `cases` of pairs `a` and `b`. Each line of the input is the index of a pair; the answer is the
//! number of closed and of open branches, their length, whether the search came to its end, and the milliseconds.

#[path = "oracle/read.rs"]
#[allow(dead_code, reason = "shared with another example")]
mod read;

use std::io::{BufRead, Write};
use std::time::Instant;

use katydid_geometry::{Tolerance, intersect};
use serde_json::Value;

type Failure = Box<dyn std::error::Error>;

/// The distance within which curves are wanted, as a part of the size.
const WITHIN: f64 = 1e-6;

fn main() -> Result<(), Failure> {
    let file = std::env::args().nth(1).ok_or("usage: ssi_race FILE")?;
    let all: Value = serde_json::from_str(&std::fs::read_to_string(file)?)?;
    let mut out = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        let index: usize = line?.trim().parse()?;
        let case = &all["cases"][index];
        let (a, b) = (read::surface(&case["a"])?, read::surface(&case["b"])?);
        let size = a.hull_box().diagonal().length().min(b.hull_box().diagonal().length());
        let tolerance = Tolerance { absolute: WITHIN * size, ..Tolerance::default() };
        let start = Instant::now();
        let met = intersect::surface_surface(&a, &b, &tolerance)?;
        let took = 1e3 * start.elapsed().as_secs_f64();
        let closed = met.branches.iter().filter(|b| b.closed).count();
        let length: f64 = met.branches.iter().map(|b| b.curve.length()).sum();
        writeln!(out, "{closed} {} {length} {} {took}", met.branches.len() - closed, met.complete)?;
        out.flush()?;
    }
    Ok(())
}
