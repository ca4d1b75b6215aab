//! Compares the booleans of the kernel with the answers of other kernels and with closed forms, case by case.
//!
//! ```text
//! cargo run --release -p katydid-geometry --example booleans -- [--only TEXT] [--all] [--variants] FILE.json…
//! ```
//!
//! `--variants` looks at each case again with its operands swapped, rotated, scaled, moved, as NURBS and nudged: it must
//! be right or refused there too.
//!
//! Each file is one JSON object with a list `cases`: steps that build shapes, and for some steps the area, the volume and
//! the counts of parts that are right. Each disagreement is printed with its class: `WRONG` for a result that is another,
//! `COUNT` for one that differs in counts of parts alone, `refused` for an error, `not built` for a step that is not
//! known. The exit status is 1 when a case is not right, 2 when a file cannot be read.
//!
//! What counts as agreement: volumes and areas within 1e-6 of those of the largest operand.

mod cells;
mod compare;
mod read;
mod shapes;
mod solids;
mod variant;

use std::collections::BTreeMap;
use std::process::ExitCode;

use serde_json::Value;

use compare::Verdict;
use variant::{VARIANTS, Variant};

/// What was asked for.
struct Asked {
    only: Option<String>,
    all: bool,
    variants: Vec<(&'static str, Variant)>,
}

impl Default for Asked {
    fn default() -> Self {
        Self { only: None, all: false, variants: vec![("", Variant::Plain)] }
    }
}

fn main() -> ExitCode {
    let mut files = Vec::new();
    let mut asked = Asked::default();
    let mut arguments = std::env::args().skip(1);
    while let Some(argument) = arguments.next() {
        match argument.as_str() {
            "--only" => asked.only = arguments.next(),
            "--all" => asked.all = true,
            "--variants" => asked.variants = VARIANTS.to_vec(),
            _ => files.push(argument),
        }
    }
    if files.is_empty() {
        eprintln!("usage: booleans [--only TEXT] [--all] [--variants] FILE.json…");
        return ExitCode::from(2);
    }
    let mut sound = true;
    for file in &files {
        match run(file, &asked) {
            Ok(right) => sound &= right,
            Err(why) => {
                eprintln!("{file}: {why}");
                return ExitCode::from(2);
            }
        }
    }
    if sound { ExitCode::SUCCESS } else { ExitCode::from(1) }
}

/// Whether all cases of a file are right.
fn run(file: &str, asked: &Asked) -> Result<bool, String> {
    let text = std::fs::read_to_string(file).map_err(|e| e.to_string())?;
    let data: Value = serde_json::from_str(&text).map_err(|e| e.to_string())?;
    let cases = data["cases"].as_array().ok_or("it has no list of cases")?;
    let mut sound = true;
    for (name, variant) in &asked.variants {
        sound &= pass(cases, asked, name, *variant);
    }
    Ok(sound)
}

/// Whether all cases are right in a variant.
fn pass(cases: &[Value], asked: &Asked, name: &str, variant: Variant) -> bool {
    let mut counts: BTreeMap<&'static str, usize> = BTreeMap::new();
    let mut classes: BTreeMap<String, usize> = BTreeMap::new();
    let mut number = 0;
    for case in cases {
        let id = case["id"].as_str().unwrap_or("?");
        if asked.only.as_deref().is_some_and(|only| !id.contains(only)) {
            continue;
        }
        number += 1;
        let start = std::time::Instant::now();
        let verdict = compare::case(case, variant);
        let seconds = start.elapsed().as_secs_f64();
        *counts.entry(verdict.class()).or_default() += 1;
        if seconds > 2.0 {
            println!("slow      {id}: {seconds:.1} s");
        }
        match &verdict {
            Verdict::Right if asked.all => println!("right     {id}: {:.2} ms", 1e3 * seconds),
            Verdict::Right => {}
            other => {
                println!("{:<9} {id}: {}", other.class(), other.why());
                let why = other.why();
                let kind = why.split([':', ',']).nth(usize::from(why.contains("refused"))).unwrap_or(why);
                *classes.entry(format!("{} {}", other.class(), kind.trim())).or_default() += 1;
            }
        }
    }
    for (class, count) in &classes {
        if *count > 1 {
            println!("{count:>6} × {class}");
        }
    }
    let right = counts.get("right").copied().unwrap_or(0);
    let others: Vec<String> =
        counts.iter().filter(|(k, _)| **k != "right").map(|(k, n)| format!("{n} {k}")).collect();
    let name = if name.is_empty() { String::new() } else { format!("{name}: ") };
    println!("{name}{right} of {number} cases right; {}", others.join(", "));
    right == number
}
